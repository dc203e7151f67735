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

/// What summary.json says of one bag, and of the parameters.
nlohmann::ordered_json bagJson(const BagReport& report, const Options& options);
nlohmann::ordered_json parametersJson(const Parameters& parameters);

/// As text, also where a bag holds names that are not UTF-8.
/// \param indent -1: all on one line
std::string jsonText(const nlohmann::ordered_json& json, int indent);

/// "CONTACT at 7.60 s: segment 3, obstacle 7", "no contact ...", "CANNOT TELL ..."
std::string verdictText(const BagReport& report, const Options& options);

/// A few lines for one bag.
std::string summaryText(const BagReport& report, const Options& options);

/// For --dry-run.
std::string planText(const BagReport& report, const Parameters& parameters, const Body& body);

}  // namespace footprint_collision_predictor::tools
