// One line of text for one warning.
#pragma once

#include <footprint_collision_predictor/CollisionWarning.h>

#include <optional>
#include <string>

namespace footprint_collision_predictor::tools {

/// CRITICAL, WARN, CLEAR or UNKNOWN; a level that does not exist reads as UNKNOWN.
std::string levelName(std::uint8_t level);

/// "t=  3.20 s  CRITICAL  contact in 1.31 s  segment 1  obstacle 7"
/// \param t [s] of the warning's stamp; nothing when the warning has none
std::string warningLine(const CollisionWarning& warning, std::optional<double> t, bool coloured);

/// Whether two warnings of one footprint say something else, apart from their numbers going on.
bool saysSomethingElse(const CollisionWarning& a, const CollisionWarning& b);

}  // namespace footprint_collision_predictor::tools
