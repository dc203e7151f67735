// An obstacle and a footprint within a window of time, as the broad phase sees them: two circles
// that move along chords. What decides is how far apart they are when they are nearest, or, when
// the obstacle grows, the sign of a quadratic.
#pragma once

#include <algorithm>
#include <cmath>

#include "rounding.hpp"

namespace footprint_collision_predictor::core {

/// An obstacle about the footprint's circle within a window: a point that moves straight, and how
/// near [m] to the origin it touches. Plain numbers, several of which share a register.
template <typename Real>
struct Chord {
  Real px, py;  ///< [m]
  Real vx, vy;  ///< [m/s]
  Real reach;   ///< [m]
};

/// Square of a reach, for comparisons: nothing is within a negative one, which is that of a gap
/// that only overlaps can have.
template <typename Real>
[[gnu::always_inline]] inline Real squared(Real reach) {
  return reach * std::abs(reach);
}

/// By where the point is nearest.
[[gnu::always_inline]] inline bool mayTouch(const Chord<float>& c, float duration) {
  const float nearest = -(c.px * c.vx + c.py * c.vy) / (c.vx * c.vx + c.vy * c.vy);
  const float from_now = nearest > 0 ? nearest : 0;  // also for NaN: it stands still
  const float t = from_now < duration ? from_now : duration;
  const float x = c.px + t * c.vx, y = c.py + t * c.vy;
  return x * x + y * y <= squared(c.reach);
}

/// The same with both sides multiplied by the square of the speed, which spares the division, and
/// with an allowance for rounding.
[[gnu::always_inline]] inline bool mayTouch(const Chord<double>& c, double duration) {
  constexpr double kStanding = 1e-200;  // [m^2/s^2] what stands still is judged by where it is
  const double p2 = c.px * c.px + c.py * c.py;
  const double v2 = c.vx * c.vx + c.vy * c.vy + kStanding;
  const double along = c.px * c.vx + c.py * c.vy;
  const double closing = 0.5 * (std::abs(along) - along);  // the larger of -along and 0
  const double way = std::min(closing, duration * v2);
  return p2 * v2 + way * (way + 2 * along) <= (squared(c.reach) + kGenerous * p2) * v2;
}

/// By the sign of a quadratic. The reach grows at a rate [m/s].
[[gnu::always_inline]] inline bool mayTouchGrowing(const Chord<double>& c, double rate,
                                                   double duration) {
  // |p + v t|^2 - (reach + rate t)^2 = f + 2 h t + m t^2, and its discriminant as a sum of squares
  // of cross products, which does not cancel far away.
  const double p2 = c.px * c.px + c.py * c.py;
  const double reach2 = c.reach * c.reach;
  const double f = p2 - reach2;
  const double h = c.px * c.vx + c.py * c.vy - c.reach * rate;
  const double m = c.vx * c.vx + c.vy * c.vy - rate * rate;
  const double speeds = c.vx * c.vx + c.vy * c.vy + rate * rate;
  const double cross = c.px * c.vy - c.py * c.vx;
  const double x = c.reach * c.vx - rate * c.px, y = c.reach * c.vy - rate * c.py;
  const double discriminant = x * x + y * y - cross * cross;
  const double at_end = f + duration * (2 * h + duration * m);
  const double size = kGenerous * (p2 + reach2);
  const double rounding = size + kGenerous * duration * duration * speeds;
  const bool at_the_ends = (f <= rounding) | (at_end <= rounding);
  const bool between = (h <= 0) & (h + m * duration >= 0) & (discriminant >= -size * speeds);
  return (at_the_ends | between) & (c.reach >= 0);
}

/// For a single one.
[[gnu::always_inline]] inline bool mayTouch(const Chord<double>& c, double rate, double duration) {
  return rate == 0 ? mayTouch(c, duration) : mayTouchGrowing(c, rate, duration);
}

}  // namespace footprint_collision_predictor::core
