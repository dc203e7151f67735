// Sine and cosine of intervals, and what they make of a body that turns: every result encloses the
// true one, by proof. The library's sin and cos are not used, since nothing is proven of their
// rounding.
#pragma once

#include <cmath>

#include "interval.hpp"

namespace footprint_collision_predictor::test {

/// 1 - x / (n (n + 1)) (1 - x / ((n + 2)(n + 3)) (1 - ...)) for x in [0, 1]. Every bracket lies in
/// [0, 1], so that the innermost one, which stands for all terms left out, does too.
///
/// With x = angle^2: n = 2 is sine / angle, and 3 is 2 (1 - cosine) / x.
inline Interval alternatingSeries(const Interval& x, int n) {
  Interval brackets(0, 1);
  for (int k = n + 18; k >= n; k -= 2)
    brackets = Interval(1) - x * brackets / static_cast<long double>(k * (k + 1));
  return brackets;
}

/// Of a small angle, with x = angle^2 <= 1. In the shares no angle is left to divide by.
struct SmallTurn {
  Interval sine_share;    // sine / angle
  Interval cosine_share;  // (1 - cosine) / angle^2

  explicit SmallTurn(const Interval& x)
      : sine_share(alternatingSeries(x, 2)), cosine_share(alternatingSeries(x, 3) / 2.0L) {}
};

struct SineAndCosine {
  Interval sine{-1, 1};
  Interval cosine{-1, 1};
};

/// Of an angle [rad] known to better than a tenth; else it is not told. Whole quarters of a turn
/// are taken off by their first 33 bits, times a count below 2^31 exact, and an enclosure of their
/// rest. That is so for any count: that it is the nearest one need not be proven.
inline SineAndCosine ofNarrow(const Interval& angle) {
  constexpr long double kQuarter =
      0x1.921fb544p0L;  // pi / 2 = 1.921fb544 42d18469 898cc517 01b8...
  const Interval rest(0x0.42d18469898cc517p-32L, 0x0.42d18469898cc518p-32L);
  const long double count = std::floor(median(angle) / kQuarter + 0.5L);
  const Interval left = angle - Interval(count) * Interval(kQuarter) - Interval(count) * rest;
  const Interval x = square(left);
  if (!(x.upper() <= 1)) return {};
  const SmallTurn small(x);
  const Interval sine = left * small.sine_share;
  const Interval cosine = Interval(1) - x * small.cosine_share;
  switch ((static_cast<int>(std::fmod(count, 4.0L)) + 4) % 4) {
    case 0:
      return {sine, cosine};
    case 1:
      return {cosine, -sine};
    case 2:
      return {-sine, -cosine};
    default:
      return {-cosine, sine};
  }
}

/// From an angle to one that is larger by h: |sin h| <= |h| and 1 - h^2 / 2 <= cos h <= 1.
inline SineAndCosine furtherBy(const Interval& h, const SineAndCosine& from) {
  const Interval all(-1, 1);
  const Interval sine = intersect(hull(h, -h), all);
  const Interval cosine = intersect(Interval(1) - square(h) / 2.0L, all);
  return {intersect(from.sine * cosine + from.cosine * sine, all),
          intersect(from.cosine * cosine - from.sine * sine, all)};
}

/// For a yaw rate w, functions of time.
struct Turning {
  Jet sine;      // sin(w t)
  Jet cosine;    // cos(w t)
  Jet forward;   // sin(w t) / w, the integral of the cosine: t for w = 0
  Jet sideways;  // (1 - cos(w t)) / w, the integral of the sine: 0 for w = 0
};

/// The values alone, at one time.
struct TurningAtOnce {
  SineAndCosine turned;
  Interval forward;
  Interval sideways;
};

inline TurningAtOnce turningAt(const Interval& t, const Interval& w) {
  const Interval angle = w * t;
  const Interval x = square(angle);
  if (x.upper() <= 0.5L) {
    const SmallTurn small(x);
    return {{angle * small.sine_share, Interval(1) - x * small.cosine_share},
            t * small.sine_share,
            t * angle * small.cosine_share};
  }
  const SineAndCosine turned = ofNarrow(angle);
  return {turned, turned.sine / w, (Interval(1) - turned.cosine) / w};
}

/// Over an interval of time, from its middle: the integrals by the mean value theorem.
inline Turning turningWithin(const Interval& t, double yaw_rate) {
  const Interval w(yaw_rate);
  const Interval middle(median(t));
  const Interval off = t - middle;
  const TurningAtOnce at = turningAt(middle, w);
  const auto [sine, cosine] = furtherBy(w * off, at.turned);
  const Interval wc = w * cosine;
  const Interval ws = w * sine;
  return {{sine, wc, -(w * ws)},
          {cosine, -ws, -(w * wc)},
          {at.forward + off * cosine, cosine, -ws},
          {at.sideways + off * sine, sine, wc}};
}

}  // namespace footprint_collision_predictor::test
