// Where a footprint may be within a time, as circles that move straight.
#pragma once

#include <array>
#include <cstddef>

#include "footprint_collision_predictor/motion.hpp"
#include "footprint_collision_predictor/polygon.hpp"

namespace footprint_collision_predictor::core {

/// The circle around a footprint, on its way.
class SweptFootprint {
 public:
  static constexpr std::size_t kMostWindows = 8;

  /// \param obstacle_acceleration [m/s^2] the largest of any obstacle it is held against
  SweptFootprint(const Polygon& footprint, const Twist& twist, double horizon,
                 double obstacle_acceleration);

  /// [m] in the footprint's frame; everything else is relative to it, so that nothing is lost far
  /// from the frame's origin.
  const Vec2& centroid() const { return centroid_; }
  bool turns() const { return turns_; }
  /// A stretch of time in which the circle moves along a chord.
  struct Window {
    double start;     ///< [s]
    double duration;  ///< [s]
    Vec2 centre;      ///< [m] at the start, relative to the centroid now
    Vec2 velocity;    ///< [m/s] along the chord
    double radius;    ///< [m] with what the path leaves the chord by, and for rounding
  };
  /// [s]
  double horizon() const { return horizon_; }
  const Window* begin() const { return windows_.data(); }
  const Window* end() const { return windows_.data() + count_; }

 private:
  Vec2 centroid_;
  std::array<Window, kMostWindows> windows_;
  std::size_t count_;
  double horizon_;
  bool turns_;
};

}  // namespace footprint_collision_predictor::core
