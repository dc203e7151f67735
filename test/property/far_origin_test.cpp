// Maps are kilometres wide: coordinates of 1e3 .. 1e6 m, with a segment of metres.
#include <gtest/gtest.h>

#include "generators.hpp"
#include "guarantee.hpp"

namespace footprint_collision_predictor::test {
namespace {

Vec2 farAway(Random& random) { return random.logUniform(1e3, 1e6) * random.direction(); }

TEST(FarOrigin, HoldsTheGuarantee) {
  runSuite("origin 1e3 .. 1e6 m away", kMain,
           [](Random& random) { return translated(anyCase(random), farAway(random)); });
}

TEST(FarOrigin, GrazingAndTouchingHoldTheGuarantee) {
  runSuite("far away, grazing, touching", kMain, [](Random& random) {
    const Case c = random.chance(0.5) ? grazingEnd(random) : touchingNow(random);
    return translated(c, farAway(random));
  });
}

TEST(FarOrigin, FarCirclesHoldTheGuarantee) {
  runSuite("circle 1e3 .. 1e6 m away", {100000, 10000000}, [](Random& random) {
    Case c = anyCase(random);
    const double time = random.logUniform(1, 1e3);
    c.circle.position = farAway(random);
    c.circle.velocity = (pointOn(c.segment, random) - c.circle.position) / time -
                        (0.5 * time) * c.circle.acceleration;
    c.horizon = 2 * time;
    return c;
  });
}

}  // namespace
}  // namespace footprint_collision_predictor::test
