// A whole footprint against many obstacles.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "footprint_collision_predictor/time_to_collision.hpp"

namespace footprint_collision_predictor::core {

/// The first contact of one segment, and with which obstacle.
struct SegmentContact {
  Contact contact;
  std::size_t obstacle;  ///< index into the obstacles
};

/// The first contact of the footprint.
struct FootprintContact {
  Contact contact;
  std::size_t segment;   ///< the segment touched; the lower index on a corner
  std::size_t obstacle;  ///< index into the obstacles
  double closing_speed;  ///< [m/s] >= 0 along the contact normal at contact; 0 when separating
};

struct Prediction {
  /// One for each footprint segment, in the footprint's order; nothing where none is touched. Among
  /// obstacles that touch at the same time, the one with the smaller gap now, then the lower index.
  std::vector<std::optional<SegmentContact>> segments;
  /// The footprint is solid: an obstacle wholly inside is a contact at 0 with the nearest segment,
  /// although that segment's own contact may come later or never.
  std::optional<FootprintContact> first;
  /// Smallest gap at t = 0 [m]: signed distance from a centre to the boundary (negative inside)
  /// minus the radius. Nothing without obstacles.
  std::optional<double> clearance;
};

/// Predicts the first contact of every footprint segment and of the footprint.
///
/// \param footprint in its own frame
/// \param twist of the footprint; its yaw rate is not used, so the caller must have made sure by
///     turningEffect() that it does not matter
/// \param obstacles in the footprint's frame at t = 0
/// \param horizon [s] in [0, kMaxHorizon]; 0 asks only for what touches now
Prediction predict(const Polygon& footprint, const Twist& twist,
                   const std::vector<Obstacle>& obstacles, double horizon);

}  // namespace footprint_collision_predictor::core
