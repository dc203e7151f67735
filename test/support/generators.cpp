#include "generators.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace footprint_collision_predictor::test {
namespace {

double anyHorizon(Random& random) { return random.logUniform(0.1, 100); }

}  // namespace

Touch anyTouch(const Segment& s, Random& random) {
  const Vec2 along = (s.end - s.start).normalized();
  if (random.chance(0.5))
    return {s.start + random.uniform(0, 1) * (s.end - s.start),
            random.sign() * core::leftNormal(along)};
  const bool at_start = random.chance(0.5);
  Vec2 outwards = random.direction();
  if ((outwards.dot(along) > 0) == at_start) outwards = -outwards;
  return {at_start ? s.start : s.end, outwards};
}

double anyRadius(Random& random) { return random.chance(0.1) ? 0 : random.logUniform(1e-2, 1e2); }

double almost(double value, Random& random) {
  if (random.chance(0.3)) return ulpsAway(value, random.integer(-4, 4));
  return value * (1 + random.sign() * random.logUniform(1e-15, 1e-3));
}

Motion leadingTo(const Vec2& position, double time, const Vec2& velocity,
                 const Vec2& acceleration) {
  return {position - time * (velocity - (0.5 * time) * acceleration),
          velocity - time * acceleration, acceleration};
}

Segment anySegment(Random& random) {
  const double length = random.logUniform(1e-2, 1e2);
  const Vec2 start = random.uniform(0, 10) * random.direction();
  if (random.chance(0.2)) {  // axis-aligned and starting at the origin: nothing is rounded away
    const Vec2 way = random.chance(0.5) ? Vec2{1, 0} : Vec2{0, 1};
    return {{0, 0}, random.sign() * length * way};
  }
  return {start, start + length * random.direction()};
}

Vec2 pointOn(const Segment& s, Random& random) {
  const double where = random.uniform(0, 1);
  if (where < 0.1) return s.start;
  if (where < 0.2) return s.end;
  const double share = where < 0.3 ? random.logUniform(1e-12, 1e-3) : random.uniform(0, 1);
  return s.start + share * (s.end - s.start);
}

Vec2 anyVector(Random& random, double low, double high) {
  if (random.chance(1.0 / 3)) return {0, 0};
  return random.logUniform(low, high) * random.direction();
}

Case anyCase(Random& random) {
  const Segment s = anySegment(random);
  const double radius = anyRadius(random);
  const Vec2 position = s.start + random.logUniform(1e-2, 1e3) * random.direction();
  const double speed = random.logUniform(1e-2, 1e2);
  Vec2 velocity = speed * random.direction();
  if (random.chance(0.6)) velocity = speed * (pointOn(s, random) - position).normalized();
  return {s, {position, velocity, anyVector(random, 1e-6, 10)}, radius, anyHorizon(random)};
}

Case grazingEnd(Random& random) {
  Segment s = anySegment(random);
  if (random.chance(0.5)) std::swap(s.start, s.end);
  const Vec2 along = (s.end - s.start).normalized();
  const bool square = random.chance(0.4);  // the miss distance then is exact to the last bit
  Vec2 outwards = square ? random.sign() * core::leftNormal(along) : random.direction();
  if (outwards.dot(along) > 0) outwards = -outwards;
  const double radius = random.logUniform(1e-2, 1e2);
  const double speed = random.logUniform(1e-3, 1e2);
  const double nearest_time = random.uniform(0, 10);
  const Vec2 velocity = random.sign() * speed * core::leftNormal(outwards);
  Vec2 acceleration = anyVector(random, 1e-9, 10);
  if (random.chance(0.5)) acceleration = random.uniform(-1, 1) * velocity;  // a straight line
  const Vec2 nearest = s.start + almost(radius, random) * outwards;
  return {s, leadingTo(nearest, nearest_time, velocity, acceleration), radius, 20};
}

Case osculating(Random& random) {
  const Segment s = anySegment(random);
  const Vec2 along = (s.end - s.start).normalized();
  Vec2 outwards = random.direction();
  if (outwards.dot(along) > 0) outwards = -outwards;
  const double radius = random.logUniform(1e-1, 1e2);
  const double speed = random.logUniform(1e-2, 1e1);
  const Vec2 side = random.sign() * core::leftNormal(outwards);
  const double inwards = random.sign() * random.logUniform(1e-12, 1e-2);
  const Vec2 velocity = speed * (side + inwards * outwards);
  const double bend = 1 + random.sign() * random.logUniform(1e-12, 1);
  const Vec2 acceleration =
      speed * speed / radius * (random.uniform(-1, 1) * side - bend * outwards);
  const double time = random.uniform(0, 2) * radius / speed;
  const Vec2 centre = s.start + almost(radius, random) * outwards;
  return {s, leadingTo(centre, time, velocity, acceleration), radius,
          std::min(core::kMaxHorizon, 3 * time)};
}

