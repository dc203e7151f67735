#include <cmath>
#include <fstream>

#include "scenario_writer.hpp"

namespace footprint_collision_predictor::tools {
namespace {

using Json = nlohmann::ordered_json;

constexpr long kMessagesPerSecond = 10;

template <typename T>
Json orNull(const std::optional<T>& value) {
  return value ? Json(*value) : Json(nullptr);
}

Json absolute(const std::optional<double>& t) {
  return t ? Json(kStartSecond + *t) : Json(nullptr);
}

double timeOf(long message) { return static_cast<double>(message) / kMessagesPerSecond; }

/// [s] of the first message whose time to collision is at most `threshold`.
std::optional<double> firstWithin(double threshold, const std::optional<Interval>& touch,
                                  long messages) {
  for (long i = 0; i < messages; ++i) {
    const auto time = timeToCollision(touch, timeOf(i));
    if (time && *time <= threshold) return timeOf(i);
  }
  return std::nullopt;
}

Json parameters() {
  Json footprint = Json::array();
  for (const auto& p : kFootprint) footprint.push_back({p.x, p.y});
  return {{"footprint", footprint}, {"base_frame", "base_link"},
          {"fixed_frame", "odom"},  {"horizon", kHorizon},
          {"warn_time", kWarnTime}, {"critical_time", kCriticalTime},
          {"ego_motion", "odom"},   {"obstacle_velocity", "over_ground"}};
}

Json messageAt(const Scenario& scenario, double t) {
  Json segments = Json::array();
  for (const auto& touch : scenario.touches) segments.push_back(orNull(timeToCollision(touch, t)));
  return {{"stamp", kStartSecond + t},
          {"t", t},
          {"time_to_collision", orNull(timeToCollision(footprintTouch(scenario), t))},
          {"segments", segments}};
}

}  // namespace

Json expectedAnswers(const Scenario& scenario, double duration) {
  const auto touch = footprintTouch(scenario);
  const long messages = std::lround(std::floor(duration * kMessagesPerSecond + 1e-6)) + 1;
  Json json;
  json["scenario"] = scenario.name;
  json["summary"] = scenario.summary;
  json["derivation"] = scenario.derivation;
  json["start"] = kStartSecond;
  json["contact_time"] = touch ? Json(kStartSecond + touch->begin) : Json(nullptr);
  json["contact_after"] = touch ? Json(touch->begin) : Json(nullptr);
  json["segment"] = orNull(scenario.segment);
  json["obstacle_id"] = orNull(scenario.obstacle_id);
  json["first_warn_stamp"] = absolute(firstWithin(kWarnTime, touch, messages));
  json["first_critical_stamp"] = absolute(firstWithin(kCriticalTime, touch, messages));
  json["last_stamp"] = kStartSecond + timeOf(messages - 1);
  json["parameters"] = parameters();
  json["units"] =
      "Stamps in s since 1970 (about 2e-7 s of rounding in a double), t and contact_after in s "
      "since start (exact). time_to_collision and segments (in the footprint's order) in s from "
      "the "
      "stamp, null: none within the horizon, 0: touching.";
  json["messages"] = Json::array();
  for (long i = 0; i < messages; ++i) json["messages"].push_back(messageAt(scenario, timeOf(i)));
  return json;
}

void writeJson(const Json& json, const std::string& path) {
  PartialFile file(path);
  std::ofstream out(file.partialPath());
  out << json.dump(1) << '\n';
  out.close();
  if (!out) throw WriteError("cannot write " + path + ": writing failed (is the disk full?)");
  file.finish();
}

}  // namespace footprint_collision_predictor::tools
