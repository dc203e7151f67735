#include "yaml_parameters.hpp"

#include <yaml-cpp/yaml.h>

#include <fstream>
#include <regex>

namespace footprint_collision_predictor::tools {
namespace {

using XmlRpc::XmlRpcValue;

bool isInteger(const std::string& text) {
  static const std::regex pattern("[-+]?(0|[1-9][0-9]*)");
  return std::regex_match(text, pattern);
}

bool isNumber(const std::string& text) {
  static const std::regex pattern("[-+]?([0-9]+\\.[0-9]*|\\.[0-9]+)([eE][-+][0-9]+)?");
  return std::regex_match(text, pattern);
}

bool isTruth(const std::string& text, const char* pattern) {
  return std::regex_match(text, std::regex(pattern, std::regex::icase));
}

XmlRpcValue scalar(const YAML::Node& node) {
  const std::string& text = node.Scalar();
  const bool quoted = node.Tag() == "!";
  if (quoted) return text;
  if (isInteger(text)) return std::stoi(text);
  if (isNumber(text)) return std::stod(text);
  if (isTruth(text, "true|yes|on")) return true;
  if (isTruth(text, "false|no|off")) return false;
  return text;
}

XmlRpcValue toXmlRpc(const YAML::Node& node) {
  if (node.IsScalar()) return scalar(node);
  XmlRpcValue value;
  if (node.IsSequence()) {
    value.setSize(static_cast<int>(node.size()));
    for (std::size_t i = 0; i < node.size(); ++i) value[static_cast<int>(i)] = toXmlRpc(node[i]);
  } else if (node.IsMap()) {
    for (const auto& entry : node) value[entry.first.Scalar()] = toXmlRpc(entry.second);
  } else {
    value = std::string();
  }
  return value;
}

}  // namespace

XmlRpcValue readParameters(const std::string& path) {
  std::ifstream in(path);
  if (!in) throw ParameterFileError("cannot read " + path + ": no such file, or no permission");
  try {
    const YAML::Node root = YAML::Load(in);
    if (!root.IsMap()) throw ParameterFileError(path + " is not a list of \"name: value\" lines");
    return toXmlRpc(root);
  } catch (const YAML::Exception& error) {
    throw ParameterFileError(path + " is not YAML: " + error.what());
  } catch (const std::out_of_range&) {
    throw ParameterFileError(path + " has a number that is too large");
  }
}

}  // namespace footprint_collision_predictor::tools
