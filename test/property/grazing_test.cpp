// Passing an end at almost exactly the radius, where time is ill-conditioned.
#include <gtest/gtest.h>

#include "generators.hpp"
#include "guarantee.hpp"

namespace footprint_collision_predictor::test {
namespace {

TEST(Grazing, AnEndHoldsTheGuarantee) { runSuite("grazing an end", kMain, grazingEnd); }

TEST(Grazing, OsculatingAnEndHoldsTheGuarantee) {
  runSuite("osculating an end", {100000, 10000000}, osculating);
}

}  // namespace
}  // namespace footprint_collision_predictor::test
