#include "parameter_reader.hpp"

#include <algorithm>
#include <sstream>
#include <stdexcept>

#include "footprint_parameter.hpp"
#include "frame_names.hpp"
#include "suggestion.hpp"

namespace footprint_collision_predictor {
namespace {

using Value = XmlRpc::XmlRpcValue;

std::string shown(const Value& value) {
  std::ostringstream text;
  value.write(text);
  return text.str();
}

std::optional<double> asNumber(const Value& value) {
  if (value.getType() == Value::TypeInt) return static_cast<const int&>(value);
  if (value.getType() == Value::TypeDouble) return static_cast<const double&>(value);
  return std::nullopt;
}

}  // namespace

ParameterReader::ParameterReader(const Value& values, std::string path) : path_(std::move(path)) {
  if (values.getType() != Value::TypeStruct) return;
  for (auto it = values.begin(); it != values.end(); ++it) values_.emplace(it->first, it->second);
}

void ParameterReader::number(const std::string& name, double lowest, double highest,
                             double& target) {
  const Value* value = find(name);
  if (!value) return;
  std::ostringstream allowed;
  allowed << "a number from " << lowest << " to " << highest;
  const std::optional<double> read = asNumber(*value);
  if (!read) {
    const bool text = value->getType() == Value::TypeString;
    complain(name, *value,
             allowed.str() + (text ? " (YAML reads 1e-3 as text: write 0.001 or 1.0e-3)" : ""));
  } else if (!(*read >= lowest && *read <= highest)) {
    complain(name, *value, allowed.str());
  } else {
    target = *read;
  }
}

void ParameterReader::count(const std::string& name, int lowest, int highest, std::size_t& target) {
  const Value* value = find(name);
  if (!value) return;
  const bool integer = value->getType() == Value::TypeInt;
  const int read = integer ? static_cast<const int&>(*value) : 0;
  if (integer && read >= lowest && read <= highest) {
    target = static_cast<std::size_t>(read);
  } else {
    complain(name, *value,
             "a whole number from " + std::to_string(lowest) + " to " + std::to_string(highest));
  }
}

void ParameterReader::frame(const std::string& name, std::string& target) {
  const Value* value = find(name);
  if (!value) return;
  const std::string read = withoutLeadingSlash(textOf(*value).value_or(""));
  if (read.empty())
    complain(name, *value, "the name of a tf frame");
  else
    target = read;
}

void ParameterReader::polygon(const std::string& name, std::size_t max_vertices,
                              std::optional<core::Polygon>& target) try {
  const Value* value = find(name);
  if (!value) return;
  const std::vector<core::Vec2> vertices = footprintVertices(*value);
  if (vertices.size() > max_vertices)
    throw std::invalid_argument("it has " + std::to_string(vertices.size()) +
                                " vertices, more than ~max_vertices " +
                                std::to_string(max_vertices));
  target.emplace(vertices);
} catch (const std::invalid_argument& error) {
  complaints_.push_back(path_ + name + " is refused: " + error.what());
}

const Value* ParameterReader::find(const std::string& name) {
  known_.push_back(name);
  const auto found = values_.find(name);
  return found == values_.end() ? nullptr : &found->second;
}

void ParameterReader::complain(const std::string& name, const Value& value,
                               const std::string& allowed) {
  complaints_.push_back(path_ + name + " is " + shown(value) + "; allowed is " + allowed);
}

void ParameterReader::require(bool holds, const std::string& complaint) {
  if (!holds) complaints_.push_back(complaint);
}

void ParameterReader::refuseUnknown() {
  for (const auto& entry : values_) {
    if (std::find(known_.begin(), known_.end(), entry.first) != known_.end()) continue;
    const std::string meant = nearestName(entry.first, known_);
    complaints_.push_back("unknown parameter " + path_ + entry.first +
                          (meant.empty() ? "" : "; did you mean " + path_ + meant + "?"));
  }
}

std::optional<std::string> ParameterReader::textOf(const Value& value) {
  if (value.getType() != Value::TypeString) return std::nullopt;
  return static_cast<const std::string&>(value);
}

}  // namespace footprint_collision_predictor
