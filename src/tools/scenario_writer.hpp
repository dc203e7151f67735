// A scenario as files: the bag to replay, and the answers to expect.
#pragma once

#include <ros/time.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "partial_file.hpp"
#include "scenario.hpp"

namespace footprint_collision_predictor::tools {

/// Second at which every scenario starts.
constexpr unsigned kStartSecond = 1600000000;

/// Moments of the obstacles messages in whole nanoseconds, as [s] since the start, from 0 to the
/// duration inclusive; without those of a silence.
std::vector<double> obstacleTimes(const Scenario& scenario, const ScenarioOptions& options);

/// The stamp of such a moment.
ros::Time stampAt(double t);

/// `obstacles` at the rate chosen, `odom` and `/tf` five times as often, one of them at every
/// obstacles stamp. The same scenario gives the same bytes each time.
/// \throws WriteError; what was there before is then left alone
void writeBag(const Scenario& scenario, const ScenarioOptions& options, const std::string& path);

/// What the predictor must answer, message by message.
nlohmann::ordered_json expectedAnswers(const Scenario& scenario, const ScenarioOptions& options);

/// \throws WriteError; what was there before is then left alone
void writeJson(const nlohmann::ordered_json& json, const std::string& path);

}  // namespace footprint_collision_predictor::tools
