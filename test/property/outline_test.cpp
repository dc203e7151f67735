// Lines and polygons against whole footprints, in every motion.
#include <gtest/gtest.h>

#include "footprint_generators.hpp"
#include "footprint_guarantee.hpp"

namespace footprint_collision_predictor::test {
namespace {

void run(const std::string& name, const SuiteSize& size, Moves moves) {
  moves.has_outline = true;
  runFootprintSuite("outline, " + name, size,
                    [&](Random& random) { return anyFootprintCase(random, moves); });
  runFootprintSuite("outline grazed, " + name, size,
                    [&](Random& random) { return grazingFootprint(random, moves); });
}

TEST(Outline, Straight) { run("straight", {2000, 200000}, {}); }
TEST(Outline, Accelerating) { run("a", {2000, 200000}, {true}); }
TEST(Outline, Growing) { run("r", {2000, 200000}, {false, true}); }
TEST(Outline, Turning) { run("w", {2000, 200000}, {false, false, true}); }
TEST(Outline, WithAll) { run("arw", {2000, 200000}, {true, true, true}); }

}  // namespace
}  // namespace footprint_collision_predictor::test
