// A whole footprint against one obstacle, and against many.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "footprint_collision_predictor/obstacle_batch.hpp"
#include "footprint_collision_predictor/time_to_collision.hpp"

namespace footprint_collision_predictor::core {

/// The first contact of the footprint with one obstacle or the first of many.
struct FootprintContact {
  Contact contact;
  std::size_t segment;   ///< the segment touched; the lower index on a corner
  std::size_t obstacle;  ///< index into the obstacles
  /// [m/s] >= 0 along the contact normal at contact, of the motions alone: what a growing radius
  /// adds is not a speed of anything; 0 when separating
  double closing_speed;
};

/// First contact of the footprint with one obstacle.
///
/// The footprint is solid: an obstacle wholly inside is a contact at 0 with the nearest segment,
/// and so is a footprint wholly inside a polygon.
///
/// \param footprint in its own frame
/// \param twist of the footprint over ground
/// \param obstacle over ground, in the footprint's frame at t = 0
/// \param horizon [s] in [0, kMaxHorizon]; 0 asks only for what touches now
std::optional<FootprintContact> firstContact(const Polygon& footprint, const Twist& twist,
                                             const Obstacle& obstacle, double horizon);

/// The first contact of one segment, and with which obstacle.
struct SegmentContact {
  Contact contact;
  std::size_t obstacle;  ///< index into the obstacles
};

/// First contact of the footprint with any of the obstacles: what firstContact() gives for the one
/// that comes first. Among obstacles that touch at the same time, the one with the smaller gap now,
/// then the lower index. Times that differ by no more than the guarantee leaves open may be told
/// either way round.
std::optional<FootprintContact> firstContact(const Polygon& footprint, const Twist& twist,
                                             const ObstacleBatch& obstacles, double horizon);

/// First contact of each footprint segment with any of the obstacles, by the rule of
/// timeToCollision(): nothing where a segment is not touched.
///
/// \param contacts one for each segment, in the footprint's order; what was in it is replaced
void firstContacts(const Polygon& footprint, const Twist& twist, const ObstacleBatch& obstacles,
                   double horizon, std::vector<std::optional<SegmentContact>>* contacts);

/// The smallest gap within the horizon, and when it is.
struct ClosestApproach {
  double distance;  ///< [m] >= 0, to 1e-6 m; 0 when there is a contact
  double time;      ///< [s] in [0, horizon]; of the contact when there is one
};

struct Prediction {
  /// As firstContacts() has them.
  std::vector<std::optional<SegmentContact>> segments;
  /// As firstContact() has it.
  std::optional<FootprintContact> first;
  /// Smallest gap at t = 0 [m]: signed distance from an obstacle's centre or outline to the
  /// boundary (negative where one is inside the other) minus the radius. Nothing without obstacles.
  std::optional<double> clearance;
  /// Nothing without obstacles.
  std::optional<ClosestApproach> closest;
};

/// Everything there is to say about a footprint among obstacles; the parameters are those of
/// firstContact().
Prediction predict(const Polygon& footprint, const Twist& twist,
                   const std::vector<Obstacle>& obstacles, double horizon);

}  // namespace footprint_collision_predictor::core
