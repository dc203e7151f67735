// A scenario as files: the bag to replay, and the answers to expect.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "partial_file.hpp"
#include "scenario.hpp"

namespace footprint_collision_predictor::tools {

/// Second at which every scenario starts; 0.1 s is a whole number of nanoseconds after it.
constexpr unsigned kStartSecond = 1600000000;

/// `obstacles` at 10 Hz, `odom` and `/tf` at 50 Hz with one at every obstacles stamp, from the
/// start to `duration` [s] inclusive. The same scenario gives the same bytes each time. \throws
/// WriteError; what was there before is then left alone.
void writeBag(const Scenario& scenario, double duration, const std::string& path);

/// What the predictor must answer, message by message.
nlohmann::ordered_json expectedAnswers(const Scenario& scenario, double duration);

/// \throws WriteError; what was there before is then left alone.
void writeJson(const nlohmann::ordered_json& json, const std::string& path);

}  // namespace footprint_collision_predictor::tools
