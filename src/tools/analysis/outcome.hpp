// What all bags together come to: the exit status, and the limits that were set.
#pragma once

#include <vector>

#include "bag_analysis.hpp"

namespace footprint_collision_predictor::tools {

/// Whether a time to collision of that bag is under --fail-under.
bool breaksLimit(const BagReport& report, const Options& options);

/// Whether too little of that bag can be told for what was asked.
bool isUnusable(const BagReport& report, const Options& options);

int exitStatus(const std::vector<BagReport>& reports, const Options& options, bool interrupted);

}  // namespace footprint_collision_predictor::tools
