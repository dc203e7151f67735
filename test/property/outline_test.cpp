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

TEST(Outline, InLineWithASide) {
  runFootprintSuite("outline in line", {5000, 500000}, inLineWithASide);
}

TEST(Outline, FarFromItsOwnPosition) {
  runFootprintSuite("outline told from afar", {1000, 100000}, [](Random& random) {
    const Moves moves{random.chance(0.5), random.chance(0.3), random.chance(0.5), true};
    const Vec2 by = random.logUniform(1, 1e5) * random.direction();
    const FootprintCase c =
        random.chance(0.5) ? anyFootprintCase(random, moves) : grazingFootprint(random, moves);
    return outlineToldFromAfar(c, by);
  });
}

TEST(Outline, Straight) { run("straight", {2000, 200000}, {}); }
TEST(Outline, Accelerating) { run("a", {2000, 200000}, {true}); }
TEST(Outline, Growing) { run("r", {2000, 200000}, {false, true}); }
TEST(Outline, Turning) { run("w", {2000, 200000}, {false, false, true}); }
TEST(Outline, WithAll) { run("arw", {2000, 200000}, {true, true, true}); }

}  // namespace
}  // namespace footprint_collision_predictor::test
