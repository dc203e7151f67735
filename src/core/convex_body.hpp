// A convex footprint as a body for advancement.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "advancement.hpp"
#include "footprint_collision_predictor/polygon.hpp"

namespace footprint_collision_predictor::core {

// So many sides are gone through at once, without a branch: what decides is different for each.
constexpr std::size_t kSidesAtOnce = 16;

/// The footprint about its centroid.
class ConvexBody {
 public:
  explicit ConvexBody(const Sides& sides) : sides_(sides) {}

  /// \param p outside, or within by no more than rounding
  Away awayFrom(const Vec2& p) const {
    std::size_t nearest = 0;
    double smallest = HUGE_VAL;
    for (std::size_t begin = 0; begin < sides_.offset.size(); begin += kSidesAtOnce) {
      const std::size_t count = std::min(kSidesAtOnce, sides_.offset.size() - begin);
      double squares[kSidesAtOnce];
      squaredDistances(p, begin, count, squares);
      for (std::size_t i = 0; i < count; ++i) {
        nearest = squares[i] < smallest ? begin + i : nearest;
        smallest = squares[i] < smallest ? squares[i] : smallest;
      }
    }
    // Where rounding has chosen a neighbour, of a short side even a farther one, it leads on from
    // there.
    const std::size_t n = sides_.offset.size();
    std::size_t previous = n;
    for (std::size_t i = 0; i < n; ++i) {
      const double beyond = beyondEnd(sides_.along(nearest, p), sides_.length[nearest]);
      if (beyond == 0) break;
      const Vec2 vector =
          sides_.across(nearest, p) * sides_.normal(nearest) + beyond * direction(nearest);
      // How far it leads beyond the side that meets this one there.
      const std::size_t other = (nearest + (beyond < 0 ? n - 1 : 1)) % n;
      const double beyond_other = std::copysign(1.0, -beyond) * direction(other).dot(vector);
      if (beyond_other > 0) return {vector, std::min(std::abs(beyond), beyond_other), nearest};
      if (other == previous) break;  // square to both, but for rounding
      previous = nearest;
      nearest = other;
    }
    const double across = sides_.across(nearest, p);
    if (across <= 0) return {{0, 0}, 0, nextTo(p)};  // within
    return {across * sides_.normal(nearest), 0, nearest};
  }

 private:
  static double beyondEnd(double along, double length) {
    const double before = along < 0 ? along : 0;
    const double after = along > length ? along - length : 0;
    return before + after;
  }

  Vec2 direction(std::size_t side) const {
    return sides_.winding * leftNormal(sides_.normal(side));
  }

  /// The side that a point within is nearest to.
  std::size_t nextTo(const Vec2& p) const {
    const auto squareTo = [&](std::size_t side) {
      const double across = sides_.across(side, p);
      const double beyond = beyondEnd(sides_.along(side, p), sides_.length[side]);
      return across * across + beyond * beyond;
    };
    std::size_t side = 0;
    for (std::size_t i = 1; i < sides_.offset.size(); ++i)
      if (squareTo(i) < squareTo(side)) side = i;
    return side;
  }

  void squaredDistances(const Vec2& p, std::size_t begin, std::size_t count,
                        double* squares) const {
    const double* normal_x = sides_.normal_x.data() + begin;
    const double* normal_y = sides_.normal_y.data() + begin;
    const double* offset = sides_.offset.data() + begin;
    const double* start = sides_.start.data() + begin;
    const double* length = sides_.length.data() + begin;
    const double px = p.x(), py = p.y(), winding = sides_.winding;
    for (std::size_t i = 0; i < count; ++i) {
      const double across = normal_x[i] * px + normal_y[i] * py - offset[i];
      const double along = winding * (normal_x[i] * py - normal_y[i] * px) - start[i];
      const double beyond = beyondEnd(along, length[i]);
      // A side that has the point behind it, between its ends, is never the nearest one; but at an
      // acute vertex rounding could tell it from the front no more.
      const bool is_behind = (across < 0) & (beyond == 0);
      squares[i] = is_behind ? HUGE_VAL : across * across + beyond * beyond;
    }
  }

  const Sides& sides_;
};

}  // namespace footprint_collision_predictor::core
