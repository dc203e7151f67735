// The robot's own motion, transforms and clocks.
#include <cmath>

#include "pipeline_fixture.hpp"

namespace footprint_collision_predictor {
namespace {

using Warning = CollisionWarning;

class PipelineMotion : public PipelineFixture {
 protected:
  PipelineMotion() { parameters.ego_motion = EgoMotion::kOdom; }
};

TEST_F(PipelineMotion, TheRobotsVelocityCountsAsMuchAsTheObstacles) {
  sendOdometry(100, 1.5);
  EXPECT_NEAR(send(100, {circleAhead(3, 0.5)}).time_to_collision, 1, 1e-9);
  EXPECT_EQ(predictions.back().twist.linear.x, 1.5);
}

TEST_F(PipelineMotion, Fault23WaitsForOdometryAtOrAfterTheStampAndUsesThatBefore) {
  sendOdometry(99.9, 1);
  send(100, {circleAhead(3, 0)});
  EXPECT_TRUE(warnings.empty());
  sendOdometry(100.05, 4);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_NEAR(warnings[0].time_to_collision, 2, 1e-9);
}

TEST_F(PipelineMotion, WaitsNoLongerThanTransformTolerance) {
  sendOdometry(99.9, 1);
  send(100, {circleAhead(3, 0)});
  pipeline().process(at(100.09));
  EXPECT_TRUE(warnings.empty());
  pipeline().process(at(100.11));
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_NEAR(warnings[0].time_to_collision, 2, 1e-9);
}

TEST_F(PipelineMotion, Fault25AndTransformsThatComeLate) {
  sendOdometry(100, 0);
  setTransform("odom", "base_link", 99.9, 0, 0, 0);
  send(100, 100, {circleAhead(3, 2)}, "odom");
  EXPECT_TRUE(warnings.empty());
  setTransform("odom", "base_link", 100.1, 0, 0, 0);
  pipeline().process(at(100.05));
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0].reason & Warning::REASON_TRANSFORM, 0u);
}

TEST_F(PipelineMotion, WithoutOdometryOnlyWhatTouchesNowIsCertain) {
  send(100, {circleAhead(3, 2)});
  pipeline().process(at(100.11));
  EXPECT_EQ(warnings.back().level, Warning::UNKNOWN);
  EXPECT_EQ(warnings.back().reason, Warning::REASON_ODOM_MISSING);
  EXPECT_TRUE(std::isnan(warnings.back().time_to_collision));
  send(100.2, {circleAhead(0.9, 0)});
  pipeline().process(at(100.31));
  EXPECT_EQ(warnings.back().level, Warning::CRITICAL);
  EXPECT_EQ(warnings.back().time_to_collision, 0);
  EXPECT_EQ(warnings.back().reason, Warning::REASON_ODOM_MISSING);
}

TEST_F(PipelineMotion, TurningInPlaceIsPredicted) {
  // Seen from the square, the point at 0.6 m goes round it the other way, and meets the front where
  // its x is 0.5.
  const double contact = std::acos(0.5 / 0.6) / 0.5;
  sendOdometry(100, 0, 0.5);
  const Warning warning = send(100, {circleAhead(0.6, 0, 0)});
  EXPECT_EQ(warning.reason, Warning::REASON_SETTLING & warning.reason);
  EXPECT_NEAR(warning.time_to_collision, contact, 1e-6);
  EXPECT_EQ(warning.segment, 3);
  EXPECT_NEAR(warning.contact_point.x, 0.5, 1e-6);
  EXPECT_NEAR(warning.contact_point.y, -std::sqrt(0.11), 1e-6);
  EXPECT_NEAR(warning.closing_speed, 0.5 * std::sqrt(0.11), 1e-6);
  EXPECT_EQ(predictions.back().twist.angular.z, 0.5);
}

TEST_F(PipelineMotion, BetweenMessagesATurningRobotIsCarriedOnAlongItsArc) {
  const double contact = std::acos(0.5 / 0.6) / 0.5;
  sendOdometry(100, 0, 0.5);
  send(100, {circleAhead(0.6, 0, 0)});
  EXPECT_NEAR(pipeline().repeat(at(100.3)).time_to_collision, contact - 0.3, 1e-6);
}

