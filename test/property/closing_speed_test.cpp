// The closing speed is how fast the gap shrinks at contact, but for what the radius grows.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "footprint_generators.hpp"
#include "footprint_oracle.hpp"
#include "guarantee.hpp"

namespace footprint_collision_predictor::test {
namespace {

/// By a difference over `step` [s], up to shortly before the moment.
Real shrinking(const FootprintOracle& oracle, Real t, Real step) {
  return (oracle.gap(t - 2 * step) - oracle.gap(t - step)) / step;
}

/// Nothing where the gap has a corner or bends much.
std::optional<double> shrinkingAt(const FootprintCase& c, Real t) {
  const FootprintOracle oracle(c);
  const Real at_last = shrinking(oracle, t, 1e-8);
  for (const Real step : {1e-7, 1e-6, 1e-5})
    if (std::abs(shrinking(oracle, t, step) - at_last) > 1e-3L * (1 + std::abs(at_last)))
      return std::nullopt;
  return static_cast<double>(at_last);
}

TEST(ClosingSpeed, IsHowFastTheGapShrinks) {
  std::size_t seen = 0;
  const SuiteSize size{4000, 400000};
  forEachCase("closing speed", size, [&](Random& random) -> std::string {
    const Moves moves{random.chance(0.5), random.chance(0.3), random.chance(0.5),
                      random.chance(0.5)};
    const FootprintCase c = anyFootprintCase(random, moves);
    const auto first = firstContact(core::Polygon(c.footprint), c.twist, obstacleOf(c), c.horizon);
    if (!first || first->contact.time < 1e-3) return "";
    const std::optional<double> speed = shrinkingAt(c, first->contact.time);
    if (!speed) return "";
    ++seen;
    const double expected = std::max(0.0, *speed - c.disc.radius_rate);
    if (std::abs(first->closing_speed - expected) <= 5e-3 * (1 + expected)) return "";
    return std::to_string(first->closing_speed) + " m/s instead of " + std::to_string(expected) +
           "\n" + asCode(c);
  });
  EXPECT_GT(seen, scaled(size) / 10);
}

}  // namespace
}  // namespace footprint_collision_predictor::test
