#include "footprint_collision_predictor/geometry.hpp"

#include <cmath>
#include <limits>

namespace footprint_collision_predictor::core {
namespace {

// Both from segment.start, so that nothing is lost far from the origin.
double nearestFraction(const Vec2& direction, const Vec2& p) {
  const double along = direction.dot(p);
  const double length_squared = direction.squaredNorm();
  if (along <= 0) return 0;
  return along >= length_squared ? 1 : along / length_squared;
}

}  // namespace

Edge::Edge(const Segment& segment)
    : Segment(segment), tangent(1, 0), length((segment.end - segment.start).norm()) {
  if (length > 0) tangent = (segment.end - segment.start) / length;
}

int orientation(const Vec2& a, const Vec2& b, const Vec2& c) {
  // The error bound is Shewchuk's, "Adaptive Precision Floating-Point Arithmetic", 1997.
  const double left = (a.x() - c.x()) * (b.y() - c.y());
  const double right = (a.y() - c.y()) * (b.x() - c.x());
  constexpr double kBound = 4 * std::numeric_limits<double>::epsilon();
  constexpr double kUnderflow = std::numeric_limits<double>::min();  // his bound leaves it out
  const double turn = left - right;
  if (std::abs(turn) <= kBound * (std::abs(left) + std::abs(right)) + kUnderflow) return 0;
  return turn > 0 ? 1 : -1;
}

Vec2 closestPoint(const Segment& segment, const Vec2& p) {
  const Vec2 direction = segment.end - segment.start;
  const double fraction = nearestFraction(direction, p - segment.start);
  if (fraction == 1) return segment.end;
  return segment.start + fraction * direction;
}

double distance(const Segment& segment, const Vec2& p) {
  const Vec2 direction = segment.end - segment.start;
  const Vec2 from_start = p - segment.start;
  const double fraction = nearestFraction(direction, from_start);
  if (fraction == 0) return from_start.norm();
  if (fraction == 1) return (p - segment.end).norm();
  return std::abs(cross(direction, from_start)) / direction.norm();
}

}  // namespace footprint_collision_predictor::core
