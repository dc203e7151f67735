// For error messages about names.
#pragma once

#include <string>
#include <vector>

namespace footprint_collision_predictor::tools {

/// The candidate with the fewest typing errors in `given`, or "" when none is similar.
std::string didYouMean(const std::string& given, const std::vector<std::string>& candidates);

}  // namespace footprint_collision_predictor::tools
