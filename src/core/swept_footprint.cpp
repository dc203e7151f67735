#include "swept_footprint.hpp"

#include <cmath>

#include "path.hpp"
#include "rounding.hpp"

namespace footprint_collision_predictor::core {

SweptFootprint::SweptFootprint(const Polygon& footprint, const Twist& twist, double horizon,
                               double obstacle_acceleration)
    : centroid_(footprint.centroid()), count_(1), horizon_(horizon), turns_(twist.angular != 0) {
  const Twist centroid = atPoint(centroid_, twist);
  const double speed = centroid.linear.norm();
  const double acceleration = std::abs(twist.angular) * speed;
  const double radius = footprint.boundingRadius();
  // As many as make the bulges some tenths of the footprint: more cost more than they save.
  const double bulge = (acceleration + obstacle_acceleration) * horizon * horizon / 8;
  while (count_ < kMostWindows && bulge > 0.5 * radius * static_cast<double>(count_ * count_))
    ++count_;
  const double duration = horizon / static_cast<double>(count_);
  const double own_bulge = acceleration * duration * duration / 8;
  const double tolerance = turns_ ? kTurningTolerance : 0;
  const Turn turn(twist.angular * duration);
  Vec2 centre(0, 0), velocity = turn.displacement(centroid.linear);
  for (std::size_t i = 0; i < count_; ++i) {
    const double start = static_cast<double>(i) * duration;
    const double rounding = kGenerous * (radius + (start + duration) * speed) + tolerance;
    windows_[i] = {start, duration, centre, velocity, radius + own_bulge + rounding};
    centre += duration * velocity;
    velocity = turn(velocity);
  }
}

}  // namespace footprint_collision_predictor::core
