// Interval arithmetic with outward rounding, and functions of time that are enclosed together with
// their first two derivatives.
#pragma once

#include <boost/numeric/interval.hpp>

namespace footprint_collision_predictor::test {

/// While one lives, results are rounded upwards, which all of Interval relies on (a lower bound is
/// the negative of an upper one). The compiler must know, by -frounding-math, and the arithmetic
/// must lie in a function called after this one began: compilers move plain arithmetic across calls
/// that change the rounding.
using RoundingUpwards = boost::numeric::interval<long double>::traits_type::rounding;

/// Every result encloses the true one. 64 bits rather than 53, so that few grazes stay undecided.
using Interval =
    boost::numeric::interval_lib::unprotect<boost::numeric::interval<long double>>::type;

/// A function of time on an interval of time: all its values, slopes and second derivatives there.
struct Jet {
  Interval value{0};
  Interval slope{0};
  Interval curvature{0};
};

inline Jet constant(double x) { return {Interval(x), Interval(0), Interval(0)}; }
/// Time itself.
inline Jet timeWithin(const Interval& t) { return {t, Interval(1), Interval(0)}; }

inline Jet operator+(const Jet& a, const Jet& b) {
  return {a.value + b.value, a.slope + b.slope, a.curvature + b.curvature};
}
inline Jet operator-(const Jet& a, const Jet& b) {
  return {a.value - b.value, a.slope - b.slope, a.curvature - b.curvature};
}
inline Jet operator*(const Interval& k, const Jet& a) {
  return {k * a.value, k * a.slope, k * a.curvature};
}
inline Jet operator*(const Jet& a, const Jet& b) {
  const Interval both = a.slope * b.slope;
  return {a.value * b.value, a.slope * b.value + a.value * b.slope,
          a.curvature * b.value + both + both + a.value * b.curvature};
}
/// Tighter than a * a, which does not know that both factors are the same.
inline Jet squared(const Jet& a) {
  const Interval half = square(a.slope) + a.value * a.curvature;
  return {square(a.value), Interval(2) * a.value * a.slope, half + half};
}

/// All values of a function on an interval, from itself there and at the interval's middle, which
/// lies `from_middle` off: Taylor's theorem. Halving the interval makes it tighter by a factor of
/// eight, also where the function only just touches 0.
inline Interval range(const Jet& middle, const Jet& whole, const Interval& from_middle) {
  const Interval taylor = middle.value + from_middle * middle.slope +
                          square(from_middle) * whole.curvature / Interval(2);
  return intersect(taylor, whole.value);
}

}  // namespace footprint_collision_predictor::test
