#include "interval_oracle.hpp"

#include <algorithm>

#include "interval_turning.hpp"

namespace footprint_collision_predictor::test {
namespace {

constexpr double kFinest = 0x1p-32;  // [s] 2.3e-10: a bracket may need some such steps
constexpr int kMostSteps = 1000;     // what slides along by a hair for long is left undecided

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
        dx_(Interval(segment.end.x()) - Interval(segment.start.x())),
        dy_(Interval(segment.end.y()) - Interval(segment.start.y())),
        length_squared_(square(dx_) + square(dy_)),
        horizon_(horizon) {}

  Proof run() {
    if (isTouching(0))
      contact_ = 0;
    else if (explore(0, horizon_) && isTouching(horizon_))
      contact_ = horizon_;
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
    const Jet& x = disc.x;
    const Jet& y = disc.y;
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

  /// From left to right, where `low` is known not to touch. False once a contact is proven. What
  /// cannot be decided is passed, in steps that grow with the distance from the first such place.
  bool explore(double low, double high) {
    if (isFree(low, high)) return true;
    const double middle = low + 0.5 * (high - low);
    if (high - low <= finestStep(low) || middle <= low || middle >= high) {
      if (!blocked_) blocked_ = low;
      return !crosses(low, high) || found(high);
    }
    ++steps_;
    if (!explore(low, middle)) return false;
    return isTouching(middle) ? found(middle) : explore(middle, high);
  }

  double finestStep(double low) const {
    if (steps_ >= kMostSteps) return horizon_ / 256;
    return std::max(kFinest, 0.25 * (low - blocked_.value_or(low)));
  }

  bool found(double contact) {
    contact_ = contact;
    return false;
  }

  const DiscMotion& disc_;
  Interval dx_, dy_, length_squared_;
  double horizon_;
  int steps_ = 0;
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

namespace {

/// p + v t + a t^2 / 2
Jet onPath(const Interval& p, const Interval& v, double a, const Jet& t) {
  return Jet{p} + t * (Jet{v} + Interval(a / 2) * t);
}

/// Both move straight: only the difference of their velocities counts.
DiscOverTime seenFromStraight(const Case& c, const Jet& t) {
  const Motion& m = c.circle;
  const Vec2& start = c.segment.start;
  const Vec2& u = c.twist.linear;
  return {onPath(Interval(m.position.x()) - Interval(start.x()),
                 Interval(m.velocity.x()) - Interval(u.x()), m.acceleration.x(), t),
          onPath(Interval(m.position.y()) - Interval(start.y()),
                 Interval(m.velocity.y()) - Interval(u.y()), m.acceleration.y(), t),
          {}};
}

/// In the frame that turns, with the start for its origin: R(-w t) (p + v t + a t^2 / 2) less the
/// integral of R(-w t) u, where u is the velocity of the start. Taken from there nothing is large
/// where the body's own origin is far away.
DiscOverTime seenFromArc(const Case& c, const Jet& t) {
  const Motion& m = c.circle;
  const Vec2& start = c.segment.start;
  const Interval w(c.twist.angular);
  const Interval ux = Interval(c.twist.linear.x()) - w * Interval(start.y());
  const Interval uy = Interval(c.twist.linear.y()) + w * Interval(start.x());
  const Jet x = onPath(Interval(m.position.x()) - Interval(start.x()), Interval(m.velocity.x()),
                       m.acceleration.x(), t);
  const Jet y = onPath(Interval(m.position.y()) - Interval(start.y()), Interval(m.velocity.y()),
                       m.acceleration.y(), t);
  const Turning turn = turningWithin(t.value, c.twist.angular);
  return {turn.cosine * x + turn.sine * y - ux * turn.forward - uy * turn.sideways,
          turn.cosine * y - turn.sine * x - uy * turn.forward + ux * turn.sideways,
          {}};
}

}  // namespace

DiscMotion motionOf(const Case& c, double more) {
  return [c, more](const Jet& t) -> DiscOverTime {
    DiscOverTime disc = c.twist.angular == 0 ? seenFromStraight(c, t) : seenFromArc(c, t);
    disc.radius = constant(c.radius) + constant(more) + Interval(c.radius_rate) * t;
    return disc;
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
