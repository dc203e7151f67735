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
  float red, green, blue;
  double width;
  double dash;  ///< 0: not dashed
  double gap;
};

inline const Style& styleOf(Outlook outlook) {
  static const Style kStyles[kOutlooks] = {
      {0.60f, 0.60f, 0.60f, 0.02, 0, 0},        // grey, thin
      {0.00f, 0.62f, 0.45f, 0.035, 0, 0},       // bluish green
      {0.34f, 0.71f, 0.91f, 0.05, 0, 0},        // sky blue
      {0.80f, 0.47f, 0.65f, 0.06, 0.06, 0.09},  // reddish purple, dotted
      {0.90f, 0.62f, 0.00f, 0.09, 0.25, 0.10},  // orange, dashed
      {0.84f, 0.37f, 0.00f, 0.14, 0, 0},        // vermillion, wide
  };
  return kStyles[static_cast<std::size_t>(outlook)];
}

inline std_msgs::ColorRGBA colourOf(Outlook outlook, float opacity = 1) {
  const Style& style = styleOf(outlook);
  std_msgs::ColorRGBA colour;
  colour.r = style.red;
  colour.g = style.green;
  colour.b = style.blue;
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
