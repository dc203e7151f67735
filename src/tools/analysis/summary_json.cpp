#include <cmath>

#include "../warning_line.hpp"
#include "outcome.hpp"
#include "summary.hpp"

namespace footprint_collision_predictor::tools {
namespace {

using Json = nlohmann::ordered_json;

Json finite(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json idOrNull(std::int64_t value) { return value < 0 ? Json(nullptr) : Json(value); }

Json jsonOf(const std::optional<core::Polygon>& polygon) {
  if (!polygon) return nullptr;
  Json json = Json::array();
  for (const auto& vertex : polygon->vertices()) json.push_back({vertex.x(), vertex.y()});
  return json;
}

Json jsonOf(const Body& body) {
  const bool by_tf = body.motion == BodyMotion::kTf;
  Json json = {{"name", body.name}, {"frame_id", body.frame}};
  json["polygon"] = jsonOf(body.footprint);
  json["topic"] = body.footprint ? Json(nullptr) : Json(body.topic);
  json["motion"] = by_tf ? "tf" : body.motion == BodyMotion::kOdom ? "odom" : "static";
  return json;
}

Json jsonOf(const std::optional<WorstMoment>& worst) {
  if (!worst) return nullptr;
  return {{"time_to_collision", worst->time_to_collision},
          {"stamp", worst->stamp.toSec()},
          {"elapsed", worst->elapsed},
          {"segment", worst->segment},
          {"obstacle_id", idOrNull(worst->obstacle_id)},
          {"obstacle_index", idOrNull(worst->obstacle_index)},
          {"contact_point", {worst->contact_point.x, worst->contact_point.y}},
          {"closing_speed", finite(worst->closing_speed)}};
}

Json levels(const Statistics& statistics) {
  Json json;
  for (const auto level : {CollisionWarning::CLEAR, CollisionWarning::WARN,
                           CollisionWarning::CRITICAL, CollisionWarning::UNKNOWN})
    json[levelName(level)] = statistics.secondsAt().at(level);
  return json;
}

Json reasons(const Statistics& statistics) {
  Json json = Json::array();
  for (const auto& [bit, count] : statistics.reasons())
    json.push_back({{"reason", reasonName(bit)},
                    {"evaluations", count.evaluations},
                    {"percent", 100.0 * static_cast<double>(count.evaluations) /
                                    static_cast<double>(statistics.evaluations())},
                    {"first_message", count.first_message}});
  return json;
}

std::size_t contacts(const std::vector<Event>& events) {
  std::size_t count = 0;
  for (const Event& event : events) count += event.contact ? 1 : 0;
  return count;
}

Json topics(const TopicChoice& choice) {
  const auto named = [](const std::string& name) {
    return name.empty() ? Json(nullptr) : Json(name);
  };
  return {{"obstacles", named(choice.names.obstacles)},
          {"obstacles_type", named(choice.obstacles_type)},
          {"odom", named(choice.names.odom)},
          {"footprint", named(choice.names.footprint)}};
}

}  // namespace

Json parametersJson(const Parameters& p) {
  Json json;
  json["footprint"] = jsonOf(p.footprint);
  for (const Body& body : p.footprints) json["footprints"].push_back(jsonOf(body));
  json["base_frame"] = p.base_frame;
  json["fixed_frame"] = p.fixed_frame;
  json["horizon"] = p.horizon;
  json["warn_time"] = p.thresholds.warn_time;
  json["critical_time"] = p.thresholds.critical_time;
  json["max_data_age"] = p.max_data_age;
  json["transform_tolerance"] = p.transform_tolerance;
  json["clear_after"] = p.clear_after;
  json["ego_motion"] = p.ego_motion == EgoMotion::kStatic ? "static" : "odom";
  json["obstacle_velocity"] =
      p.obstacle_velocity == ObstacleVelocity::kRelative ? "relative" : "over_ground";
  json["obstacle_detector_radius"] =
      p.obstacle_detector_radius == ObstacleDetectorRadius::kRadius ? "radius" : "true_radius";
  return json;
}

Json bagJson(const BagReport& report, const Options& options) {
  const Statistics& s = report.statistics;
  Json json;
  json["bag"] = report.bag;
  if (!report.footprint.empty()) json["footprint"] = report.footprint;
  json["state"] = wordFor(s.verdict(options.max_unknown));
  json["problem"] = report.problem.empty() ? Json(nullptr) : Json(report.problem);
  json["partial"] = report.partial;
  json["limit_broken"] = breaksLimit(report, options);
  if (s.evaluations() == 0) return json;
  json["start"] = report.window.begin.toSec();
  json["seconds"] = s.seconds();
  json["topics"] = topics(report.topics);
  json["smallest_time_to_collision"] = jsonOf(s.worst());
  json["smallest_clearance"] = finite(s.smallestClearance());
  json["seconds_at_level"] = levels(s);
  json["events"] = report.events.size();
  json["events_with_contact"] = contacts(report.events);
  json["evaluations"] = s.evaluations();
  json["usable_evaluations"] = s.usable();
  json["silences"] = s.silences();
  json["unknown_percent"] = s.unknownPercent();
  json["refused_transforms"] = report.refused_transforms;
  json["reasons"] = reasons(s);
  return json;
}

std::string jsonText(const Json& json, int indent) {
  return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

Json summaryJson(const std::vector<BagReport>& reports, const Options& options,
                 const Parameters& parameters) {
  Json json;
  json["program"] = "analyze_bag " PACKAGE_VERSION;
  json["partial"] = false;
  json["parameters"] = parametersJson(parameters);
  json["fail_under"] = options.fail_under ? Json(*options.fail_under) : Json(nullptr);
  json["max_unknown"] = options.max_unknown;
  json["bags"] = Json::array();
  for (const BagReport& report : reports) {
    json["bags"].push_back(bagJson(report, options));
    json["partial"] = json["partial"].get<bool>() || report.partial;
  }
  return json;
}

}  // namespace footprint_collision_predictor::tools
