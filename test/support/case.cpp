#include "case.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace footprint_collision_predictor::test {
namespace {

std::string hex(double x) {
  char text[40];
  std::snprintf(text, sizeof(text), "%a", x);
  return text;
}

std::string braced(const Vec2& v) { return "{" + hex(v.x()) + ", " + hex(v.y()) + "}"; }

}  // namespace

std::string asCode(const Case& c) {
  return "const Case c{{" + braced(c.segment.start) + ", " + braced(c.segment.end) + "},\n" +
         "             {" + braced(c.circle.position) + ", " + braced(c.circle.velocity) + ", " +
         braced(c.circle.acceleration) + "},\n             " + hex(c.radius) + ", " +
         hex(c.horizon) + ", " + hex(c.radius_rate) + ",\n             {" + braced(c.twist.linear) +
         ", " + hex(c.twist.angular) + "}};";
}

std::optional<core::Contact> ask(const Case& c) {
  const bool stands_still = c.twist.linear == Vec2{0, 0} && c.twist.angular == 0;
  if (stands_still) return core::timeToCollision(c.segment, c.disc(), c.horizon);
  return core::timeToCollision(c.segment, c.twist, c.disc(), c.horizon);
}

Vec2 startVelocity(const Case& c) {
  return c.twist.linear + c.twist.angular * core::leftNormal(c.segment.start);
}

double sizeOfCoordinates(const Case& c, double t) {
  const double turning_time = c.twist.angular == 0 ? t : 2 / std::abs(c.twist.angular);
  return (c.circle.position - c.segment.start).norm() + c.circle.velocity.norm() * t +
         c.circle.acceleration.norm() * t * t / 2 + c.disc().radiusAt(t) +
         startVelocity(c).norm() * std::min(t, turning_time) +
         (c.segment.end - c.segment.start).norm();
}

}  // namespace footprint_collision_predictor::test
