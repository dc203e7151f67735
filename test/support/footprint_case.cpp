#include "footprint_case.hpp"

#include <algorithm>
#include <cstdio>

namespace footprint_collision_predictor::test {
namespace {

std::string hex(double x) {
  char text[40];
  std::snprintf(text, sizeof(text), "%a", x);
  return text;
}

std::string braced(const Vec2& v) { return "{" + hex(v.x()) + ", " + hex(v.y()) + "}"; }

std::string braced(const std::vector<Vec2>& vertices) {
  std::string text;
  for (const Vec2& v : vertices) text += (text.empty() ? "" : ", ") + braced(v);
  return "{" + text + "}";
}

double extent(const std::vector<Vec2>& vertices, const Vec2& from) {
  double largest = 0;
  for (const Vec2& v : vertices) largest = std::max(largest, (v - from).norm());
  return largest;
}

}  // namespace

std::string asCode(const FootprintCase& c) {
  const core::Motion& m = c.disc.motion;
  return "const FootprintCase c{" + braced(c.footprint) + ",\n    {" + braced(c.twist.linear) +
         ", " + hex(c.twist.angular) + "},\n    {{" + braced(m.position) + ", " +
         braced(m.velocity) + ", " + braced(m.acceleration) + "}, " + hex(c.disc.radius) + ", " +
         hex(c.disc.radius_rate) + "},\n    " + braced(c.outline) + ",\n    " + hex(c.horizon) +
         "};";
}

core::Obstacle obstacleOf(const FootprintCase& c) {
  return {c.disc.motion, c.disc.radius, c.disc.radius_rate, c.outline};
}

double sizeOfCoordinates(const FootprintCase& c, double t) {
  const core::Motion& m = c.disc.motion;
  const double lever = c.twist.angular == 0 ? 0 : c.footprint[0].norm();
  return (m.position - c.footprint[0]).norm() + (m.velocity.norm() + c.twist.linear.norm()) * t +
         m.acceleration.norm() * t * t / 2 + c.disc.radiusAt(t) + extent(c.outline, {0, 0}) +
         extent(c.footprint, c.footprint[0]) + lever;
}

}  // namespace footprint_collision_predictor::test
