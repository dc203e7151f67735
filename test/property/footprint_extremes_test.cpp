// Whole footprints of every size, at every speed and far from the origin.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

#include "footprint_generators.hpp"
#include "footprint_guarantee.hpp"

namespace footprint_collision_predictor::test {
namespace {

constexpr SuiteSize kCases{1000, 100000};

FootprintCase anyKind(Random& random, bool turns) {
  const Moves moves{random.chance(0.5), random.chance(0.3), turns, random.chance(0.5)};
  return random.chance(0.5) ? anyFootprintCase(random, moves) : grazingFootprint(random, moves);
}

void runMovedSuite(const std::string& suite, const std::function<FootprintCase(Random&)>& make) {
  runFootprintSuite(suite, kCases,
                    [&](Random& random) { return withFootprint([&] { return make(random); }); });
}

TEST(FootprintExtremes, LargeAndSmallFastAndSlow) {
  runMovedSuite("footprint scaled", [](Random& random) {
    const FootprintCase c = anyKind(random, false);
    const double length = random.logUniform(1e-7, 1e3);
    // So long that speeds and accelerations stay within the limits of an Obstacle.
    const double shortest = std::max(1e-3 * std::max(1.0, length), std::sqrt(1e-5 * length));
    return scaled(c, length, random.logUniform(shortest, 1e3));
  });
}

TEST(FootprintExtremes, TurningLargeAndSmallFastAndSlow) {
  runMovedSuite("footprint scaled, w", [](Random& random) {
    const FootprintCase c = anyKind(random, true);
    const double length = random.logUniform(1e-3, 1e2);
    return scaled(c, length, random.logUniform(std::max(1e-2, 1e-3 * length), 1e3));
  });
}

TEST(FootprintExtremes, FarFromTheOrigin) {
  runMovedSuite("footprint far away", [](Random& random) {
    const FootprintCase c = anyKind(random, false);
    return translated(c, random.logUniform(1e3, 1e7) * random.direction());
  });
}

TEST(FootprintExtremes, TurningAboutWhatIsFarAway) {
  runMovedSuite("footprint far away, w", [](Random& random) {
    FootprintCase c = anyKind(random, true);
    c.twist.angular = random.sign() * random.logUniform(1e-9, 1e-2);
    return translated(c, random.logUniform(10, 1e3) * random.direction());
  });
}

TEST(FootprintExtremes, HardlyTurning) {
  runFootprintSuite("footprint, tiny w", kCases, [](Random& random) {
    FootprintCase c = anyKind(random, false);
    c.twist.angular = random.sign() * random.logUniform(1e-300, 1e-3);
    return c;
  });
}

}  // namespace
}  // namespace footprint_collision_predictor::test
