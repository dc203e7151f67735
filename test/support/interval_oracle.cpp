#include "interval_oracle.hpp"

#include <algorithm>

namespace footprint_collision_predictor::test {
namespace {

constexpr double kFinest = 0x1p-32;  // [s] 2.3e-10: a bracket may need some such steps

/// A disc touches a segment when its centre lies in one of three sets: the discs round the two ends
/// and the strip between them. Everything is squared, so that no root has to be taken.
struct Distances {
  Jet from_start;  // squared, minus the radius squared
  Jet from_end;
  Jet side;    // signed distance from the line, times length
  Jet across;  // its square, minus radius squared times length squared
  Jet along;   // from the start, times length
  Jet beyond;  // along, minus length squared
};

class Prover {
 public:
  Prover(const Segment& segment, const DiscMotion& disc, double horizon)
      : disc_(disc),
        start_x_(segment.start.x()),
        start_y_(segment.start.y()),
        dx_(Interval(segment.end.x()) - start_x_),
        dy_(Interval(segment.end.y()) - start_y_),
        length_squared_(square(dx_) + square(dy_)),
        horizon_(horizon) {}

  Proof run() {
    if (explore(0, horizon_) && isTouching(horizon_)) contact_ = horizon_;
    const double free_until = blocked_.value_or(contact_.value_or(horizon_));
    return {free_until, contact_, !blocked_ && !contact_};
  }

  bool isFree(double low, double high) const {
    const double m = low + 0.5 * (high - low);
    const Distances middle = distances(Interval(m));
    const Distances whole = distances(Interval(low, high));
    const Interval s = Interval(low, high) - Interval(m);
    const auto of = [&](Jet Distances::*f) { return range(middle.*f, whole.*f, s); };
    return of(&Distances::from_start).lower() > 0 && of(&Distances::from_end).lower() > 0 &&
           (of(&Distances::across).lower() > 0 || of(&Distances::along).upper() <= 0 ||
            of(&Distances::beyond).lower() >= 0);
  }

 private:
  Distances distances(const Interval& t) const {
    const DiscOverTime disc = disc_(timeWithin(t));
    const Jet x = disc.x - Jet{start_x_};
    const Jet y = disc.y - Jet{start_y_};
    const Jet reach = squared(disc.radius);
    const Jet along = dx_ * x + dy_ * y;
    const Jet side = dx_ * y - dy_ * x;
    return {squared(x) + squared(y) - reach,
            squared(x - Jet{dx_}) + squared(y - Jet{dy_}) - reach,
            side,
            squared(side) - length_squared_ * reach,
            along,
            along - Jet{length_squared_}};
  }

  bool isTouching(double t) const {
    const Distances d = distances(Interval(t));
    const bool strip = length_squared_.lower() > 0 && d.across.value.upper() <= 0 &&
                       d.along.value.lower() >= 0 && d.beyond.value.upper() <= 0;
    return strip || d.from_start.value.upper() <= 0 || d.from_end.value.upper() <= 0;
  }

  /// Crosses the segment in between, which is all that can be proven of a point without a radius.
  bool crosses(double low, double high) const {
    const Interval before = distances(Interval(low)).side.value;
    const Interval after = distances(Interval(high)).side.value;
    const Distances whole = distances(Interval(low, high));
    return whole.along.value.lower() >= 0 && whole.beyond.value.upper() <= 0 &&
           ((before.upper() < 0 && after.lower() > 0) || (before.lower() > 0 && after.upper() < 0));
  }

  /// From left to right. False once a contact is proven. What cannot be decided is passed, in steps
  /// that grow with the distance from the first such place.
  bool explore(double low, double high) {
    if (isFree(low, high)) return true;
    if (isTouching(low)) {
      contact_ = low;
      return false;
    }
    const double middle = low + 0.5 * (high - low);
    const double finest = std::max(kFinest, 0.25 * (low - blocked_.value_or(low)));
    if (high - low <= finest || middle <= low || middle >= high) {
      if (!blocked_) blocked_ = low;
      if (!crosses(low, high)) return true;
      contact_ = high;
      return false;
    }
    return explore(low, middle) && explore(middle, high);
  }

  const DiscMotion& disc_;
  Interval start_x_, start_y_, dx_, dy_, length_squared_;
  double horizon_;
  std::optional<double> blocked_;
  std::optional<double> contact_;
};

// Not inlined: see RoundingUpwards.
[[gnu::noinline]] Proof proveRounded(const Segment& segment, const DiscMotion& disc,
                                     double horizon) {
  return Prover(segment, disc, horizon).run();
}

[[gnu::noinline]] bool isFreeRounded(const Segment& segment, const DiscMotion& disc, double t) {
  return Prover(segment, disc, t).isFree(t, t);
}

}  // namespace

DiscMotion motionOf(const Case& c, double more) {
  const Motion m = c.circle;
  const double radius = c.radius;
  return [m, radius, more](const Jet& t) -> DiscOverTime {
    const auto coordinate = [&t](double p, double v, double a) {
      return constant(p) + t * (constant(v) + Interval(a / 2) * t);
    };
    return {coordinate(m.position.x(), m.velocity.x(), m.acceleration.x()),
            coordinate(m.position.y(), m.velocity.y(), m.acceleration.y()),
            constant(radius) + constant(more)};
  };
}

Proof prove(const Segment& segment, const DiscMotion& disc, double horizon) {
  const RoundingUpwards rounding;
  return proveRounded(segment, disc, horizon);
}

Proof prove(const Case& c) { return prove(c.segment, motionOf(c), c.horizon); }

bool isProvenApart(const Case& c, double t, double gap) {
  const DiscMotion disc = motionOf(c, gap);
  const RoundingUpwards rounding;
  return isFreeRounded(c.segment, disc, t);
}

}  // namespace footprint_collision_predictor::test
