#include "oracle.hpp"

#include <stdexcept>

#include "polynomial.hpp"

namespace footprint_collision_predictor::test {
namespace {

struct QuadVec {
  Quad x;
  Quad y;
};

QuadVec quad(const Vec2& v) { return {v.x(), v.y()}; }
QuadVec operator+(const QuadVec& a, const QuadVec& b) { return {a.x + b.x, a.y + b.y}; }
QuadVec operator-(const QuadVec& a, const QuadVec& b) { return {a.x - b.x, a.y - b.y}; }
QuadVec operator*(Quad k, const QuadVec& v) { return {k * v.x, k * v.y}; }
Quad dot(const QuadVec& a, const QuadVec& b) { return a.x * b.x + a.y * b.y; }
Quad norm(const QuadVec& v) { return squareRoot(dot(v, v)); }
QuadVec leftNormal(const QuadVec& v) { return {-v.y, v.x}; }

/// Over ground, in the body's frame at t = 0.
QuadVec overGround(const Motion& m, Quad t) {
  return quad(m.position) + t * (quad(m.velocity) + (t / 2) * quad(m.acceleration));
}

/// The way of the body's origin: the integral of its velocity, which turns with the body. 1 - cos
/// as a square, since the difference would cancel.
QuadVec wayOnArc(const Twist& twist, Quad t) {
  const Quad w = twist.angular;
  const QuadVec u = quad(twist.linear);
  if (w == 0) return t * u;
  const Quad half = sineAndCosine(w * t / 2).sine;
  return (sineAndCosine(w * t).sine / w) * u + (2 * half * half / w) * leftNormal(u);
}

/// In the body's frame at t.
QuadVec centreAt(const Case& c, Quad t) {
  const QuadVec p = overGround(c.circle, t) - wayOnArc(c.twist, t);
  if (c.twist.angular == 0) return p;
  const QuadTurn turn = sineAndCosine(c.twist.angular * t);
  return turn.cosine * p - turn.sine * leftNormal(p);
}

QuadVec nearest(const Segment& s, const QuadVec& p) {
  const QuadVec start = quad(s.start);
  const QuadVec d = quad(s.end) - start;
  const Quad along = dot(d, p - start);
  if (!(along > 0)) return start;
  if (along >= dot(d, d)) return quad(s.end);
  return start + (along / dot(d, d)) * d;
}

/// The motion as seen from a segment that does not turn.
struct Relative {
  QuadVec p;
  QuadVec v;
  QuadVec a;
};

Relative relativeTo(const Vec2& origin, const Case& c) {
  return {quad(c.circle.position) - quad(origin), quad(c.circle.velocity) - quad(c.twist.linear),
          quad(c.circle.acceleration)};
}

/// Contact with one end alone: |p + v t + a t^2 / 2|^2 - (r + r' t)^2 <= 0.
std::optional<Quad> contactWithEnd(const Case& c, const Vec2& end, Quad horizon) {
  const auto [p, v, a] = relativeTo(end, c);
  const Quad r = c.radius;
  const Quad rate = c.radius_rate;
  const Quad reach = horizon * (norm(v) + horizon * norm(a) / 2 + rate) + r;
  if (norm(p) > reach * Quad(1.0001)) return std::nullopt;
  return firstNotPositive({{dot(p, p) - r * r, 2 * (dot(p, v) - r * rate),
                            dot(v, v) + dot(p, a) - rate * rate, dot(v, a), dot(a, a) / 4}},
                          0, horizon);
}

/// The motion's scalar product with a vector. Nothing is normalised: integers stay exact.
Polynomial product(const QuadVec& axis, const Relative& m) {
  return {{dot(axis, m.p), dot(axis, m.v), dot(axis, m.a) / 2, 0, 0}};
}

/// k p + c0 + c1 t
Polynomial line(Quad k, const Polynomial& p, Quad c0, Quad c1) {
  return {{k * p.c[0] + c0, k * p.c[1] + c1, k * p.c[2], 0, 0}};
}

/// What lies between two parallel lines: where neither is positive.
struct Strip {
  Polynomial one;
  Polynomial other;

