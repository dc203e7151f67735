#include "oracle.hpp"

#include "polynomial.hpp"

namespace footprint_collision_predictor::test {
namespace {

struct QuadVec {
  Quad x;
  Quad y;
};

QuadVec quad(const Vec2& v) { return {v.x(), v.y()}; }
QuadVec operator-(const QuadVec& a, const QuadVec& b) { return {a.x - b.x, a.y - b.y}; }
Quad dot(const QuadVec& a, const QuadVec& b) { return a.x * b.x + a.y * b.y; }
Quad norm(const QuadVec& v) { return squareRoot(dot(v, v)); }

QuadVec centreAt(const Motion& m, Quad t) {
  const QuadVec p = quad(m.position);
  const QuadVec v = quad(m.velocity);
  const QuadVec a = quad(m.acceleration);
  return {p.x + t * (v.x + t * a.x / 2), p.y + t * (v.y + t * a.y / 2)};
}

QuadVec nearest(const Segment& s, const QuadVec& p) {
  const QuadVec start = quad(s.start);
  const QuadVec d = quad(s.end) - start;
  const Quad along = dot(d, p - start);
  if (!(along > 0)) return start;
  if (along >= dot(d, d)) return quad(s.end);
  const Quad share = along / dot(d, d);
  return {start.x + share * d.x, start.y + share * d.y};
}

/// Contact with one end alone: |p + v t + a t^2 / 2|^2 - r^2 <= 0.
std::optional<Quad> contactWithEnd(const Case& c, const Vec2& end, Quad horizon) {
  const QuadVec p = quad(c.circle.position) - quad(end);
  const QuadVec v = quad(c.circle.velocity);
  const QuadVec a = quad(c.circle.acceleration);
  const Quad r = c.radius;
  const Quad reach = horizon * (norm(v) + horizon * norm(a) / 2) + r;
  if (norm(p) > reach * Quad(1.0001)) return std::nullopt;
  return firstNotPositive(
      {{dot(p, p) - r * r, 2 * dot(p, v), dot(v, v) + dot(p, a), dot(v, a), dot(a, a) / 4}}, 0,
      horizon);
}

/// The motion's scalar product with a vector. Nothing is normalised: integers stay exact.
Polynomial product(const QuadVec& axis, const QuadVec& p, const Motion& m) {
  return {{dot(axis, p), dot(axis, quad(m.velocity)), dot(axis, quad(m.acceleration)) / 2, 0, 0}};
}

/// First root of position = side at which other lies within [low, high].
void crossSide(Polynomial position, Quad side, const Polynomial& other, Quad low, Quad high,
               std::optional<Quad>* first, Quad horizon) {
  position.c[0] -= side;
  for (const Quad t : rootsBetween(position, 0, horizon)) {
    const Quad where = other.at(t);
    if (where >= low && where <= high && !(*first && **first <= t)) *first = t;
  }
}

/// Contact with the rectangle of all points within the radius of the segment's inside.
std::optional<Quad> contactWithInside(const Case& c) {
  const QuadVec d = quad(c.segment.end) - quad(c.segment.start);
  const Quad length = norm(d);
  if (length == 0) return std::nullopt;
  const QuadVec p = quad(c.circle.position) - quad(c.segment.start);
  const Polynomial along = product(d, p, c.circle);
  const Polynomial across = product({-d.y, d.x}, p, c.circle);
  const Quad far = dot(d, d);
  const Quad wide = c.radius * length;
  if (along.c[0] >= 0 && along.c[0] <= far && absolute(across.c[0]) <= wide) return Quad(0);
  std::optional<Quad> first;
  const Quad horizon = c.horizon;
  for (const Quad side : {wide, -wide}) crossSide(across, side, along, 0, far, &first, horizon);
  for (const Quad side : {Quad(0), far})
    crossSide(along, side, across, -wide, wide, &first, horizon);
  return first;
}

}  // namespace

std::optional<Quad> trueContact(const Case& c) {
  std::optional<Quad> first = contactWithInside(c);
  for (const Vec2& end : {c.segment.start, c.segment.end}) {
    const std::optional<Quad> t = contactWithEnd(c, end, first ? *first : Quad(c.horizon));
    if (t) first = t;
  }
  return first;
}

Quad trueGap(const Case& c, Quad t) {
  const QuadVec centre = centreAt(c.circle, t);
  return norm(centre - nearest(c.segment, centre)) - Quad(c.radius);
}

Quad distanceFromNearest(const Case& c, double t, const Vec2& point) {
  return norm(quad(point) - nearest(c.segment, centreAt(c.circle, t)));
}

namespace {

std::optional<Quad> bisect(const Case& c, Quad low, Quad high, Quad width) {
  const Quad top_speed = norm(quad(c.circle.velocity)) + high * norm(quad(c.circle.acceleration));
  const Quad middle = low + (high - low) / 2;
  if (trueGap(c, middle) > top_speed * (high - low) / 2) return std::nullopt;
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
