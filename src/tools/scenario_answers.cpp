#include <algorithm>
#include <cmath>
#include <fstream>

#include "scenario_writer.hpp"

namespace footprint_collision_predictor::tools {
namespace {

using Json = nlohmann::ordered_json;

/// The first contact of one body at one message.
struct First {
  std::string footprint;
  double t;  ///< [s] of the message, since the start
  double time;
  int segment;
  std::int64_t obstacle_id;
};

struct BodyAnswer {
  std::vector<std::optional<Contact>> segments;
  std::optional<First> first;
};

BodyAnswer answerFor(const Scenario& scenario, const Body& body, const std::vector<Circle>& circles,
                     double t) {
  BodyAnswer answer;
  for (const Line& segment : segmentsOf(body)) {
    const auto contact = firstContact(scenario, circles, segment);
    const int number = static_cast<int>(answer.segments.size());
    answer.segments.push_back(contact);
    // The same corner may come out a rounding apart for its two segments; the lower one is named.
    if (contact && (!answer.first || contact->time < answer.first->time - 1e-12))
      answer.first = First{body.name, t, contact->time, number, contact->obstacle_id};
  }
  return answer;
}

Json timeOrNull(const std::optional<Contact>& contact) {
  return contact ? Json(contact->time) : Json(nullptr);
}

Json jsonOf(const BodyAnswer& answer) {
  Json segments = Json::array();
  for (const auto& contact : answer.segments) segments.push_back(timeOrNull(contact));
  return {{"time_to_collision", answer.first ? Json(answer.first->time) : Json(nullptr)},
          {"segments", segments}};
}

Json polygonOf(const Body& body) {
  Json polygon = Json::array();
  for (const Point& p : body.vertices) polygon.push_back({p.x, p.y});
  return polygon;
}

Json parameters(const Scenario& scenario) {
  Json json;
  if (scenario.bodies.size() == 1) {
    json["footprint"] = polygonOf(scenario.bodies.front());
  } else {
    json["footprints"] = Json::array();
    for (const Body& body : scenario.bodies)
      json["footprints"].push_back(
          {{"name", body.name}, {"frame_id", body.frame}, {"polygon", polygonOf(body)}});
  }
  json["base_frame"] = "base_link";
  json["fixed_frame"] = "odom";
  json["horizon"] = kHorizon;
  json["warn_time"] = kWarnTime;
  json["critical_time"] = kCriticalTime;
  json["ego_motion"] = "odom";
  json["obstacle_velocity"] = "over_ground";
  return json;
}

/// One object for each obstacles message; with several bodies, one in it for each.
Json messageAt(const Scenario& scenario, const ScenarioOptions& options, double t,
               std::vector<First>& firsts) {
  const auto circles = measured(scenario, options, t);
  Json json = {{"stamp", kStartSecond + t}, {"t", t}};
  std::optional<First> first;
  for (const Body& body : scenario.bodies) {
    const BodyAnswer answer = answerFor(scenario, body, circles, t);
    if (answer.first && (!first || answer.first->time < first->time)) first = answer.first;
    if (scenario.bodies.size() == 1)
      json.update(jsonOf(answer));
    else
      json["footprints"][body.name] = jsonOf(answer);
  }
  if (first) firsts.push_back(*first);
  return json;
}

std::optional<First> firstWithin(double threshold, const std::vector<First>& firsts) {
  const auto found = std::find_if(firsts.begin(), firsts.end(),
                                  [&](const First& f) { return f.time <= threshold; });
  return found == firsts.end() ? std::nullopt : std::make_optional(*found);
}

}  // namespace

Json expectedAnswers(const Scenario& scenario, const ScenarioOptions& options) {
  const std::vector<double> times = obstacleTimes(scenario, options);
  std::vector<First> firsts;
  Json messages = Json::array();
  for (const double t : times) messages.push_back(messageAt(scenario, options, t, firsts));
  const auto warn = firstWithin(kWarnTime, firsts);
  const auto critical = firstWithin(kCriticalTime, firsts);
  const auto first = warn ? warn : firstWithin(kHorizon, firsts);
  Json json;
  json["scenario"] = scenario.name;
  json["summary"] = scenario.summary;
  json["derivation"] = scenario.derivation;
  json["start"] = kStartSecond;
  json["contact_time"] = first ? Json(kStartSecond + first->t + first->time) : Json(nullptr);
  json["contact_after"] = first ? Json(first->t + first->time) : Json(nullptr);
  if (scenario.bodies.size() > 1)
    json["footprint"] = first ? Json(first->footprint) : Json(nullptr);
  json["segment"] = first ? Json(first->segment) : Json(nullptr);
  json["obstacle_id"] = first ? Json(first->obstacle_id) : Json(nullptr);
  json["first_warn_stamp"] = warn ? Json(kStartSecond + warn->t) : Json(nullptr);
  json["first_critical_stamp"] = critical ? Json(kStartSecond + critical->t) : Json(nullptr);
  json["last_stamp"] = kStartSecond + times.back();
  if (scenario.silence)
    json["silence"] = {{"after", scenario.silence->after}, {"before", scenario.silence->before}};
  json["looped"] = scenario.looped;
  json["parameters"] = parameters(scenario);
  json["units"] =
      "Stamps in s since 1970 (about 2e-7 s of rounding in a double), t and contact_after in s "
      "since start (exact). time_to_collision and segments (in the footprint's order) in s from "
      "the stamp, null: none within the horizon, 0: touching. contact_after, footprint (where "
      "there are several), segment and obstacle_id are what the first message says that is within "
      "warn_time, else within the "
      "horizon.";
  json["messages"] = messages;
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