TEST_F(PipelineMotion, OdometryOfAnotherFrameIsCarriedOver) {
  // The odometry frame looks to the left: its x velocity is the robot's y velocity.
  setTransform("base_link", "wheels", 0, 0.3, 0, M_PI / 2, true);
  nav_msgs::Odometry odometry;
  odometry.header.stamp = ros::Time(100);
  odometry.child_frame_id = "wheels";
  odometry.twist.twist.linear.x = 2;
  pipeline().receiveOdometry(serialized(odometry), at(100));
  send(100, {});
  EXPECT_NEAR(predictions.back().twist.linear.x, 0, 1e-12);
  EXPECT_NEAR(predictions.back().twist.linear.y, 2, 1e-12);
}

TEST_F(PipelineMotion, RelativeVelocitiesGetTheMotionOfTheirFrameAdded) {
  parameters.obstacle_velocity = ObstacleVelocity::kRelative;
  setTransform("base_link", "laser", 0, 1, 0, 0, true);
  sendOdometry(100, 1);
  // In the laser's frame a wall 3 m before the body's front comes nearer at 1 m/s.
  const Warning warning = send(100, 100, {circleAhead(3, 1)}, "laser");
  EXPECT_NEAR(warning.time_to_collision, 3, 1e-9);
  setTransform("odom", "base_link", 99, 0, 0, 0);
  setTransform("odom", "base_link", 101, 2, 0, 0);
  send(100.1, 100.1, {}, "odom");
  sendOdometry(100.2, 1);
  EXPECT_EQ(warnings.back().level, Warning::UNKNOWN);
  EXPECT_NE(warnings.back().message.find("not rigid"), std::string::npos)
      << warnings.back().message;
}

TEST_F(PipelineMotion, Fault21ASimulatedClockThatStandsStillOrNeverStarts) {
  simulated = true;
  parameters.ego_motion = EgoMotion::kStatic;
  const Moment before{ros::Time(), ros::SteadyTime(50.0)};
  EXPECT_EQ(pipeline().repeat(before).reason & Warning::REASON_CLOCK, Warning::REASON_CLOCK);
  send(100, {circleAhead(3, 2)});
  EXPECT_EQ(pipeline().repeat({ros::Time(100), ros::SteadyTime(100.4)}).level, Warning::CRITICAL);
  const Warning stopped = pipeline().repeat({ros::Time(100), ros::SteadyTime(100.6)});
  EXPECT_EQ(stopped.level, Warning::UNKNOWN);
  EXPECT_EQ(stopped.reason, Warning::REASON_CLOCK);
  EXPECT_TRUE(std::isnan(stopped.time_to_collision));
}

TEST_F(PipelineMotion, Fault19AClockThatJumpsBackDropsTheOldTime) {
  simulated = true;
  parameters.ego_motion = EgoMotion::kStatic;
  send(100, {circleAhead(3, 2)});
  const Warning after = pipeline().repeat({ros::Time(50), ros::SteadyTime(100.1)});
  EXPECT_EQ(after.level, Warning::UNKNOWN);
  EXPECT_EQ(after.reason, Warning::REASON_CLOCK | Warning::REASON_OBSTACLES_MISSING);
  pipeline().process({ros::Time(50.1), ros::SteadyTime(100.2)});
  const Warning recovered = send(50.2, {circleAhead(3, 2)});
  EXPECT_EQ(recovered.level, Warning::CRITICAL);
  EXPECT_EQ(recovered.reason, 0u);
}

TEST_F(PipelineMotion, Fault22OlderOdometryIsIgnoredAndCounted) {
  sendOdometry(100, 1);
  sendOdometry(100.02, 99.98, 5, 0);
  const Warning warning = send(100.02, 100, {circleAhead(2, 0)});
  EXPECT_NEAR(warning.time_to_collision, 1, 1e-9);
  EXPECT_EQ(warning.reason, Warning::REASON_OUT_OF_ORDER);
  EXPECT_NE(warning.message.find("/odom older than the newest was ignored (1 so far)"),
            std::string::npos)
      << warning.message;
}

}  // namespace
}  // namespace footprint_collision_predictor
