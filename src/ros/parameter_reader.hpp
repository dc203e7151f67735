// Reads parameters one by one and collects every complaint, so that all are told at once.
#pragma once

#include <xmlrpcpp/XmlRpcValue.h>

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "footprint_collision_predictor/polygon.hpp"

namespace footprint_collision_predictor {

/// The values of a struct by their names. What is not there leaves its target as it is; so does
/// what is wrong, which gives a complaint with its value and what is allowed.
class ParameterReader {
 public:
  using Value = XmlRpc::XmlRpcValue;

  /// \param values a struct; anything else has no values
  /// \param path before the names in complaints: "~"
  explicit ParameterReader(const Value& values, std::string path = "~");

  void number(const std::string& name, double lowest, double highest, double& target);
  void count(const std::string& name, int lowest, int highest, std::size_t& target);
  void frame(const std::string& name, std::string& target);
  void polygon(const std::string& name, std::size_t max_vertices,
               std::optional<core::Polygon>& target);

  template <typename Choice>
  void choice(const std::string& name, const std::map<std::string, Choice>& choices,
              Choice& target) {
    const Value* value = find(name);
    if (!value) return;
    const auto found = choices.find(textOf(*value).value_or(""));
    if (found != choices.end()) {
      target = found->second;
      return;
    }
    std::string allowed;
    for (const auto& entry : choices) allowed += (allowed.empty() ? "" : " or ") + entry.first;
    complain(name, *value, allowed);
  }

  /// For what has rules of its own. \return nullptr when it is not there
  const Value* find(const std::string& name);
  bool has(const std::string& name) const { return values_.count(name) > 0; }
  void complain(const std::string& name, const Value& value, const std::string& allowed);
  void require(bool holds, const std::string& complaint);
  /// Those that were never asked for.
  void refuseUnknown();

  const std::vector<std::string>& complaints() const { return complaints_; }

  static std::optional<std::string> textOf(const Value& value);

 private:
  const std::string path_;
  std::map<std::string, Value> values_;
  std::vector<std::string> known_;
  std::vector<std::string> complaints_;
};

}  // namespace footprint_collision_predictor
