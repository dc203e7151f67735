// Touching at t = 0 is contact at t = 0, whatever comes next.
#include <gtest/gtest.h>

#include "generators.hpp"
#include "guarantee.hpp"

namespace footprint_collision_predictor::test {
namespace {

TEST(TouchingNow, HoldsTheGuarantee) { runSuite("touching now", kMain, touchingNow); }

}  // namespace
}  // namespace footprint_collision_predictor::test