Sinking anySinking(const Segment& s, const Vec2& outwards, Random& random) {
  const bool at_start = random.chance(0.5);
  const Vec2 inwards = at_start ? Vec2(s.end - s.start) : Vec2(s.start - s.end);
  return {(at_start ? s.start : s.end) + random.logUniform(1e-12, 1e-2) * inwards,
          inwards.normalized() - random.logUniform(1e-8, 1) * outwards};
}

Case sinking(Random& random) {
  const Segment s = anySegment(random);
  const Vec2 outwards = random.sign() * core::leftNormal((s.end - s.start).normalized());
  const Sinking way = anySinking(s, outwards, random);
  const double radius = random.chance(0.5) ? 0 : random.logUniform(1e-9, 1e-2);
  const Vec2 velocity = random.logUniform(1e-3, 1e2) * way.direction;
  Vec2 acceleration = anyVector(random, 1e-9, 10);
  if (random.chance(0.5)) acceleration = random.uniform(-1, 1) * velocity;  // a straight line
  const double time = random.logUniform(1e-3, 10);
  const Vec2 centre = way.point + radius * outwards;
  return {s, leadingTo(centre, time, velocity, acceleration), radius, 2 * time};
}

Case touchingNow(Random& random) {
  const Segment s = anySegment(random);
  const Touch touch = anyTouch(s, random);
  const double radius = anyRadius(random);
  const double gap = random.chance(0.2) ? 0 : random.sign() * random.logUniform(1e-16, 1e-6);
  const Vec2 side = random.sign() * core::leftNormal(touch.outwards);
  const double speed = random.logUniform(1e-6, 1e2);
  const double outwards =
      random.chance(0.5) ? random.uniform(-1, 1) : random.sign() * random.logUniform(1e-16, 1e-1);
  const Vec2 velocity = speed * (side + outwards * touch.outwards);
  Vec2 acceleration = anyVector(random, 1e-9, 10);
  if (random.chance(0.3)) acceleration = random.uniform(-1, 1) * acceleration.norm() * side;
  const Vec2 position = touch.point + (radius + gap) * touch.outwards;
  return {s, {position, velocity, acceleration}, radius, anyHorizon(random)};
}

Case braking(Random& random) {
  const Segment s = anySegment(random);
  const Touch touch = anyTouch(s, random);
  const double radius = anyRadius(random);
  const double gap = random.logUniform(1e-3, 1e2);
  const double deceleration = random.logUniform(1e-12, 1e3);
  const double past = random.chance(0.1) ? 0 : random.sign() * random.logUniform(1e-9, 1e-3);
  const double speed = std::sqrt(2 * deceleration * std::abs(gap + past));
  Vec2 velocity = -speed * touch.outwards;
  if (random.chance(0.3)) velocity += random.logUniform(1e-9, 1) * core::leftNormal(touch.outwards);
  return {s,
          {touch.point + (radius + gap) * touch.outwards, velocity, deceleration * touch.outwards},
          radius,
          std::min(core::kMaxHorizon, 4 * speed / deceleration)};
}

Case awayAndBack(Random& random) {
  const Segment s = anySegment(random);
  const Touch touch = anyTouch(s, random);
  const double radius = anyRadius(random);
  const double gap = random.chance(0.3) ? 0 : random.logUniform(1e-9, 1e2);
  const double speed = random.logUniform(1e-6, 1e2);
  const Vec2 velocity =
      speed * (touch.outwards + random.logUniform(1e-6, 1e-1) * core::leftNormal(touch.outwards));
  const double pull = random.logUniform(1e-12, 1e3);
  return {s,
          {touch.point + (radius + gap) * touch.outwards, velocity, -pull * touch.outwards},
          radius,
          random.logUniform(1e-3, core::kMaxHorizon)};
}

Case boomerang(Random& random) {
  const Segment s = anySegment(random);
  const Touch touch = anyTouch(s, random);
  const double radius = anyRadius(random);
  const double gap = random.sign() * random.logUniform(1e-16, 1e-3);
  const Vec2 centre = touch.point + (radius + gap) * touch.outwards;
  const double back = random.logUniform(1, 1e3);
  const double speed = random.logUniform(1e-3, 1e3);
  const Vec2 side = random.sign() * core::leftNormal(touch.outwards);
  const double inwards = random.chance(0.3) ? 0 : random.logUniform(1e-12, 1e2);
  const Vec2 velocity = speed * (side - inwards * touch.outwards).normalized();
  // Straight back along its way, or along any parabola.
  const Vec2 acceleration =
      random.chance(0.5) ? Vec2{(2 / back) * velocity} : Vec2{speed / back * random.direction()};
  return {s, leadingTo(centre, back, velocity, acceleration), radius, 2 * back};
}

Case translated(const Case& c, const Vec2& by) {
  Case moved = c;
  moved.segment = {c.segment.start + by, c.segment.end + by};
  moved.circle.position = c.circle.position + by;
  return moved;
}

double ulpsAway(double x, int steps) {
  for (; steps > 0; --steps) x = std::nextafter(x, HUGE_VAL);
  for (; steps < 0; ++steps) x = std::nextafter(x, -HUGE_VAL);
  return x;
}

}  // namespace footprint_collision_predictor::test
