// Plane geometry shared by everything else: vectors and segments.
#pragma once

#include <Eigen/Core>

namespace footprint_collision_predictor::core {

using Vec2 = Eigen::Vector2d;

/// A straight line from start to end [m]. Both ends belong to it; start == end is the single point.
struct Segment {
  Vec2 start;
  Vec2 end;
};

/// A segment together with what every question about it needs.
struct Edge : Segment {
  explicit Edge(const Segment& segment);

  Vec2 tangent;   ///< unit vector from start to end; any when they are the same point
  double length;  ///< [m]
};

/// z component of a x b: positive when b points to the left of a.
inline double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// v turned by +90 degrees.
inline Vec2 leftNormal(const Vec2& v) { return {-v.y(), v.x()}; }

/// Sign of the turn a -> b -> c: 1 left, -1 right, 0 when rounding cannot tell it from straight.
/// What counts as straight is least where c is the middle one, which is the same turn.
int orientation(const Vec2& a, const Vec2& b, const Vec2& c);

/// The point of the segment nearest to p. The ends are returned exactly, never merely nearly.
Vec2 closestPoint(const Segment& segment, const Vec2& p);

/// Distance from p to the nearest point of the segment [m].
double distance(const Segment& segment, const Vec2& p);

}  // namespace footprint_collision_predictor::core
