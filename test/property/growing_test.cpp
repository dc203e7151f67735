// A radius that grows: the distance to an end still makes a quartic, and two sides of the strip
// beside the segment move.
#include <gtest/gtest.h>

#include "growing_generators.hpp"
#include "guarantee.hpp"

namespace footprint_collision_predictor::test {
namespace {

TEST(GrowingRadius, HoldsTheGuaranteeWithoutAcceleration) {
  runSuite("growing, straight", kHalf, [](Random& random) {
    Case c = growingCase(random);
    c.circle.acceleration = {0, 0};
    return c;
  });
}

TEST(GrowingRadius, HoldsTheGuarantee) { runSuite("growing, accelerating", kHalf, growingCase); }

TEST(GrowingRadius, GrazingHoldsTheGuarantee) { runSuite("growing, grazing", kHalf, growingGraze); }

TEST(GrowingRadius, TouchingNowHoldsTheGuarantee) {
  runSuite("growing, touching now", kHalf, growingNow);
}

TEST(GrowingRadius, CatchingUpHoldsTheGuarantee) {
  runSuite("growing, leaving more slowly", kHalf, caughtUp);
}

TEST(GrowingRadius, FarAwayHoldsTheGuarantee) {
  runSuite("growing, origin far away", kHalf, [](Random& random) {
    const Case c = random.chance(0.5) ? growingGraze(random) : growingCase(random);
    return translated(c, random.logUniform(1e3, 1e6) * random.direction());
  });
}

TEST(GrowingRadius, OfAnySizeHoldsTheGuarantee) {
  runSuite("growing by up to 1e6 m/s", kHalf, [](Random& random) {
    Case c = random.chance(0.5) ? growingCase(random) : touchingNow(random);
    c.radius_rate = random.logUniform(1e-300, core::kMaxRate);
    if (random.chance(0.5)) c.radius = 0;
    return c;
  });
}

}  // namespace
}  // namespace footprint_collision_predictor::test
