#include "case.hpp"

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
         hex(c.horizon) + "};";
}

double sizeOfCoordinates(const Case& c, double t) {
  return (c.circle.position - c.segment.start).norm() + c.circle.velocity.norm() * t +
         c.circle.acceleration.norm() * t * t / 2 + c.radius +
         (c.segment.end - c.segment.start).norm();
}

}  // namespace footprint_collision_predictor::test
