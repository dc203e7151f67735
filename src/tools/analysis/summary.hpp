// The results as a whole: for programs, and for a person.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "bag_analysis.hpp"

namespace footprint_collision_predictor::tools {

/// summary.json. JSON knows neither infinity nor NaN: states are spelled out, and what is not there
/// is null.
nlohmann::ordered_json summaryJson(const std::vector<BagReport>& reports, const Options& options,
                                   const Parameters& parameters);

/// A few lines for one bag.
std::string summaryText(const BagReport& report, const Options& options);

/// For --dry-run.
std::string planText(const BagReport& report, const Parameters& parameters);

}  // namespace footprint_collision_predictor::tools
