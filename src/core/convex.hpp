// A disc against a convex footprint as a whole: quicker than segment by segment.
#pragma once

#include <optional>

#include "footprint_collision_predictor/polygon.hpp"
#include "narrow_phase.hpp"

namespace footprint_collision_predictor::core {

/// The first touch, or that there is none, or that a look at each segment is needed.
struct ConvexAnswer {
  bool is_certain;
  std::optional<FirstTouch> touch;
};

/// \param footprint that is convex
/// \param disc over ground, its position told from the centroid; it does not overlap the footprint
///     now
/// \param until [s] a touch later than that is not looked for
ConvexAnswer firstTouchOfConvex(const Polygon& footprint, const Twist& twist, const Disc& disc,
                                double until);

}  // namespace footprint_collision_predictor::core
