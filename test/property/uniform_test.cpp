// The bread and butter: everything drawn widely.
#include <gtest/gtest.h>

#include "generators.hpp"
#include "guarantee.hpp"

namespace footprint_collision_predictor::test {
namespace {

TEST(Uniform, HoldsTheGuarantee) { runSuite("uniform", kMain, anyCase); }

TEST(Uniform, HoldsTheGuaranteeWithoutAcceleration) {
  runSuite("uniform, straight", {100000, 10000000}, [](Random& random) {
    Case c = anyCase(random);
    c.circle.acceleration = {0, 0};
    return c;
  });
}

}  // namespace
}  // namespace footprint_collision_predictor::test
