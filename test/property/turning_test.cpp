// A body that drives an arc, against what intervals prove.
#include <gtest/gtest.h>

#include "guarantee.hpp"
#include "turning_generators.hpp"

namespace footprint_collision_predictor::test {
namespace {

/// `most_undecided`: the part of the cases that may be too close a graze for anybody to decide.
void runTurningSuite(const std::string& suite, double most_undecided,
                     const std::function<Case(Random&)>& make, const SuiteSize& size = kProven) {
  const Tally tally = runSuite(suite, size, make);
  EXPECT_LE(static_cast<double>(tally.undecided),
            3 + most_undecided * static_cast<double>(tally.cases));
}

TEST(Turning, HoldsTheGuarantee) { runTurningSuite("turning", 4e-3, turningCase); }

TEST(Turning, AmongPillarsHoldsTheGuarantee) {
  runTurningSuite("turning among pillars", 8e-3, pillar);
}

TEST(Turning, GrazingHoldsTheGuarantee) {
  runTurningSuite("turning, grazing", 0.15, turningGraze, {10000, 1000000});
}

TEST(Turning, SinkingInBesideAnEndHoldsTheGuarantee) {
  runTurningSuite("turning, sinking in", 0.4, turningSinking, {5000, 500000});
}

TEST(Turning, TouchingNowHoldsTheGuarantee) {
  runTurningSuite("turning, touching now", 0.06, turningNow);
}

TEST(Turning, FarFromTheOriginHoldsTheGuarantee) {
  runTurningSuite("turning, origin far away", 0.1, turningFarFromOrigin);
}

TEST(Turning, WithAGrowingRadiusHoldsTheGuarantee) {
  runTurningSuite("turning and growing", 0.1, turningAndGrowing);
}

}  // namespace
}  // namespace footprint_collision_predictor::test
