#include "marker_text.hpp"

#include <cstdio>

#include "footprint_name.hpp"

namespace footprint_collision_predictor {
namespace {

// Characters of a message that are shown: it is a line on a picture, and the whole is on the topic.
constexpr std::size_t kLongestMessage = 72;

template <typename... Values>
std::string format(const char* pattern, Values... values) {
  char text[96];
  std::snprintf(text, sizeof text, pattern, values...);
  return text;
}

const char* levelName(std::uint8_t level) {
  switch (level) {
    case CollisionWarning::CRITICAL:
      return "CRITICAL";
    case CollisionWarning::WARN:
      return "WARN";
    case CollisionWarning::CLEAR:
      return "CLEAR";
    default:
      return "UNKNOWN";
  }
}

std::string contactText(const CollisionWarning& warning) {
  std::string text = warning.time_to_collision <= 0
                         ? "contact now"
                         : format("contact in %.2f s", warning.time_to_collision);
  text += format(", segment %d", warning.segment);
  if (warning.obstacle_id >= 0)
    text += format(", obstacle %lld", static_cast<long long>(warning.obstacle_id));
  return text;
}

/// Cut at the end of a word.
std::string shortened(const std::string& message) {
  if (message.size() <= kLongestMessage) return message;
  const std::size_t space = message.rfind(' ', kLongestMessage);
  return message.substr(0, space == std::string::npos ? kLongestMessage : space) + " ...";
}

}  // namespace

std::string markerText(const CollisionWarning& warning, std::size_t undrawn) {
  std::string text = prefixFor(warning.footprint) + levelName(warning.level);
  if (warning.collision_predicted != 0)
    text += ": " + contactText(warning);
  else if (warning.level == CollisionWarning::CLEAR)
    text += format(": nothing within %.1f s", warning.horizon);
  else if (!warning.message.empty())
    text += ": " + shortened(warning.message);
  if (undrawn > 0) text += format(" (%zu obstacles are not drawn)", undrawn);
  return text;
}

}  // namespace footprint_collision_predictor
