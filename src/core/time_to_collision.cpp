// The three questions (S3): does the circle first touch one end, the other end, or the inside of
// the segment? The earliest answer is the time to collision.
//
// Every answer is held against one rule: the distance is at most the radius plus what rounding can
// amount to. The roots are sought for half of that allowance, so that no rounding on the way can
// carry a true contact past the rule, nor make it late where two roots nearly coincide.
#include "footprint_collision_predictor/time_to_collision.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "advancement.hpp"
#include "edge_contact.hpp"
#include "rounding.hpp"

namespace footprint_collision_predictor::core {
namespace {

// The touch of an end converges quadratically; a path that comes to rest on it within rounding is
// the slow case, a factor 3/4 a step, and takes less than 100 steps.
constexpr int kMaxSteps = 200;

// Window of the next step, in lengths of the last one.
constexpr double kWindow = 8;

/// c + b t + a t^2.
struct Quadratic {
  double a;
  double b;
  double c;

  double at(double t) const { return c + t * (b + t * a); }
};

Quadratic operator+(const Quadratic& x, const Quadratic& y) {
  return {x.a + y.a, x.b + y.b, x.c + y.c};
}
Quadratic operator-(const Quadratic& x, const Quadratic& y) {
  return {x.a - y.a, x.b - y.b, x.c - y.c};
}
Quadratic operator-(const Quadratic& x) { return {-x.a, -x.b, -x.c}; }

/// Rounding allowance [m] for a gap to the frame's origin.
Quadratic allowance(const Disc& d) {
  return {kRoundingAllowance * 0.5 * d.motion.acceleration.lpNorm<1>(),
          kRoundingAllowance * (d.motion.velocity.lpNorm<1>() + d.radius_rate),
          kRoundingAllowance * (d.motion.position.lpNorm<1>() + d.radius)};
}

/// A disc in the frame of an edge (S2), which starts at the origin and lies on the x axis. Relative
/// to each end the position is taken by itself, so that nothing is lost beside the other.
struct InEdgeFrame {
  Disc from_start;
  Disc from_end;
  Quadratic along;
  Quadratic across;
  Quadratic allowance;  ///< of the farther end
};

InEdgeFrame inEdgeFrame(const Edge& edge, const Disc& disc) {
  const Disc from_start = relativeTo(edge.start, disc), from_end = relativeTo(edge.end, disc);
  const Motion& m = from_start.motion;
  Quadratic slack = allowance(from_start);
  slack.c = std::max(slack.c, allowance(from_end).c);
  return {from_start,
          from_end,
          {0.5 * edge.tangent.dot(m.acceleration), edge.tangent.dot(m.velocity),
           edge.tangent.dot(m.position)},
          {0.5 * cross(edge.tangent, m.acceleration), cross(edge.tangent, m.velocity),
           cross(edge.tangent, m.position)},
          slack};
}

Quadratic radiusOf(const Disc& disc) { return {0, disc.radius_rate, disc.radius}; }

/// Half of the allowance is what roots are sought for.
Quadratic half(const Quadratic& x) { return {0.5 * x.a, 0.5 * x.b, 0.5 * x.c}; }

double distanceAt(const Edge& edge, const InEdgeFrame& f, double t) {
  const Vec2 p = f.from_start.motion.positionAt(t);
  const double along = edge.tangent.dot(p);
  if (along <= 0) return p.norm();
  if (along >= edge.length) return f.from_end.motion.positionAt(t).norm();
  return std::abs(cross(edge.tangent, p));
}

bool isTouching(const Edge& edge, const InEdgeFrame& f, double t) {
  return distanceAt(edge, f, t) <= f.from_start.radiusAt(t) + f.allowance.at(t);
}

/// With q the position relative to an end, f = |q|^2 - reach^2 is a quartic in time. From a time
/// with f > 0, the step to the first root of the parabola f + f' d + m d^2, where m <= f''/2 on all
/// that is left of the horizon: the parabola lies below f, so the step never passes a root of f,
/// and where it has none, neither has f. f''/2 is itself a convex parabola, so that m is closed
/// form. Without acceleration the parabola is f, and one step arrives.
std::optional<double> stepTowards(const Vec2& q, const Vec2& v, const Vec2& a, double reach,
                                  double reach_rate, double time_left) {
  const double a_squared = a.squaredNorm();  // 0 also for an acceleration too small to be squared
  const double lowest_at = a_squared > 0 ? std::clamp(-v.dot(a) / a_squared, 0.0, time_left) : 0;
  const double excess = q.dot(a) + lowest_at * (3 * v.dot(a) + lowest_at * 1.5 * a_squared);
  const double m = v.squaredNorm() - reach_rate * reach_rate + excess;
  const double half_slope = q.dot(v) - reach * reach_rate;
  const double distance = q.norm();
  const double f = (distance - reach) * (distance + reach);
  // Decided before any root is taken: a tiny m would underflow in it, and lead nowhere.
  if (half_slope >= 0 && f + m * time_left * time_left > 0) return std::nullopt;
  // half_slope^2 - f m cancels far from the end, and the same with the cross product cancels near
  // it, where the path bends as the rim does and m is small: each would lead past the contact.
  const double c = cross(q, v);
  const double discriminant = distance < 2 * reach
                                  ? half_slope * half_slope - f * m
                                  : (reach * v - reach_rate * q).squaredNorm() - c * c - excess * f;
  if (m > 0 && discriminant < 0) return std::nullopt;
  const double root = std::sqrt(std::max(discriminant, 0.0));
  return half_slope < 0 ? f / (root - half_slope) : (half_slope + root) / -m;
}

/// Questions (i) and (ii), S4: first touch of an end, from the disc relative to it. The parabola
/// needs to lie below only as far as it is followed: a window of some steps' length makes it steep
/// enough where a path nearly comes to rest in a graze, which takes hundreds of steps without.
std::optional<double> timeToTouchEnd(const Disc& disc, double horizon) {
  const Motion& m = disc.motion;
  const Quadratic slack = allowance(disc);
  double t = 0;
  double window = horizon;
  for (int i = 0; i < kMaxSteps; ++i) {
    const Vec2 q = m.positionAt(t);
    const double radius = disc.radiusAt(t);
    if (q.norm() <= radius + slack.at(t)) return t;
    const double left = std::min(window, horizon - t);
    const auto step = stepTowards(q, m.velocityAt(t), m.acceleration, radius + slack.at(t) / 2,
                                  disc.radius_rate, left);
    const bool lands = step && *step <= left;
    if (!lands && left >= horizon - t) return std::nullopt;
    const double advance = lands ? *step : left;
    t = std::min(t + advance, horizon);
    window = kWindow * advance;
  }
  return t;  // never later than the contact
}

/// Real roots of c + b t + a t^2, without cancellation (Press et al., "Numerical Recipes", 5.6).
/// What is not a root (a = 0, or all 0) comes out as infinite or NaN.
std::array<double, 2> rootsOf(const Quadratic& x) {
  const double q = -0.5 * (x.b + std::copysign(std::sqrt(x.b * x.b - 4 * x.a * x.c), x.b));
  return {q / x.a, x.c / q};
}

/// Question (iii), S5: the circle's centre enters the rectangle of all points within the radius of
/// the segment's inside. All four sides are asked, also the two across the ends: a centre that
/// comes from beyond an end touches that end first, but in a graze only by less than rounding, and
/// then the end may not be seen to be touched.
std::optional<double> timeToTouchInside(const Edge& edge, const InEdgeFrame& f, double horizon) {
  if (edge.length == 0) return std::nullopt;
  // With the slack as it grows with time, so that it counts in full also for a path that leads far
  // away and back.
  const Quadratic slack = half(f.allowance);
  const Quadratic reach = radiusOf(f.from_start) + slack;
  const Quadratic length{0, 0, edge.length};
  std::optional<double> first;
  for (const Quadratic& side :
       {f.across - reach, f.across + reach, f.along + slack, f.along - length - slack}) {
    for (const double t : rootsOf(side)) {
      const bool earlier = t >= 0 && t <= first.value_or(horizon);  // false for NaN
      if (earlier && isTouching(edge, f, t)) first = t;
    }
  }
  return first;
}

std::optional<double> earliest(const std::optional<double>& a, const std::optional<double>& b) {
  if (a && b) return std::min(*a, *b);
  return a ? a : b;
}

/// With acceleration most questions are answered by a few steps of advancement. What is not, a
/// graze or nearly one, is asked the three questions.
std::optional<double> timeToTouchAccelerating(const Edge& edge, const InEdgeFrame& f,
                                              double horizon) {
  constexpr std::size_t kFewSteps = 8;
  const auto slack = [&](double t) { return f.allowance.at(t); };
  const Advance advance =
      advanceToContact(EdgeBody{fromStart(edge)}, StraightPath(f.from_start.motion), f.from_start,
                       0, horizon, slack, kFewSteps);
  if (advance.outcome == Advance::kNoContact) return std::nullopt;
  if (advance.outcome == Advance::kContact) return advance.time;
  const auto time =
      earliest(timeToTouchEnd(f.from_start, horizon), timeToTouchEnd(f.from_end, horizon));
  return earliest(time, timeToTouchInside(edge, f, horizon));
}

/// Without acceleration one question is enough. Whatever touches the segment lies in the strip of
/// all points within reach of its line. The centre enters that once: between the ends it touches
/// there and then; beyond an end it cannot come between the ends without having touched this one,
/// which takes a single step.
std::optional<double> timeToTouchStraight(const Edge& edge, const InEdgeFrame& f, double horizon) {
  const Quadratic slack = half(f.allowance);
  const Quadratic reach = radiusOf(f.from_start) + slack;
  const Quadratic gap = (f.across.c < 0 ? -f.across : f.across) - reach;
  double entry = 0;
  if (gap.c > 0) {
    if (gap.at(horizon) > 0) return std::nullopt;
    entry = std::min(gap.c / -gap.b, horizon);
  }
  const double along = f.along.at(entry);
  const double beyond = along - edge.length;
  if (along >= -slack.at(entry) && beyond <= slack.at(entry)) return entry;
  const bool at_start = along < 0;
  const Motion& from_end = (at_start ? f.from_start : f.from_end).motion;
  if (const auto time =
          timeToReach(from_end.position, from_end.velocity, reach.c, reach.b, horizon))
    return time;
  // In a graze the end may be touched by less than rounding, and the inside by more thereafter.
  const double to_inside = (at_start ? -f.along.c : edge.length - f.along.c) / f.along.b;
  const bool comes_in = to_inside >= entry && to_inside <= horizon;  // false for NaN
  if (comes_in && std::abs(f.across.at(to_inside)) <= reach.at(to_inside)) return to_inside;
  return std::nullopt;
}

}  // namespace

std::optional<double> timeToReach(const Vec2& position, const Vec2& velocity, double reach,
                                  double reach_rate, double horizon) {
  if (position.norm() <= reach) return 0;
  const auto time = stepTowards(position, velocity, {0, 0}, reach, reach_rate, horizon);
  if (!time || *time > horizon) return std::nullopt;
  return *time;
}

Contact contactAt(const Edge& edge, double along, double t, double slack) {
  if (along <= slack) return {t, Feature::kStart, edge.start};
  if (along >= edge.length - slack) return {t, Feature::kEnd, edge.end};
  return {t, Feature::kInside, edge.start + along * edge.tangent};
}

double contactTolerance(const Segment& segment, const Disc& disc, double t) {
  return std::max(allowance(relativeTo(segment.start, disc)).at(t),
                  allowance(relativeTo(segment.end, disc)).at(t));
}

std::optional<Contact> timeToCollision(const Segment& segment, const Disc& disc, double horizon) {
  return timeToCollision(Edge(segment), disc, horizon);
}

std::optional<Contact> timeToCollision(const Edge& edge, const Disc& disc, double horizon) {
  const InEdgeFrame f = inEdgeFrame(edge, disc);
  const bool straight = disc.motion.acceleration == Vec2::Zero();
  const auto time =
      straight ? timeToTouchStraight(edge, f, horizon) : timeToTouchAccelerating(edge, f, horizon);
  if (!time) return std::nullopt;
  const double along = edge.tangent.dot(f.from_start.motion.positionAt(*time));
  return contactAt(edge, along, *time, f.allowance.at(*time));
}

}  // namespace footprint_collision_predictor::core
