// The three questions (S3): does the circle first touch one end, the other end, or the inside of
// the segment? The earliest answer is the time to collision.
//
// Every answer is checked by one predicate, isTouching(): the distance is at most the radius plus
// what rounding can amount to. The roots are sought for half of that allowance, so that no rounding
// on the way can carry a true contact past the predicate, nor make it late where two roots nearly
// coincide.
#include "footprint_collision_predictor/time_to_collision.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace footprint_collision_predictor::core {
namespace {

// Each of the some ten operations from the input to a gap errs by at most half an epsilon of the
// terms summed up in contactTolerance(); half of 32 leaves room for both the gap and the root.
constexpr double kRoundingAllowance = 32 * std::numeric_limits<double>::epsilon();

// The touch of an end converges quadratically; a path that comes to rest on it within rounding is
// the slow case, a factor 3/4 a step, and takes less than 100 steps.
constexpr int kMaxSteps = 200;

// Window of the next step, in lengths of the last one.
constexpr double kWindow = 8;

/// Rounding allowance [m] for a gap to a point, from the motion relative to it.
double allowance(const Motion& m, double radius, double t) {
  return kRoundingAllowance * (radius + m.position.lpNorm<1>() +
                               t * (m.velocity.lpNorm<1>() + 0.5 * t * m.acceleration.lpNorm<1>()));
}

Motion relativeTo(const Vec2& point, const Motion& m) {
  return {m.position - point, m.velocity, m.acceleration};
}

Segment fromStart(const Segment& segment) { return {Vec2::Zero(), segment.end - segment.start}; }

bool isTouching(const Segment& segment, const Motion& circle, double radius, double t) {
  // From the start, so that a position far from the origin costs no digits.
  const Vec2 centre = relativeTo(segment.start, circle).positionAt(t);
  return distance(fromStart(segment), centre) <=
         radius + contactTolerance(segment, circle, radius, t);
}

/// With q the position relative to an end, f = |q|^2 - reach^2 is a quartic in time. From a time
/// with f > 0, the step to the first root of the parabola f + f' d + m d^2, where m <= f''/2 on all
/// that is left of the horizon: the parabola lies below f, so the step never passes a root of f,
/// and where it has none, neither has f. f''/2 is itself a convex parabola, so that m is closed
/// form. Without acceleration the parabola is f, and one step arrives.
std::optional<double> stepTowards(const Vec2& q, const Vec2& v, const Vec2& a, double reach,
                                  double time_left) {
  const double a_squared = a.squaredNorm();  // 0 also for an acceleration too small to be squared
  const double lowest_at = a_squared > 0 ? std::clamp(-v.dot(a) / a_squared, 0.0, time_left) : 0;
  const double excess = q.dot(a) + lowest_at * (3 * v.dot(a) + lowest_at * 1.5 * a_squared);
  const double m = v.squaredNorm() + excess;
  const double half_slope = q.dot(v);
  const double f = (q.norm() - reach) * (q.norm() + reach);
  // Decided before any root is taken: a tiny m would underflow in it, and lead nowhere.
  if (half_slope >= 0 && f + m * time_left * time_left > 0) return std::nullopt;
  // half_slope^2 - f m cancels far from the end, and the same with the cross product cancels near
  // it, where the path bends as the rim does and m is small: each would lead past the contact.
  const double c = cross(q, v);
  const double discriminant = q.norm() < 2 * reach
                                  ? half_slope * half_slope - f * m
                                  : reach * reach * m - c * c - excess * q.squaredNorm();
  if (m > 0 && discriminant < 0) return std::nullopt;
  const double root = std::sqrt(std::max(discriminant, 0.0));
  return half_slope < 0 ? f / (root - half_slope) : (half_slope + root) / -m;
}

/// Questions (i) and (ii), S4: first touch of an end, from the motion relative to it. The parabola
/// needs to lie below only as far as it is followed: a window of some steps' length makes it steep
/// enough where a path nearly comes to rest in a graze, which takes hundreds of steps without.
std::optional<double> timeToTouchEnd(const Motion& m, double radius, double horizon) {
  double t = 0;
  double window = horizon;
  for (int i = 0; i < kMaxSteps; ++i) {
    const Vec2 q = m.positionAt(t);
    const double slack = allowance(m, radius, t);
    if (q.norm() <= radius + slack) return t;
    const double left = std::min(window, horizon - t);
    const auto step = stepTowards(q, m.velocityAt(t), m.acceleration, radius + slack / 2, left);
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
std::array<double, 2> rootsOf(double a, double b, double c) {
  const double q = -0.5 * (b + std::copysign(std::sqrt(b * b - 4 * a * c), b));
  return {q / a, c / q};
}

/// One coordinate of the centre as it moves: c + b t + a t^2.
struct Coordinate {
  double a;
  double b;
  double c;
};

/// contactTolerance() / 2 as it grows with time, so that it counts in full also for a path that
/// leads far away and back.
Coordinate halfTolerance(const Segment& segment, const Motion& m, double radius) {
  const double half = kRoundingAllowance / 2;
  return {half * 0.5 * m.acceleration.lpNorm<1>(), half * m.velocity.lpNorm<1>(),
          contactTolerance(segment, m, radius, 0) / 2};
}

/// Question (iii), S5: the circle's centre enters the rectangle of all points within the radius of
/// the segment's inside. All four sides are asked, also the two across the ends: a centre that
/// comes from beyond an end touches that end first, but in a graze only by less than rounding, and
/// then the end may not be seen to be touched.
std::optional<double> timeToTouchInside(const Segment& segment, const Motion& circle, double radius,
                                        double horizon) {
  const Vec2 direction = segment.end - segment.start;
  const double length = direction.norm();
  if (length == 0) return std::nullopt;
  const Vec2 tangent = direction / length;
  const Vec2 p = circle.position - segment.start;
  const Coordinate across{0.5 * cross(tangent, circle.acceleration),
                          cross(tangent, circle.velocity), cross(tangent, p)};
  const Coordinate along{0.5 * tangent.dot(circle.acceleration), tangent.dot(circle.velocity),
                         tangent.dot(p)};
  const Coordinate slack = halfTolerance(segment, circle, radius);
  std::optional<double> first;
  const auto ask = [&](const Coordinate& x, double side, double sign) {
    for (const double t :
         rootsOf(x.a - sign * slack.a, x.b - sign * slack.b, x.c - (side + sign * slack.c))) {
      const bool earlier = t >= 0 && t <= first.value_or(horizon);  // false for NaN
      if (earlier && isTouching(segment, circle, radius, t)) first = t;
    }
  };
  ask(across, radius, 1);
  ask(across, -radius, -1);
  ask(along, 0, -1);
  ask(along, length, 1);
  return first;
}

Contact contactAt(const Segment& segment, const Motion& circle, double radius, double t) {
  const Vec2 along =
      closestPoint(fromStart(segment), relativeTo(segment.start, circle).positionAt(t));
  const double slack = contactTolerance(segment, circle, radius, t);
  if (along.norm() <= slack) return {t, Feature::kStart, segment.start};
  if ((along - (segment.end - segment.start)).norm() <= slack)
    return {t, Feature::kEnd, segment.end};
  return {t, Feature::kInside, segment.start + along};
}

std::optional<double> earliest(const std::optional<double>& a, const std::optional<double>& b) {
  if (a && b) return std::min(*a, *b);
  return a ? a : b;
}

}  // namespace

double contactTolerance(const Segment& segment, const Motion& circle, double radius, double t) {
  return std::max(allowance(relativeTo(segment.start, circle), radius, t),
                  allowance(relativeTo(segment.end, circle), radius, t));
}

std::optional<Contact> timeToCollision(const Segment& segment, const Motion& circle, double radius,
                                       double horizon) {
  std::optional<double> time;
  if (isTouching(segment, circle, radius, 0)) {
    time = 0;
  } else {
    time = earliest(timeToTouchEnd(relativeTo(segment.start, circle), radius, horizon),
                    timeToTouchEnd(relativeTo(segment.end, circle), radius, horizon));
    time = earliest(time, timeToTouchInside(segment, circle, radius, horizon));
  }
  if (!time) return std::nullopt;
  return contactAt(segment, circle, radius, *time);
}

}  // namespace footprint_collision_predictor::core
