// Accelerations over fifteen decades.
#include <gtest/gtest.h>

#include "generators.hpp"
#include "guarantee.hpp"

namespace footprint_collision_predictor::test {
namespace {

TEST(Acceleration, OfAnySizeHoldsTheGuarantee) {
  runSuite("acceleration 1e-12 .. 1e3", kMain, [](Random& random) {
    Case c = anyCase(random);
    c.circle.acceleration = random.logUniform(1e-12, 1e3) * random.direction();
    return c;
  });
}

TEST(Acceleration, BrakingToAStopHoldsTheGuarantee) {
  runSuite("braking to a stop", kMain, braking);
}

TEST(Acceleration, BoomerangsHoldTheGuarantee) {
  runSuite("boomerangs", {100000, 10000000}, boomerang);
}

TEST(Acceleration, AwayAndBackHoldsTheGuarantee) { runSuite("away and back", kMain, awayAndBack); }

}  // namespace
}  // namespace footprint_collision_predictor::test
