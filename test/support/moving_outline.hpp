// An obstacle as it moves in the frame of a footprint that drives and turns.
#pragma once

#include <cstddef>
#include <vector>

#include "footprint_case.hpp"
#include "plane.hpp"

namespace footprint_collision_predictor::test {

/// At one time, along the axes that the footprint's frame has then.
struct OutlineNow {
  std::vector<Point> vertices;
  Point velocity;  ///< over ground, less that of the footprint's origin
  Real radius;

  std::size_t edges() const { return vertices.size() < 3 ? 1 : vertices.size(); }
  std::size_t endOf(std::size_t edge) const { return (edge + 1) % vertices.size(); }
  Line edge(std::size_t i) const { return {vertices[i], vertices[endOf(i)]}; }
};

/// q(t) = R(-w t) (p + v t + a t^2 / 2 - s(t)), s(t) = sin(w t) / w u + (1 - cos(w t)) / w left(u).
class MovingOutline {
 public:
  /// A disc is an outline of one vertex.
  /// \param origin of all coordinates, in the footprint's frame; where it turns, that of the frame
  explicit MovingOutline(const FootprintCase& c, const Point& origin = {0, 0});

  OutlineNow at(Real t) const;
  Real radiusRate() const { return radius_rate_; }

  /// Velocity of an outline's vertex in the footprint's frame.
  Point seenFromFootprint(const Point& vertex, const Point& velocity) const;
  /// A bound on how that velocity changes within `dt` [m/s^2].
  Real bendSeenFromFootprint(const Point& vertex, const Point& velocity, Real dt) const;
  /// Velocity of the outline less that of a point of the footprint, along axes that do not turn.
  Point seenFromGround(const Point& of_footprint, const Point& velocity) const;
  Real bendSeenFromGround(const Point& of_footprint) const;

 private:
  Point travelled(Real t) const;

  std::vector<Point> vertices_;
  Point velocity_, acceleration_, driving_;
  Real turning_;
  Real radius_, radius_rate_;
  Real pull_;  // a bound on the acceleration over ground, less that of the footprint's origin
};

}  // namespace footprint_collision_predictor::test
