// The closing speed is how fast the gap shrinks at contact, but for what the radius grows.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "footprint_generators.hpp"
#include "footprint_oracle.hpp"
#include "guarantee.hpp"

namespace footprint_collision_predictor::test {
namespace {

constexpr Real kStep = 1e-5;  // [s]

/// By differences, up to the moment itself; nothing where the gap has a corner or bends much.
std::optional<double> shrinkingAt(const FootprintCase& c, Real t) {
  const FootprintOracle oracle(c);
  const Real late = (oracle.gap(t - 2 * kStep) - oracle.gap(t - kStep)) / kStep;
  const Real early = (oracle.gap(t - 3 * kStep) - oracle.gap(t - 2 * kStep)) / kStep;
  if (std::abs(late - early) > 1e-3L) return std::nullopt;
  return static_cast<double>(late);
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
    const std::optional<double> shrinking = shrinkingAt(c, first->contact.time);
    if (!shrinking) return "";
    ++seen;
    const double expected = std::max(0.0, *shrinking - c.disc.radius_rate);
    if (std::abs(first->closing_speed - expected) <= 5e-3 * (1 + expected)) return "";
    return std::to_string(first->closing_speed) + " m/s instead of " + std::to_string(expected) +
           "\n" + asCode(c);
  });
  EXPECT_GT(seen, scaled(size) / 10);
}

}  // namespace
}  // namespace footprint_collision_predictor::test
