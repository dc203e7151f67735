#include "growing_generators.hpp"

#include <algorithm>

namespace footprint_collision_predictor::test {

double anyRadiusRate(Random& random) { return random.logUniform(1e-9, 1e1); }

Case growingCase(Random& random) {
  Case c = anyCase(random);
  c.radius_rate = anyRadiusRate(random);
  return c;
}

Case growingGraze(Random& random) {
  const Segment s = anySegment(random);
  const Touch touch = anyTouch(s, random);
  const double time = random.uniform(0, 10);
  const double rate = random.logUniform(1e-6, 1e1);
  const double radius = anyRadius(random);
  const double speed = random.logUniform(1e-3, 1e2);
  const Vec2 velocity = random.sign() * speed * core::leftNormal(touch.outwards) +
                        almost(rate, random) * touch.outwards;
  Vec2 acceleration = anyVector(random, 1e-9, 10);
  if (random.chance(0.5)) acceleration -= acceleration.dot(touch.outwards) * touch.outwards;
  const Vec2 centre = touch.point + almost(radius + time * rate, random) * touch.outwards;
  return {s, leadingTo(centre, time, velocity, acceleration), radius, 20, rate};
}

Case growingNow(Random& random) {
  Case c = touchingNow(random);
  c.radius_rate = anyRadiusRate(random);
  if (random.chance(0.5)) return c;
  const Vec2 away = c.circle.position - core::closestPoint(c.segment, c.circle.position);
  if (away.norm() > 0) c.circle.velocity += almost(c.radius_rate, random) * away.normalized();
  return c;
}

Case caughtUp(Random& random) {
  const Segment s = anySegment(random);
  const Touch touch = anyTouch(s, random);
  const double radius = anyRadius(random);
  const double gap = random.logUniform(1e-9, 1e2);
  const double rate = anyRadiusRate(random);
  const double closing = rate * random.logUniform(1e-9, 1);
  const Motion motion{touch.point + (radius + gap) * touch.outwards,
                      (rate - closing) * touch.outwards, anyVector(random, 1e-12, 1e-6)};
  return {s, motion, radius, std::min(core::kMaxHorizon, 2 * gap / closing), rate};
}

}  // namespace footprint_collision_predictor::test
