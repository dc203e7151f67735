#include <fstream>
#include <nlohmann/json.hpp>

#include "expectation.hpp"

namespace footprint_collision_predictor::tools {
namespace {

using Json = nlohmann::json;

template <typename T>
std::optional<T> optionalAt(const Json& json, const char* name) {
  const Json& value = json.at(name);
  return value.is_null() ? std::nullopt : std::optional<T>(value.get<T>());
}

std::optional<double> sinceStart(const Json& json, const char* name) {
  const auto stamp = optionalAt<double>(json, name);
  return stamp ? std::optional<double>(*stamp - json.at("start").get<double>()) : std::nullopt;
}

Answers parse(const Json& json) {
  Answers answers{};
  answers.start = json.at("start").get<unsigned>();
  answers.last = json.at("messages").back().at("t").get<double>();
  answers.contact = optionalAt<double>(json, "contact_after");
  answers.first_warn = sinceStart(json, "first_warn_stamp");
  answers.first_critical = sinceStart(json, "first_critical_stamp");
  if (json.contains("footprint")) answers.footprint = optionalAt<std::string>(json, "footprint");
  answers.segment = optionalAt<int>(json, "segment");
  answers.obstacle_id = optionalAt<std::int64_t>(json, "obstacle_id");
  answers.warn_time = json.at("parameters").at("warn_time").get<double>();
  answers.critical_time = json.at("parameters").at("critical_time").get<double>();
  if (answers.first_warn && !(answers.contact && answers.segment && answers.obstacle_id)) {
    throw ReadError("a warning is expected, but not of what");
  }
  return answers;
}

}  // namespace

Answers readAnswers(const std::string& path) {
  std::ifstream in(path);
  if (!in) throw ReadError("cannot read " + path + ": no such file, or no permission");
  try {
    return parse(Json::parse(in));
  } catch (const std::exception& error) {
    throw ReadError("cannot use " + path + ": " + error.what() +
                    "; make it anew with make_scenario");
  }
}

}  // namespace footprint_collision_predictor::tools
