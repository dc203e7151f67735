// A footprint among many obstacles: the broad phase throws most of them away, the narrow phase
// answers for the others. What is found narrows the question: nothing later than the first contact
// known is of interest, nor any gap larger than the smallest one known.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "broad_phase.hpp"
#include "footprint_collision_predictor/predictor.hpp"
#include "shape.hpp"

namespace footprint_collision_predictor::core {

/// What is asked, and which instructions to answer it with: the answer does not depend on these.
struct BatchQuery {
  const Polygon& footprint;
  const Twist& twist;
  const ObstacleBatch& obstacles;
  double horizon;  ///< [s]
  InstructionSet set = widestInstructionSet();
};

/// As predictor.hpp has it.
std::optional<FootprintContact> firstContact(const BatchQuery& q);

/// As predictor.hpp has it.
void firstContacts(const BatchQuery& q, std::vector<std::optional<SegmentContact>>* contacts);

/// An obstacle, and how it lies to the footprint now.
struct NearestObstacle {
  std::size_t obstacle;
  Nearest nearest;
};

/// The obstacle with the smallest gap now, of those with less than `below` [m].
std::optional<NearestObstacle> nearestObstacle(const BatchQuery& q, double below);

/// Of obstacles that do not touch the footprint within the horizon, of which there is at least one.
/// \param clearance [m] smallest gap now
ClosestApproach closestApproach(const BatchQuery& q, double clearance);

Shape shapeOf(const ObstacleBatch& obstacles, std::size_t i);

/// Whether the footprint's contact with obstacle j comes before one with the obstacle `known`.
bool comesFirst(const BatchQuery& q, double time, std::size_t j, double known_time,
                std::size_t known);

}  // namespace footprint_collision_predictor::core
