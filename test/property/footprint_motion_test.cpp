// Whole footprints and one obstacle, in every motion: contact, clearance and closest approach.
#include <gtest/gtest.h>

#include "footprint_generators.hpp"
#include "footprint_guarantee.hpp"

namespace footprint_collision_predictor::test {
namespace {

void run(const std::string& name, const SuiteSize& size, const Moves& moves) {
  runFootprintSuite("footprint, " + name, size,
                    [&](Random& random) { return anyFootprintCase(random, moves); });
  runFootprintSuite("footprint grazed, " + name, size,
                    [&](Random& random) { return grazingFootprint(random, moves); });
  runFootprintSuite("footprint sunk into, " + name, size,
                    [&](Random& random) { return sinkingFootprint(random, moves); });
}

TEST(FootprintMotion, CirclesStraight) { run("circle", {1000, 200000}, {}); }
TEST(FootprintMotion, CirclesAccelerating) { run("circle a", {1000, 200000}, {true}); }
TEST(FootprintMotion, CirclesGrowing) { run("circle r", {1000, 200000}, {true, true}); }
TEST(FootprintMotion, CirclesTurning) { run("circle w", {1000, 200000}, {false, false, true}); }
TEST(FootprintMotion, CirclesWithAll) { run("circle arw", {1000, 200000}, {true, true, true}); }

}  // namespace
}  // namespace footprint_collision_predictor::test
