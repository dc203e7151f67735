#include "footprint_parameter.hpp"

#include <yaml-cpp/yaml.h>

#include <stdexcept>
#include <string>

namespace footprint_collision_predictor {
namespace {

[[noreturn]] void refuse(const std::string& problem) {
  throw std::invalid_argument(
      problem +
      "; write a list [[0.3, 0.2], [-0.3, 0.2], [-0.3, -0.2]] or the same as "
      "a string \"[[0.3, 0.2], [-0.3, 0.2], [-0.3, -0.2]]\", in metres");
}

std::vector<core::Vec2> fromText(const std::string& text) try {
  const YAML::Node list = YAML::Load(text);
  if (!list.IsSequence()) refuse("the string \"" + text + "\" is not a list of [x, y] pairs");
  std::vector<core::Vec2> vertices;
  for (const YAML::Node& pair : list) {
    if (!pair.IsSequence() || pair.size() != 2)
      refuse("vertex " + std::to_string(vertices.size()) + " is not a pair [x, y]");
    vertices.emplace_back(pair[0].as<double>(), pair[1].as<double>());
  }
  return vertices;
} catch (const YAML::Exception& error) {
  refuse("the string \"" + text + "\" cannot be read (" + error.what() + ")");
}

double number(const XmlRpc::XmlRpcValue& value, std::size_t vertex) {
  if (value.getType() == XmlRpc::XmlRpcValue::TypeInt) return static_cast<const int&>(value);
  if (value.getType() == XmlRpc::XmlRpcValue::TypeDouble) return static_cast<const double&>(value);
  refuse("vertex " + std::to_string(vertex) + " has a coordinate that is not a number");
}

std::vector<core::Vec2> fromList(const XmlRpc::XmlRpcValue& list) {
  std::vector<core::Vec2> vertices;
  for (int i = 0; i < list.size(); ++i) {
    const XmlRpc::XmlRpcValue& pair = list[i];
    if (pair.getType() != XmlRpc::XmlRpcValue::TypeArray || pair.size() != 2)
      refuse("vertex " + std::to_string(i) + " is not a pair [x, y]");
    vertices.emplace_back(number(pair[0], vertices.size()), number(pair[1], vertices.size()));
  }
  return vertices;
}

}  // namespace

std::vector<core::Vec2> footprintVertices(const XmlRpc::XmlRpcValue& value) {
  if (value.getType() == XmlRpc::XmlRpcValue::TypeString)
    return fromText(static_cast<const std::string&>(value));
  if (value.getType() == XmlRpc::XmlRpcValue::TypeArray) return fromList(value);
  refuse("it is neither a list nor a string");
}

}  // namespace footprint_collision_predictor