  bool contains(Quad t) const { return one.at(t) <= 0 && other.at(t) <= 0; }
};

/// First root of a side of the strip at which the point lies within the other strip as well.
void crossSides(const Strip& strip, const Strip& within, Quad horizon, std::optional<Quad>* first) {
  for (const Polynomial& side : {strip.one, strip.other})
    for (const Quad t : rootsBetween(side, 0, horizon))
      if (within.contains(t) && !(*first && **first <= t)) *first = t;
}

/// Contact with the rectangle of all points within the radius of the segment's inside. Two of its
/// sides move outwards as the radius grows.
std::optional<Quad> contactWithInside(const Case& c) {
  const QuadVec d = quad(c.segment.end) - quad(c.segment.start);
  const Quad length = norm(d);
  if (length == 0) return std::nullopt;
  const Relative m = relativeTo(c.segment.start, c);
  const Polynomial along = product(d, m);
  const Polynomial across = product(leftNormal(d), m);
  const Quad wide = c.radius * length;
  const Quad wider = c.radius_rate * length;
  const Strip beside{line(1, across, -wide, -wider), line(-1, across, -wide, -wider)};
  const Strip between{line(-1, along, 0, 0), line(1, along, -dot(d, d), 0)};
  if (beside.contains(0) && between.contains(0)) return Quad(0);
  std::optional<Quad> first;
  crossSides(beside, between, c.horizon, &first);
  crossSides(between, beside, c.horizon, &first);
  return first;
}

}  // namespace

std::optional<Quad> trueContact(const Case& c) {
  if (c.twist.angular != 0) throw std::invalid_argument("trueContact: the segment turns");
  std::optional<Quad> first = contactWithInside(c);
  for (const Vec2& end : {c.segment.start, c.segment.end}) {
    const std::optional<Quad> t = contactWithEnd(c, end, first ? *first : Quad(c.horizon));
    if (t) first = t;
  }
  return first;
}

Quad trueGap(const Case& c, Quad t) {
  const QuadVec centre = centreAt(c, t);
  return norm(centre - nearest(c.segment, centre)) - (Quad(c.radius) + c.radius_rate * t);
}

Quad trueSide(const Case& c, Quad t) {
  const QuadVec start = quad(c.segment.start);
  return dot(leftNormal(quad(c.segment.end) - start), centreAt(c, t) - start);
}

Quad distanceFromNearest(const Case& c, double t, const Vec2& point) {
  return norm(quad(point) - nearest(c.segment, centreAt(c, t)));
}

namespace {

/// No faster does the gap close until `end`: the centre's speed over ground, that of the fastest
/// end of the segment, and the radius's.
Quad topSpeed(const Case& c, Quad end) {
  const auto speed = [&c](const Vec2& point) {
    return norm(quad(c.twist.linear) + c.twist.angular * leftNormal(quad(point)));
  };
  return norm(quad(c.circle.velocity)) + end * norm(quad(c.circle.acceleration)) +
         larger(speed(c.segment.start), speed(c.segment.end)) + c.radius_rate;
}

std::optional<Quad> bisect(const Case& c, Quad low, Quad high, Quad width) {
  const Quad middle = low + (high - low) / 2;
  if (trueGap(c, middle) > topSpeed(c, high) * (high - low) / 2) return std::nullopt;
  if (high - low <= width) return trueGap(c, low) <= 0 ? low : middle;
  if (const std::optional<Quad> t = bisect(c, low, middle, width)) return t;
  return bisect(c, middle, high, width);
}

}  // namespace

std::optional<Quad> contactByBisection(const Case& c, double width) {
  if (trueGap(c, 0) <= 0) return Quad(0);
  return bisect(c, 0, c.horizon, width);
}

}  // namespace footprint_collision_predictor::test
