// What an obstacle may be, and how it moves as seen from the footprint.
#include "footprint_collision_predictor/motion.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace footprint_collision_predictor::core {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();
const Motion kGood{{1, 2}, {3, 4}, {5, 6}};

std::string refusalOf(const Motion& motion, double radius) {
  try {
    const Obstacle accepted(motion, radius);
  } catch (const InvalidObstacle& e) {
    return e.what();
  }
  return "(accepted)";
}

void expectRefusal(const Motion& motion, double radius, const std::string& field) {
  const std::string text = refusalOf(motion, radius);
  EXPECT_NE(text.find(field), std::string::npos) << text << "\ndoes not name " << field;
}

TEST(Obstacle, KeepsWhatItIsGiven) {
  const Obstacle o(kGood, 0.5);
  EXPECT_EQ(o.motion().position, Vec2(1, 2));
  EXPECT_EQ(o.motion().velocity, Vec2(3, 4));
  EXPECT_EQ(o.motion().acceleration, Vec2(5, 6));
  EXPECT_EQ(o.radius(), 0.5);
}

TEST(Obstacle, RefusesWhatIsNotFinite) {
  for (const double bad : {kNan, kInf, -kInf}) {
    expectRefusal({{bad, 0}, {0, 0}, {0, 0}}, 1, "position");
    expectRefusal({{0, bad}, {0, 0}, {0, 0}}, 1, "position");
    expectRefusal({{0, 0}, {bad, 0}, {0, 0}}, 1, "velocity");
    expectRefusal({{0, 0}, {0, bad}, {0, 0}}, 1, "velocity");
    expectRefusal({{0, 0}, {0, 0}, {bad, 0}}, 1, "acceleration");
    expectRefusal({{0, 0}, {0, 0}, {0, bad}}, 1, "acceleration");
    expectRefusal(kGood, bad, "radius");
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
}

TEST(Obstacle, RefusesANegativeRadius) {
  expectRefusal(kGood, -1e-300, "radius");
  expectRefusal(kGood, -1, "radius");
}

TEST(Obstacle, AcceptsTheLimitsThemselvesAndAPoint) {
  EXPECT_NO_THROW(Obstacle({{1e8, -1e8}, {1e6, -1e6}, {-1e6, 1e6}}, 1e6));
  EXPECT_NO_THROW(Obstacle(kGood, 0));
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

}  // namespace
}  // namespace footprint_collision_predictor::core
