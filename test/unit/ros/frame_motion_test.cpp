// The motion of a frame, from where it was and where it is.
#include "frame_motion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace footprint_collision_predictor {
namespace {

PlanarPose pose(double x, double y, double yaw) { return {{x, y}, {std::cos(yaw), std::sin(yaw)}}; }

void expectTwist(const core::Twist& twist, double vx, double vy, double angular,
                 double tolerance = 1e-12) {
  EXPECT_NEAR(twist.linear.x(), vx, tolerance);
  EXPECT_NEAR(twist.linear.y(), vy, tolerance);
  EXPECT_NEAR(twist.angular, angular, tolerance);
}

TEST(TwistBetween, AStraightWayInTheAxesOfTheBody) {
  expectTwist(twistBetween(pose(1, 2, M_PI / 2), pose(1, 3, M_PI / 2), 0.5), 2, 0, 0);
  expectTwist(twistBetween(pose(1, 2, M_PI), pose(1, 3, M_PI), 0.5), 0, -2, 0);
}

TEST(TwistBetween, AQuarterAndAHalfOfACircleAreAsLongAsTheArc) {
  // Round (0, 2), ahead: the arcs are pi and 2 pi metres long. To the right likewise.
  expectTwist(twistBetween(pose(0, 0, 0), pose(2, 2, M_PI / 2), 4), M_PI / 4, 0, M_PI / 8);
  expectTwist(twistBetween(pose(0, 0, 0), pose(2, -2, -M_PI / 2), 4), M_PI / 4, 0, -M_PI / 8);
  const core::Twist half = twistBetween(pose(0, 0, 0), pose(0, 4, M_PI), 4);
  expectTwist(half, M_PI / 2, 0, M_PI / 4);
}

TEST(TwistBetween, OnTheSpot) {
  expectTwist(twistBetween(pose(5, 7, 3), pose(5, 7, 3.2), 0.1), 0, 0, 2);
}

TEST(TwistBetween, ThroughTheDirectionWhereAnglesWrapRound) {
  expectTwist(twistBetween(pose(0, 0, M_PI - 0.1), pose(0, 0, 0.1 - M_PI), 0.1), 0, 0, 2);
}

TEST(TwistBetween, SlowTurnsJoinTheStraightLine) {
  // At rate w and 1 m/s ahead for 1 s the end is at (sin w, 1 - cos w) / w.
  for (const double w : {1e-12, 1e-8, 1e-5, 0.99e-4, 2.1e-4, 1e-3, 0.1}) {
    const double aside = 2 * std::pow(std::sin(w / 2), 2) / w;
    expectTwist(twistBetween(pose(0, 0, 0), pose(std::sin(w) / w, aside, w), 1), 1, 0, w, 1e-15);
  }
}

class FrameMotionTest : public testing::Test {
 protected:
  /// On a circle round (0, 2) m at 1 m/s, at angle 0 at 100 s.
  void drive(double stamp) {
    const double turned = 0.5 * (stamp - 100);
    set(stamp, 2 * std::sin(turned), 2 - 2 * std::cos(turned), turned);
  }

  void set(double stamp, double x, double y, double yaw, bool fixed = false) {
    geometry_msgs::TransformStamped t;
    t.header.frame_id = "odom";
    t.header.stamp = ros::Time(stamp);
    t.child_frame_id = "trailer";
    t.transform.translation.x = x;
    t.transform.translation.y = y;
    t.transform.rotation.z = std::sin(yaw / 2);
    t.transform.rotation.w = std::cos(yaw / 2);
    tf.setTransform(t, "test", fixed);
  }

  FrameMotion at(double stamp) { return frameMotion(tf, "odom", "trailer", ros::Time(stamp)); }

  std::string refusalAt(double stamp) try {
    at(stamp);
    return "none";
  } catch (const TransformError& error) {
    return error.what();
  }

  tf2::BufferCore tf;
};

TEST_F(FrameMotionTest, IsExactWhereTfHasBothTransforms) {
  for (int i = -2; i <= 2; ++i) drive(100 + 0.05 * i);
  const FrameMotion motion = at(100.05);
  expectTwist(motion.twist, 1, 0, 0.5);
  EXPECT_EQ(motion.newest, ros::Time(100.05));
}

TEST_F(FrameMotionTest, BetweenTransformsItIsOffByTheSagittaOfTheirChord) {
  for (int i = -10; i <= 10; ++i) drive(100 + 0.02 * i);
  // No pose is off by more than v w h^2 / 8 = 2.5e-5 m for samples h = 0.02 s apart; two of them
  // are differed over 0.1 s.
  const core::Twist twist = at(100.013).twist;
  expectTwist(twist, 1, 0, 0.5, 2 * 2.5e-5 / 0.1);
}

TEST_F(FrameMotionTest, EndsWithTheNewestTransform) {
  for (int i = -10; i <= 0; ++i) drive(100 + 0.02 * i);
  const FrameMotion motion = at(100.3);
  expectTwist(motion.twist, 1, 0, 0.5);
  EXPECT_EQ(motion.newest, ros::Time(100));
}

TEST_F(FrameMotionTest, NeedsTheWholeInterval) {
  drive(99.95);
  drive(100);
  EXPECT_NE(refusalAt(100).find("transform between \"odom\" and \"trailer\" at 99.9"),
            std::string::npos)
      << refusalAt(100);
}

TEST_F(FrameMotionTest, NamesBothFramesThatAreNotConnected) {
  EXPECT_NE(refusalAt(100).find("\"odom\" and \"trailer\""), std::string::npos) << refusalAt(100);
}

TEST_F(FrameMotionTest, WhatNeverChangesStandsStill) {
  set(0, 3, 4, 1, true);
  expectTwist(at(100).twist, 0, 0, 0);
  expectTwist(frameMotion(tf, "odom", "odom", ros::Time(100)).twist, 0, 0, 0);
}

TEST_F(FrameMotionTest, Fault26AVelocityThatIsAbsurdIsRefused) {
  set(99.9, 0, 0, 0);
  set(100, 2e5, 0, 0);
  EXPECT_NE(refusalAt(100).find("velocity of (2e+06, 0, 0)"), std::string::npos) << refusalAt(100);
  set(100.1, std::numeric_limits<double>::infinity(), 0, 0);
  EXPECT_NE(refusalAt(100.1).find("not finite"), std::string::npos) << refusalAt(100.1);
}

}  // namespace
}  // namespace footprint_collision_predictor
