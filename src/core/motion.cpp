#include "footprint_collision_predictor/motion.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace footprint_collision_predictor::core {
namespace {

void requireWithin(const char* field, double value, double lowest, double highest) {
  if (value >= lowest && value <= highest) return;  // false for NaN
  std::ostringstream text;
  text << field << " is " << value << "; allowed is a finite number from " << lowest << " to "
       << highest;
  throw InvalidObstacle(text.str());
}

}  // namespace

Obstacle::Obstacle(const Motion& motion, double radius) : motion_(motion), radius_(radius) {
  requireWithin("position.x", motion.position.x(), -kMaxCoordinate, kMaxCoordinate);
  requireWithin("position.y", motion.position.y(), -kMaxCoordinate, kMaxCoordinate);
  requireWithin("velocity.x", motion.velocity.x(), -kMaxRate, kMaxRate);
  requireWithin("velocity.y", motion.velocity.y(), -kMaxRate, kMaxRate);
  requireWithin("acceleration.x", motion.acceleration.x(), -kMaxRate, kMaxRate);
  requireWithin("acceleration.y", motion.acceleration.y(), -kMaxRate, kMaxRate);
  requireWithin("radius", radius, 0, kMaxRadius);
}

Obstacle Obstacle::after(double dt, const Twist& footprint) const {
  Obstacle later = *this;
  later.motion_.position = relativeMotion(motion_, footprint).positionAt(dt);
  later.motion_.velocity = motion_.velocityAt(dt);
  return later;
}

Motion relativeMotion(const Motion& obstacle, const Twist& footprint) {
  return {obstacle.position, obstacle.velocity - footprint.linear, obstacle.acceleration};
}

double turningEffect(const Polygon& footprint, const Twist& twist, double horizon) {
  // A point at distance R from the frame's origin is turned by at most w t about it, and the
  // direction of travel likewise, which integrates to v w t^2 / 2.
  double reach = 0;
  for (const Vec2& vertex : footprint.vertices()) reach = std::max(reach, vertex.norm());
  return std::abs(twist.angular) * horizon * (reach + 0.5 * twist.linear.norm() * horizon);
}

}  // namespace footprint_collision_predictor::core
