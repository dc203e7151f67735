// Touching at t = 0 is contact at t = 0, whatever comes next.
#include <gtest/gtest.h>

#include "footprint_generators.hpp"
#include "footprint_guarantee.hpp"
#include "generators.hpp"
#include "guarantee.hpp"

namespace footprint_collision_predictor::test {
namespace {

TEST(TouchingNow, HoldsTheGuarantee) { runSuite("touching now", kMain, touchingNow); }

TEST(TouchingNow, ASideHoldsTheGuarantee) {
  runFootprintSuite("side touched now", {5000, 500000}, touchingSideNow);
}

}  // namespace
}  // namespace footprint_collision_predictor::test
