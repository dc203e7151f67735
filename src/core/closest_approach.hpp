// The smallest gap between a footprint and an obstacle within the horizon.
#pragma once

#include "footprint_collision_predictor/predictor.hpp"
#include "shape.hpp"

namespace footprint_collision_predictor::core {

/// Lowers what is known of the closest approach so far, where this obstacle comes closer by more
/// than some 1e-7 m.
/// \param shape that does not touch the footprint within the horizon
void lower(const Polygon& footprint, const Twist& twist, const Shape& shape, double horizon,
           ClosestApproach* closest);

}  // namespace footprint_collision_predictor::core
