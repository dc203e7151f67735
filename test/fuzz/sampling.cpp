#include "sampling.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace footprint_collision_predictor::test {
namespace {

using Real = long double;
constexpr Real kRounding = 1e-17L;   // of the size of the coordinates; some hundred roundings
constexpr Real kUnderflow = 1e-60L;  // [m] far below, products of several lengths become 0
constexpr int kSamples = 16;

struct Point {
  Real x;
  Real y;
};

Point operator+(const Point& a, const Point& b) { return {a.x + b.x, a.y + b.y}; }
Point operator-(const Point& a, const Point& b) { return {a.x - b.x, a.y - b.y}; }
Point operator*(Real k, const Point& p) { return {k * p.x, k * p.y}; }
Real dot(const Point& a, const Point& b) { return a.x * b.x + a.y * b.y; }
Point leftNormal(const Point& p) { return {-p.y, p.x}; }
Point exactly(const Vec2& v) { return {v.x(), v.y()}; }

Point fromStart(const Case& c, const Vec2& p) { return exactly(p) - exactly(c.segment.start); }

/// Of the segment's start, over ground.
Point startSpeed(const Case& c) {
  return exactly(c.twist.linear) + Real(c.twist.angular) * leftNormal(exactly(c.segment.start));
}

/// The disc's centre as seen from the segment's start, along the body's axes at t.
struct Seen {
  Point position;
  Point velocity;
};

Seen seenAt(const Case& c, Real t) {
  const Point u = startSpeed(c);
  const Point v = exactly(c.circle.velocity);
  const Point a = exactly(c.circle.acceleration);
  const Point p = fromStart(c, c.circle.position);
  const Real w = c.twist.angular;
  if (w == 0) return {p + t * ((v - u) + (t / 2) * a), v - u + t * a};
  const Real sine = std::sin(w * t), cosine = std::cos(w * t), half = std::sin(w * t / 2);
  const auto turned = [&](const Point& q) { return cosine * q - sine * leftNormal(q); };
  const Point over_ground = turned(p + t * (v + (t / 2) * a));
  const Point way = (sine / w) * u - (2 * half * half / w) * leftNormal(u);
  return {over_ground - way, turned(v + t * a - u) - w * leftNormal(over_ground)};
}

Real distanceTo(const Case& c, const Point& p) {
  const Point d = fromStart(c, c.segment.end);
  const Real length_squared = dot(d, d);
  const Real along = dot(d, p);
  if (!(along > 0)) return std::hypot(p.x, p.y);
  if (along >= length_squared) return std::hypot(p.x - d.x, p.y - d.y);
  return std::abs(dot(leftNormal(d), p)) / std::sqrt(length_squared);
}

Real gapAt(const Case& c, Real t) {
  return distanceTo(c, seenAt(c, t).position) - (Real(c.radius) + t * Real(c.radius_rate));
}

/// What rounding may make of a gap: of everything in it, also of what cancels out, and of an angle
/// of many turns.
Real rounding(const Case& c, double t) {
  const double w = std::abs(c.twist.angular);
  const double lever = c.twist.linear.norm() + w * c.segment.start.norm();
  const double way = lever * std::min(t, w == 0 ? t : 2 / w);
  return kRounding * (1 + w * t) * (sizeOfCoordinates(c, t) + way) + kUnderflow;
}

/// Evenly, halving towards both ends of the horizon, and where the path passes an end or the middle
/// of the segment.
std::vector<Real> sampleTimes(const Case& c) {
  std::vector<Real> times{0, c.horizon};
  for (int i = 1; i < kSamples; ++i) {
    times.push_back(Real(c.horizon) * i / kSamples);
    times.push_back(std::ldexp(Real(c.horizon), -3 * i));
  }
  const Vec2 middle = c.segment.start + 0.5 * (c.segment.end - c.segment.start);
  for (const Vec2& target : {c.segment.start, c.segment.end, middle}) {
    Real t = 0;
    for (int i = 0; i < 4; ++i) {  // whatever bends the path is taken in by repeating
      const Seen seen = seenAt(c, t);
      const Point way = seen.position - fromStart(c, target);
      t -= dot(seen.velocity, way) / dot(seen.velocity, seen.velocity);
      if (!(t >= 0 && t <= c.horizon)) break;
      times.push_back(t);
    }
  }
  return times;
}

bool isFinite(const core::Contact& contact, double horizon) {
  return contact.time >= 0 && contact.time <= horizon && contact.point.allFinite();
}

/// By the guarantee.
Real allowedGap(const Case& c, double t) {
  return (c.twist.angular == 0 ? 1e-9 : 1e-6) * std::max(1.0, sizeOfCoordinates(c, t));
}

/// What the core promises of itself, twice, since it decides in double.
Real promisedGap(const Case& c, double t) {
  if (c.twist.angular != 0) return allowedGap(c, t);
  const Disc seen{relativeMotion(c.circle, c.twist), c.radius, c.radius_rate};
  return 2 * contactTolerance(c.segment, seen, t);
}

std::string invented(const Case& c, const core::Contact& contact,
                     Real (*tolerance)(const Case&, double)) {
  if (!isFinite(contact, c.horizon)) return "no time within the horizon, or no point";
  const Real allowed = tolerance(c, contact.time) + rounding(c, contact.time);
  if (!(gapAt(c, contact.time) <= allowed))
    return "invented: a gap is left at " + std::to_string(contact.time);
  const Real of_point = 0x1p-51L * contact.point.norm();
  if (!(distanceTo(c, fromStart(c, contact.point)) <= allowed + of_point))
    return "the point is not on the segment";
  return "";
}

}  // namespace

std::string inventedBySampling(const Case& c, const core::Contact& contact) {
  return invented(c, contact, allowedGap);
}

std::string missedBySampling(const Case& c, const std::optional<core::Contact>& contact) {
  for (const Real t : sampleTimes(c)) {
    if (!(gapAt(c, t) < -rounding(c, static_cast<double>(t)))) continue;
    if (!contact) return "missed: overlaps at " + std::to_string(t);
    if (contact->time > t + 1e-9L * std::max(Real(1), t))
      return "late: reported " + std::to_string(contact->time) + ", overlaps at " +
             std::to_string(t);
  }
  return "";
}

std::string wrongBySampling(const Case& c, const std::optional<core::Contact>& contact) {
  const std::string wrong = contact ? invented(c, *contact, promisedGap) : "";
  return wrong.empty() ? missedBySampling(c, contact) : wrong;
}

}  // namespace footprint_collision_predictor::test
