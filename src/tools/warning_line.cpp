#include "warning_line.hpp"

#include <cstdio>
#include <tuple>

namespace footprint_collision_predictor::tools {
namespace {

template <typename... Values>
std::string format(const char* pattern, Values... values) {
  char text[160];
  std::snprintf(text, sizeof text, pattern, values...);
  return text;
}

const char* colourOf(std::uint8_t level) {
  switch (level) {
    case CollisionWarning::CRITICAL:
      return "\033[1;31m";  // red
    case CollisionWarning::WARN:
      return "\033[33m";  // yellow
    case CollisionWarning::CLEAR:
      return "\033[32m";  // green
    default:
      return "\033[35m";  // magenta
  }
}

std::string contact(const CollisionWarning& w) {
  std::string text =
      w.time_to_collision <= 0 ? "contact now" : format("contact in %.2f s", w.time_to_collision);
  text += format("  segment %d", w.segment);
  if (w.obstacle_id >= 0) text += format("  obstacle %lld", static_cast<long long>(w.obstacle_id));
  return text;
}

std::string finding(const CollisionWarning& w) {
  std::string text;
  if (w.collision_predicted != 0) {
    text = contact(w);
  } else if (w.level == CollisionWarning::CLEAR || w.level == CollisionWarning::WARN ||
             w.level == CollisionWarning::CRITICAL) {
    text = format("nothing within %.1f s", w.horizon);
  }
  if (w.message.empty()) return text.empty() ? "cannot tell" : text;
  return text.empty() ? w.message : text + "  (" + w.message + ")";
}

auto essence(const CollisionWarning& w) {
  const bool now = w.collision_predicted != 0 && w.time_to_collision <= 0;
  return std::make_tuple(w.level, w.collision_predicted, w.segment, w.obstacle_id, w.reason,
                         w.session, now);
}

}  // namespace

std::string levelName(std::uint8_t level) {
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

std::string warningLine(const CollisionWarning& warning, std::optional<double> t, bool coloured) {
  std::string line = t ? format("t=%6.2f s  ", *t) : std::string("t=     - s  ");
  const std::string level = format("%-8s", levelName(warning.level).c_str());
  line += coloured ? colourOf(warning.level) + level + "\033[0m" : level;
  line += "  " + finding(warning);
  if (!warning.footprint.empty() && warning.footprint != "footprint") {
    line += "  [" + warning.footprint + "]";
  }
  return line;
}

bool saysSomethingElse(const CollisionWarning& a, const CollisionWarning& b) {
  return essence(a) != essence(b);
}

}  // namespace footprint_collision_predictor::tools
