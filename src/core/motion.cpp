#include "footprint_collision_predictor/motion.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

#include "path.hpp"

namespace footprint_collision_predictor::core {
namespace {

/// Apart, so that the tests before it are inlined.
[[noreturn]] void refuse(const char* field, const char* component, double value, double lowest,
                         double highest) {
  std::ostringstream text;
  text << field << component << " is " << value << "; allowed is a finite number from " << lowest
       << " to " << highest;
  throw InvalidObstacle(text.str());
}

/// \param component of the field; empty where it has none
void requireWithin(const char* field, const char* component, double value, double lowest,
                   double highest) {
  if (value >= lowest && value <= highest) return;  // false for NaN
  refuse(field, component, value, lowest, highest);
}

void requireWithin(const char* field, const Vec2& value, double limit) {
  requireWithin(field, ".x", value.x(), -limit, limit);
  requireWithin(field, ".y", value.y(), -limit, limit);
}

}  // namespace

Obstacle::Obstacle(const Motion& motion, double radius, double radius_rate,
                   std::vector<Vec2> outline)
    : disc_{motion, radius, radius_rate}, outline_(std::move(outline)) {
  requireWithin("position", motion.position, kMaxCoordinate);
  requireWithin("velocity", motion.velocity, kMaxRate);
  requireWithin("acceleration", motion.acceleration, kMaxRate);
  requireWithin("radius", "", radius, 0, kMaxRadius);
  requireWithin("radius_rate", "", radius_rate, 0, kMaxRate);
  for (const Vec2& vertex : outline_) {
    requireWithin("outline", vertex, kMaxCoordinate);
    farthest_vertex_ = std::max(farthest_vertex_, vertex.norm());
  }
  if (outline_.size() == 1)
    throw InvalidObstacle(
        "outline has 1 vertex; allowed are none for a circle, 2 for a line, or more for a polygon");
}

Obstacle Obstacle::after(double dt, const Twist& footprint) const {
  const Motion& now = disc_.motion;
  const Turn turn(footprint.angular * dt);
  Obstacle later = *this;
  later.disc_.motion = {turn.back(now.positionAt(dt) - turn.displacement(dt * footprint.linear)),
                        turn.back(now.velocityAt(dt)), turn.back(now.acceleration)};
  later.disc_.radius = disc_.radiusAt(dt);
  for (Vec2& vertex : later.outline_) vertex = turn.back(vertex);
  return later;
}

Vec2 displacement(const Twist& twist, double dt) {
  return Turn(twist.angular * dt).displacement(dt * twist.linear);
}

Twist atPoint(const Vec2& point, const Twist& twist) {
  if (twist.angular == 0) return twist;
  // Rounded once: far from the origin these cancel.
  return {{std::fma(-twist.angular, point.y(), twist.linear.x()),
           std::fma(twist.angular, point.x(), twist.linear.y())},
          twist.angular};
}

Motion relativeMotion(const Motion& obstacle, const Twist& footprint) {
  return {obstacle.position, obstacle.velocity - footprint.linear, obstacle.acceleration};
}

}  // namespace footprint_collision_predictor::core
