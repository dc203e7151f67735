// "Did you mean ...?" for misspelt names.
#pragma once

#include <string>
#include <vector>

namespace footprint_collision_predictor {

/// The candidate that begins with the name, else that with the fewest single-character edits from
/// the name (Levenshtein distance), or an empty string when none is near enough to be meant.
std::string nearestName(const std::string& name, const std::vector<std::string>& candidates);

}  // namespace footprint_collision_predictor
