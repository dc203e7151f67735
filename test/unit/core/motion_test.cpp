// What an obstacle may be, and how it moves as seen from the footprint.
#include "footprint_collision_predictor/motion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

namespace footprint_collision_predictor::core {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();
const Motion kGood{{1, 2}, {3, 4}, {5, 6}};

std::string refusalOf(const Motion& motion, double radius, double radius_rate,
                      const std::vector<Vec2>& outline) {
  try {
    const Obstacle accepted(motion, radius, radius_rate, outline);
  } catch (const InvalidObstacle& e) {
    return e.what();
  }
  return "(accepted)";
}

void expectRefusal(const Motion& motion, double radius, const std::string& field,
                   double radius_rate = 0, const std::vector<Vec2>& outline = {}) {
  const std::string text = refusalOf(motion, radius, radius_rate, outline);
  EXPECT_NE(text.find(field), std::string::npos) << text << "\ndoes not name " << field;
}

TEST(Obstacle, KeepsWhatItIsGiven) {
  const Obstacle o(kGood, 0.5, 0.25, {{1, 2}, {3, 4}});
  EXPECT_EQ(o.motion().position, Vec2(1, 2));
  EXPECT_EQ(o.motion().velocity, Vec2(3, 4));
  EXPECT_EQ(o.motion().acceleration, Vec2(5, 6));
  EXPECT_EQ(o.radius(), 0.5);
  EXPECT_EQ(o.disc().radius_rate, 0.25);
  EXPECT_EQ(o.outline(), (std::vector<Vec2>{{1, 2}, {3, 4}}));
  EXPECT_EQ(Obstacle(kGood, 0.5).disc().radius_rate, 0);
  EXPECT_TRUE(Obstacle(kGood, 0.5).outline().empty());
}

TEST(Obstacle, RefusesWhatIsNotFinite) {
  for (const double bad : {kNan, kInf, -kInf}) {
    expectRefusal({{bad, 0}, {0, 0}, {0, 0}}, 1, "position.x is");
    expectRefusal({{0, bad}, {0, 0}, {0, 0}}, 1, "position.y is");
    expectRefusal({{0, 0}, {bad, 0}, {0, 0}}, 1, "velocity.x is");
    expectRefusal({{0, 0}, {0, bad}, {0, 0}}, 1, "velocity.y is");
    expectRefusal({{0, 0}, {0, 0}, {bad, 0}}, 1, "acceleration.x is");
    expectRefusal({{0, 0}, {0, 0}, {0, bad}}, 1, "acceleration.y is");
    expectRefusal(kGood, bad, "radius");
    expectRefusal(kGood, 1, "radius_rate", bad);
    expectRefusal(kGood, 1, "outline", 0, {{0, 0}, {bad, 0}});
    expectRefusal(kGood, 1, "outline", 0, {{0, 0}, {1, 0}, {0, bad}});
  }
}

TEST(Obstacle, RefusesWhatIsBeyondTheLimits) {
  for (const double sign : {1.0, -1.0}) {
    expectRefusal({{sign * 1.001e8, 0}, {0, 0}, {0, 0}}, 1, "position");
    expectRefusal({{0, sign * 1.001e8}, {0, 0}, {0, 0}}, 1, "position");
    expectRefusal({{0, 0}, {sign * 1.001e6, 0}, {0, 0}}, 1, "velocity");
    expectRefusal({{0, 0}, {0, sign * 1.001e6}, {0, 0}}, 1, "velocity");
    expectRefusal({{0, 0}, {0, 0}, {sign * 1.001e6, 0}}, 1, "acceleration");
    expectRefusal({{0, 0}, {0, 0}, {0, sign * 1.001e6}}, 1, "acceleration");
  }
  expectRefusal(kGood, 1.001e6, "radius");
  expectRefusal(kGood, 1, "radius_rate", 1.001e6);
  expectRefusal(kGood, 1, "outline", 0, {{0, 0}, {1.001e8, 0}});
  expectRefusal(kGood, 1, "outline", 0, {{0, -1.001e8}, {1, 0}});
}

TEST(Obstacle, RefusesAnOutlineOfOneVertex) { expectRefusal(kGood, 1, "outline", 0, {{1, 1}}); }

TEST(Obstacle, RefusesANegativeRadiusOrGrowth) {
  expectRefusal(kGood, 1, "radius_rate", -1e-300);
  expectRefusal(kGood, -1e-300, "radius");
  expectRefusal(kGood, -1, "radius");
}

TEST(Obstacle, AcceptsTheLimitsThemselvesAndAPoint) {
  EXPECT_NO_THROW(Obstacle({{1e8, -1e8}, {1e6, -1e6}, {-1e6, 1e6}}, 1e6));
  EXPECT_NO_THROW(Obstacle(kGood, 0));
  EXPECT_NO_THROW(Obstacle(kGood, 0, 1e6, {{1e8, -1e8}, {1e8, -1e8}}));  // of no length
}

TEST(Motion, FollowsConstantAccelerationAlsoThroughAStop) {
  const Motion m{{1, 0}, {4, 1}, {-2, 0}};  // stops along x at t = 2, at x = 5
  EXPECT_EQ(m.positionAt(0), Vec2(1, 0));
  EXPECT_EQ(m.positionAt(2), Vec2(5, 2));
  EXPECT_EQ(m.velocityAt(2), Vec2(0, 1));
  EXPECT_EQ(m.positionAt(4), Vec2(1, 4));
  EXPECT_EQ(m.velocityAt(4), Vec2(-4, 1));
}

TEST(RelativeMotion, TakesTheFootprintsVelocityAway) {
  const Motion m = relativeMotion(kGood, {{1, -1}, 0});
  EXPECT_EQ(m.position, Vec2(1, 2));
  EXPECT_EQ(m.velocity, Vec2(2, 5));
  EXPECT_EQ(m.acceleration, Vec2(5, 6));
}

TEST(RelativeMotion, OfAFootprintThatStandsStillIsTheObstacles) {
  const Motion m = relativeMotion(kGood, {});
  EXPECT_EQ(m.position, kGood.position);
  EXPECT_EQ(m.velocity, kGood.velocity);
  EXPECT_EQ(m.acceleration, kGood.acceleration);
}

TEST(Obstacle, LaterIsWhereItThenIsAsSeenFromTheFootprint) {
  const Obstacle now{{{5, 1}, {-1, 0}, {2, -4}}, 0.5};
  const Obstacle later = now.after(2, {{1, 0}, 0});  // 5 - 2 * 2 + 2 * 4 / 2, 1 - 4 * 4 / 2
  EXPECT_EQ(later.motion().position, Vec2(5, -7));
  EXPECT_EQ(later.motion().velocity, Vec2(3, -8));  // over ground
  EXPECT_EQ(later.motion().acceleration, Vec2(2, -4));
  EXPECT_EQ(later.radius(), 0.5);
}

TEST(Obstacle, LaterHasGrownAndKeepsItsOutline) {
  const Obstacle now{{{5, 1}, {-1, 0}, {0, 0}}, 0.5, 0.25, {{1, 0}, {0, 1}}};
  const Obstacle later = now.after(2, {{1, 0}, 0});
  EXPECT_EQ(later.radius(), 1);
  EXPECT_EQ(later.disc().radius_rate, 0.25);
  EXPECT_EQ(later.outline(), now.outline());
}

// A quarter of the circle of 2 m about (0, 2): from the origin to (2, 2), now facing along y.
const Twist kQuarter{{M_PI, 0}, M_PI / 2};

void expectNear(const Vec2& a, const Vec2& b) { EXPECT_NEAR((a - b).norm(), 0, 1e-12) << a << b; }

TEST(Obstacle, LaterIsInTheAxesOfTheTurnedFootprint) {
  const Obstacle now{{{4, 2}, {1, 0}, {0, 2}}, 0.5, 0, {{1, 0}, {0, 1}}};
  const Obstacle later = now.after(1, kQuarter);  // over ground at (5, 3), with (1, 2) m/s
  expectNear(later.motion().position, {1, -3});
  expectNear(later.motion().velocity, {2, -1});
  expectNear(later.motion().acceleration, {2, 0});
  ASSERT_EQ(later.outline().size(), 2u);
  expectNear(later.outline()[0], {0, -1});
  expectNear(later.outline()[1], {1, 0});
}

TEST(Displacement, IsStraightOrAlongAnArc) {
  EXPECT_EQ(displacement({{1, -2}, 0}, 3), Vec2(3, -6));
  expectNear(displacement(kQuarter, 1), {2, 2});
  expectNear(displacement(kQuarter, 2), {0, 4});
  expectNear(displacement({{0, -M_PI}, -M_PI / 2}, 1), {-2, -2});
  expectNear(displacement({{0, 0}, 1}, 5), {0, 0});
}

TEST(Displacement, OfNearlyNoTurningIsNearlyStraight) {
  for (const double w : {1e-300, -1e-12, 1e-9})
    expectNear(displacement({{1, -2}, w}, 3), Vec2(3, -6) + 4.5 * w * Vec2(2, 1));
}

TEST(AtPoint, AddsWhatTurningMovesThePoint) {
  const Twist twist = atPoint({1, 2}, {{3, 4}, 0.5});
  EXPECT_EQ(twist.linear, Vec2(2, 4.5));
  EXPECT_EQ(twist.angular, 0.5);
}

}  // namespace
}  // namespace footprint_collision_predictor::core
