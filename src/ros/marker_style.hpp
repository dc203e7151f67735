// How levels look in RViz. They differ in width and dashes, and in words, not in colour alone; the
// colours are those of Okabe and Ito ("Color universal design", 2008), told apart by colour-blind
// people too, on dark and on light ground.
#pragma once

#include <std_msgs/ColorRGBA.h>

#include <cstddef>
#include <optional>

#include "footprint_collision_predictor/warning.hpp"

namespace footprint_collision_predictor {

/// What is known about a footprint segment or an obstacle. The values are marker ids.
enum class Outlook {
  kIrrelevant,  ///< an obstacle that touches nothing first within the horizon
  kFree,        ///< a segment that nothing touches within the horizon
  kLater,       ///< a contact after warn_time
  kUnknown,
  kWarn,
  kCritical,
};
constexpr std::size_t kOutlooks = 6;

/// Lengths are multiples of the footprint's bounding radius.
struct Style {
  int red, green, blue;  ///< 0 to 255
  double width;
  double dash;  ///< 0: not dashed
  double gap;
};

inline const Style& styleOf(Outlook outlook) {
  static const Style kStyles[kOutlooks] = {
      {153, 153, 153, 0.022, 0, 0},        // grey, thin
      {0, 158, 115, 0.036, 0, 0},          // bluish green
      {86, 180, 233, 0.050, 0, 0},         // sky blue
      {204, 121, 167, 0.066, 0.06, 0.09},  // reddish purple, dotted
      {230, 159, 0, 0.090, 0.25, 0.10},    // orange, dashed
      {213, 94, 0, 0.130, 0, 0},           // vermillion, wide
  };
  return kStyles[static_cast<std::size_t>(outlook)];
}

inline std_msgs::ColorRGBA colourOf(Outlook outlook, float opacity = 1) {
  const Style& style = styleOf(outlook);
  std_msgs::ColorRGBA colour;
  colour.r = static_cast<float>(style.red) / 255;
  colour.g = static_cast<float>(style.green) / 255;
  colour.b = static_cast<float>(style.blue) / 255;
  colour.a = opacity;
  return colour;
}

/// \param time_to_collision [s] nothing where none is certain
/// \param otherwise what it is then
inline Outlook outlookOf(std::optional<double> time_to_collision, const core::Thresholds& limits,
                         Outlook otherwise) {
  if (!time_to_collision) return otherwise;
  if (*time_to_collision <= limits.critical_time) return Outlook::kCritical;
  return *time_to_collision <= limits.warn_time ? Outlook::kWarn : Outlook::kLater;
}

inline Outlook outlookOf(core::Level level) {
  switch (level) {
    case core::Level::kCritical:
      return Outlook::kCritical;
    case core::Level::kWarn:
      return Outlook::kWarn;
    case core::Level::kClear:
      return Outlook::kFree;
    default:
      return Outlook::kUnknown;
  }
}

}  // namespace footprint_collision_predictor
