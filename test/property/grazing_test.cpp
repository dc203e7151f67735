// Passing an end at almost exactly the radius, where time is ill-conditioned, or the segment's line
// just beside it.
#include <gtest/gtest.h>

#include "generators.hpp"
#include "guarantee.hpp"

namespace footprint_collision_predictor::test {
namespace {

TEST(Grazing, AnEndHoldsTheGuarantee) { runSuite("grazing an end", kMain, grazingEnd); }

TEST(Grazing, OsculatingAnEndHoldsTheGuarantee) {
  runSuite("osculating an end", {100000, 10000000}, osculating);
}

TEST(Grazing, SinkingInBesideAnEndHoldsTheGuarantee) {
  runSuite("sinking in beside an end", kMain, sinking);
}

}  // namespace
}  // namespace footprint_collision_predictor::test
