// The smallest and the largest that a value may be.
#include <gtest/gtest.h>

#include "generators.hpp"
#include "guarantee.hpp"

namespace footprint_collision_predictor::test {
namespace {

TEST(Extremes, SpeedsHoldTheGuarantee) {
  runSuite("speeds 1e-9 .. 1e6", kSpecial, [](Random& random) {
    Case c = anyCase(random);
    const double scale = random.logUniform(1e-9, 1e6) / c.circle.velocity.norm();
    c.circle.velocity *= scale;
    c.circle.acceleration *= random.chance(0.5) ? 0 : scale * scale;
    c.circle.acceleration = c.circle.acceleration.cwiseMax(-1e6).cwiseMin(1e6);
    c.horizon = random.logUniform(1e-6, core::kMaxHorizon);
    return c;
  });
}

TEST(Extremes, TinySegmentsHoldTheGuarantee) {
  runSuite("segments of 1e-9 .. 1e-3 m", kSpecial, [](Random& random) {
    Case c = random.chance(0.5) ? anyCase(random) : touchingNow(random);
    c.segment.end = c.segment.start + random.logUniform(1e-9, 1e-3) * random.direction();
    if (random.chance(0.5)) c.radius = random.logUniform(1e-9, 1e-3);
    if (random.chance(0.1)) c.segment.end = c.segment.start;
    return c;
  });
}

TEST(Extremes, PointsHoldTheGuarantee) {
  runSuite("zero radius", kSpecial, [](Random& random) {
    Case c = random.chance(0.5) ? anyCase(random) : braking(random);
    c.radius = 0;
    return c;
  });
}

TEST(Extremes, StandingStillHoldsTheGuarantee) {
  runSuite("zero speed", kSpecial, [](Random& random) {
    Case c = random.chance(0.5) ? anyCase(random) : touchingNow(random);
    c.circle.velocity = {0, 0};
    if (random.chance(0.5)) c.circle.acceleration = {0, 0};
    return c;
  });
}

TEST(Extremes, HugeCirclesHoldTheGuarantee) {
  runSuite("radius up to 1e6 m", kHalf, [](Random& random) {
    Case c = anyCase(random);
    c.radius = random.logUniform(1e2, core::kMaxRadius);
    const double gap = random.logUniform(1e-6, 1e3);
    c.circle.position = c.segment.start + (c.radius + gap) * random.direction();
    if (random.chance(0.5))
      c.circle.velocity = random.logUniform(1e-2, 1e2) *
                          (pointOn(c.segment, random) - c.circle.position).normalized();
    return c;
  });
}

}  // namespace
}  // namespace footprint_collision_predictor::test
