// The one line of text in RViz.
#pragma once

#include <string>

#include "footprint_collision_predictor/CollisionWarning.h"

namespace footprint_collision_predictor {

/// "CRITICAL: contact in 1.49 s, segment 3, obstacle 7", or why it is UNKNOWN, shortened.
/// With several footprints its name stands before it.
/// \param undrawn number of obstacles that are left out of the picture
std::string markerText(const CollisionWarning& warning, std::size_t undrawn);

}  // namespace footprint_collision_predictor
