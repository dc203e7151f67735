#include "footprints_parameter.hpp"

#include <ros/names.h>

#include <algorithm>
#include <cctype>

namespace footprint_collision_predictor {
namespace {

using Value = XmlRpc::XmlRpcValue;

constexpr char kForm[] =
    "a list with {name: trailer, frame_id: trailer, polygon: [[0.4, 0.3], [-0.4, 0.3], [-0.4, "
    "-0.3], [0.4, -0.3]]} for each body (or, instead of polygon, topic: trailer_footprint)";
constexpr char kName[] = "a name of letters, digits and _ that begins with a letter";
constexpr char kTopic[] = "the name of a topic";

/// It becomes part of the names of markers and diagnostics.
bool isName(const std::string& text) {
  const auto fits = [](unsigned char c) { return std::isalnum(c) || c == '_'; };
  return !text.empty() && std::isalpha(static_cast<unsigned char>(text.front())) &&
         std::all_of(text.begin(), text.end(), fits);
}

bool isTopic(const std::string& text) {
  std::string error;
  return !text.empty() && text.front() != '~' && ros::names::validate(text, error);
}

void readText(const std::string& key, const char* allowed, bool (*fits)(const std::string&),
              ParameterReader& reader, std::string& target) {
  const Value* value = reader.find(key);
  if (!value) return;
  target = ParameterReader::textOf(*value).value_or("");
  if (!fits(target)) reader.complain(key, *value, allowed);
}

/// \param path "~footprints[0]"
Body readBody(const std::string& path, const Parameters& p, ParameterReader& reader) {
  Body body{};
  readText("name", kName, isName, reader, body.name);
  readText("topic", kTopic, isTopic, reader, body.topic);
  reader.frame("frame_id", body.frame);
  reader.polygon("polygon", p.max_vertices, body.footprint);
  body.motion = body.frame == p.base_frame ? baseMotion(p) : BodyMotion::kTf;
  reader.choice<BodyMotion>(
      "motion",
      {{"odom", BodyMotion::kOdom}, {"tf", BodyMotion::kTf}, {"static", BodyMotion::kStatic}},
      body.motion);
  reader.refuseUnknown();
  for (const auto& [key, allowed] :
       {std::pair{"name", kName}, {"frame_id", "the name of a tf frame"}})
    reader.require(reader.has(key), path + "." + key + " is missing; allowed is " + allowed);
  reader.require(
      reader.has("polygon") != reader.has("topic"),
      path +
          (reader.has("topic") ? " has both polygon and topic" : " has neither polygon nor topic") +
          "; allowed is one of them");
  reader.require(!(body.motion == BodyMotion::kOdom && p.ego_motion == EgoMotion::kStatic),
                 path +
                     ".motion is odom, but ~ego_motion is static: without odometry, allowed is "
                     "tf or static");
  return body;
}

void requireDifferentNames(const std::vector<Body>& bodies, ParameterReader& reader) {
  for (std::size_t i = 0; i < bodies.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      reader.require(bodies[i].name.empty() || bodies[i].name != bodies[k].name,
                     "~footprints[" + std::to_string(i) + "].name is " + bodies[i].name +
                         ", as that of ~footprints[" + std::to_string(k) +
                         "]; allowed is a name of its own");
}

}  // namespace

BodyMotion baseMotion(const Parameters& p) {
  return p.ego_motion == EgoMotion::kStatic ? BodyMotion::kStatic : BodyMotion::kOdom;
}

void readFootprints(ParameterReader& reader, Parameters& p) {
  const Value* list = reader.find("footprints");
  if (!list) return;
  if (list->getType() != Value::TypeArray || list->size() == 0)
    return reader.complain("footprints", *list, kForm);
  for (int i = 0; i < list->size(); ++i) {
    const Value& element = (*list)[i];
    const std::string index = "footprints[" + std::to_string(i) + "]";
    if (element.getType() != Value::TypeStruct) {
      reader.complain(index, element, kForm);
      continue;
    }
    ParameterReader of_body(element, "~" + index + ".");
    p.footprints.push_back(readBody("~" + index, p, of_body));
    for (const std::string& complaint : of_body.complaints()) reader.require(false, complaint);
  }
  requireDifferentNames(p.footprints, reader);
}

}  // namespace footprint_collision_predictor
