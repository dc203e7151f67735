#include "sampling.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace footprint_collision_predictor::test {
namespace {

using Real = long double;
constexpr Real kRounding = 1e-17L;   // of the size of the coordinates; some hundred roundings
constexpr Real kUnderflow = 1e-60L;  // [m] far below, products of several lengths become 0
constexpr int kSamples = 24;

struct Point {
  Real x;
  Real y;
};

/// The centre relative to the segment's start.
Point centreAt(const Case& c, Real t) {
  const auto coordinate = [t](Real p, Real start, Real v, Real a) {
    return (p - start) + t * (v + t * a / 2);
  };
  const Motion& m = c.circle;
  const Vec2& start = c.segment.start;
  return {coordinate(m.position.x(), start.x(), m.velocity.x(), m.acceleration.x()),
          coordinate(m.position.y(), start.y(), m.velocity.y(), m.acceleration.y())};
}

Point fromStart(const Case& c, const Vec2& p) {
  return {Real(p.x()) - Real(c.segment.start.x()), Real(p.y()) - Real(c.segment.start.y())};
}

Real distanceTo(const Case& c, const Point& p) {
  const Point d = fromStart(c, c.segment.end);
  const Real length_squared = d.x * d.x + d.y * d.y;
  const Real along = d.x * p.x + d.y * p.y;
  if (!(along > 0)) return std::hypot(p.x, p.y);
  if (along >= length_squared) return std::hypot(p.x - d.x, p.y - d.y);
  return std::abs(d.x * p.y - d.y * p.x) / std::sqrt(length_squared);
}

Real gapAt(const Case& c, Real t) { return distanceTo(c, centreAt(c, t)) - Real(c.radius); }

/// Evenly, halving towards both ends of the horizon, and where the path passes an end or the middle
/// of the segment.
std::vector<Real> sampleTimes(const Case& c) {
  std::vector<Real> times{0, c.horizon};
  for (int i = 1; i < kSamples; ++i) {
    times.push_back(Real(c.horizon) * i / kSamples);
    times.push_back(std::ldexp(Real(c.horizon), -2 * i));
  }
  const Vec2 middle = c.segment.start + 0.5 * (c.segment.end - c.segment.start);
  for (const Vec2& target : {c.segment.start, c.segment.end, middle}) {
    Real t = 0;
    for (int i = 0; i < 4; ++i) {  // the acceleration is taken in by repeating
      const Point p = centreAt(c, t), to = fromStart(c, target);
      const Vec2 v = c.circle.velocityAt(static_cast<double>(t));
      const Real step = (v.x() * (p.x - to.x) + v.y() * (p.y - to.y)) / Real(v.squaredNorm());
      t -= step;
      if (!(t >= 0 && t <= c.horizon)) break;
      times.push_back(t);
    }
  }
  return times;
}

bool isFinite(const core::Contact& contact, double horizon) {
  return contact.time >= 0 && contact.time <= horizon && contact.point.allFinite();
}

std::string wrongAnswer(const Case& c, const core::Contact& contact) {
  if (!isFinite(contact, c.horizon)) return "no time within the horizon, or no point";
  const Real size = sizeOfCoordinates(c, contact.time);
  const Real tolerance = 2 * contactTolerance(c.segment, c.circle, c.radius, contact.time) +
                         kRounding * size + kUnderflow;
  if (!(gapAt(c, contact.time) <= tolerance))
    return "invented: a gap is left at " + std::to_string(contact.time);
  const Real rounding = 0x1p-51L * contact.point.norm();
  if (!(distanceTo(c, fromStart(c, contact.point)) <= tolerance + rounding))
    return "the point is not on the segment";
  return "";
}

}  // namespace

std::string wrongBySampling(const Case& c, const std::optional<core::Contact>& contact) {
  const std::string wrong = contact ? wrongAnswer(c, *contact) : "";
  if (!wrong.empty()) return wrong;
  for (const Real t : sampleTimes(c)) {
    const Real certain = kRounding * sizeOfCoordinates(c, static_cast<double>(t)) + kUnderflow;
    if (!(gapAt(c, t) < -certain)) continue;
    if (!contact) return "missed: overlaps at " + std::to_string(t);
    if (contact->time > t + 1e-9L * std::max(Real(1), t))
      return "late: reported " + std::to_string(contact->time) + ", overlaps at " +
             std::to_string(t);
  }
  return "";
}

}  // namespace footprint_collision_predictor::test
