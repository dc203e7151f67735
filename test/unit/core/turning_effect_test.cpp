// turningEffect is an upper bound: no point of a footprint on its arc is further from where it
// would be on a straight line.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "footprint_collision_predictor/motion.hpp"
#include "guarantee.hpp"

namespace footprint_collision_predictor::test {
namespace {

using core::Polygon;
using core::Twist;

Vec2 turned(const Vec2& v, double angle) {
  return {std::cos(angle) * v.x() - std::sin(angle) * v.y(),
          std::sin(angle) * v.x() + std::cos(angle) * v.y()};
}

/// Where a point of the body is at t when the body drives its arc: the centre of rotation, at
/// leftNormal(v) / w, stands still.
Vec2 onArc(const Vec2& point, const Twist& twist, double t) {
  const Vec2 centre = core::leftNormal(twist.linear) / twist.angular;
  return centre + turned(point - centre, twist.angular * t);
}

double largestDeviation(const Polygon& footprint, const Twist& twist, double horizon) {
  double largest = 0;
  for (const Vec2& vertex : footprint.vertices())
    for (int i = 0; i <= 200; ++i) {
      const double t = horizon * i / 200;
      largest = std::max(largest, (onArc(vertex, twist, t) - (vertex + t * twist.linear)).norm());
    }
  return largest;
}

TEST(TurningEffect, IsAnUpperBound) {
  forEachCase("turning effect", {2000, 100000}, [](Random& random) -> std::string {
    const Vec2 at = random.uniform(0, 3) * random.direction();  // the origin may be off the body
    const Polygon footprint({at, at + Vec2{random.uniform(0.1, 2), 0}, at + Vec2{0, 1}});
    const Twist twist{random.uniform(0, 5) * random.direction(),
                      random.sign() * random.logUniform(1e-4, 10)};
    const double horizon = random.logUniform(0.01, 20);
    const double bound = turningEffect(footprint, twist, horizon);
    const double truth = largestDeviation(footprint, twist, horizon);
    if (std::isfinite(bound) && bound >= truth * (1 - 1e-9) - 1e-9) return "";
    return "bound " + std::to_string(bound) + " < " + std::to_string(truth);
  });
}

TEST(TurningEffect, IsNoLargerThanNeededForASmallAngle) {
  const Polygon footprint({{0, 0}, {0.3, 0.4}, {0.1, -0.1}});
  const Twist twist{{1.2, 1.6}, 1e-4};  // towards the farthest vertex: both effects add up
  const double truth = largestDeviation(footprint, twist, 1);
  EXPECT_NEAR(truth, 1.5e-4, 1e-8);  // 1e-4 * (0.5 + 2 / 2)
  EXPECT_LE(turningEffect(footprint, twist, 1), 1.001 * truth);
}

TEST(TurningEffect, IsZeroWithoutTurning) {
  EXPECT_EQ(turningEffect(Polygon({{0, 0}, {1, 0}, {0, 1}}), {{3, 4}, 0}, 10), 0);
}

TEST(TurningEffect, VanishesWithTheYawRateAndWithTheHorizon) {
  const Polygon footprint({{0, 0}, {1, 0}, {0, 1}});
  EXPECT_LT(turningEffect(footprint, {{1, 0}, 1e-12}, 10), 1e-9);
  EXPECT_EQ(turningEffect(footprint, {{1, 0}, 1}, 0), 0);
}

TEST(TurningEffect, DoesNotDependOnTheSenseOfTurning) {
  const Polygon footprint({{0, 0}, {1, 0}, {0, 1}});
  EXPECT_EQ(turningEffect(footprint, {{1, 0}, 0.3}, 2),
            turningEffect(footprint, {{1, 0}, -0.3}, 2));
  EXPECT_GT(turningEffect(footprint, {{0, 0}, 0.3}, 2), 0.5);  // turning on the spot: |p| = 1
}

}  // namespace
}  // namespace footprint_collision_predictor::test
