// A body whose motion comes from tf, or that is carried by the base.
#include <cmath>

#include "pipeline_fixture.hpp"

namespace footprint_collision_predictor {
namespace {

using Warning = CollisionWarning;

// 2 m x 1 m. Segments: 0 left, 1 rear, 2 right, 3 front.
core::Polygon box() { return core::Polygon({{1, 0.5}, {-1, 0.5}, {-1, -0.5}, {1, -0.5}}); }

class PipelineBodies : public PipelineFixture {
 protected:
  PipelineBodies() {
    parameters.footprint.reset();
    parameters.ego_motion = EgoMotion::kOdom;
    parameters.clear_after = 1;
    setBody(BodyMotion::kTf);
  }

  void setBody(BodyMotion motion) {
    parameters.footprints = {{"trailer", "trailer", box(), "", motion}};
  }

  /// The trailer's frame has been on its way round (0, 2) m since 99 s, at 1 m/s, and is at the
  /// origin at 100 s.
  void turnUntil(double end) {
    for (double t = 99; t < end + 0.01; t += 0.05) {
      const double turned = 0.5 * (t - 100);
      setTransform("odom", "trailer", t, 2 * std::sin(turned), 2 - 2 * std::cos(turned), turned);
    }
  }

  /// Along the x axis of odom, at the origin at 100 s.
  void driveUntil(double end, double speed) {
    for (double t = 99; t < end + 0.01; t += 0.05)
      setTransform("odom", "trailer", t, speed * (t - 100), 0, 0);
  }

  Warning sendOverGround(double now, double stamp, const std::vector<Obstacle>& obstacles) {
    return send(now, stamp, obstacles, "odom");
  }
};

TEST_F(PipelineBodies, ATurningTrailerTouchesAPillarBesideItsStraightWay) {
  // From the centre of rotation a circle of 0.5 m at (2.5, 2) is 2.5 m off, and comes to (1.5, 0),
  // where it touches the middle of the front, after a turn by atan(4 / 3).
  turnUntil(100);
  Obstacle pillar = circleAhead(2.5, 0);
  pillar.position.y = 2;
  const Warning warning = sendOverGround(100, 100, {pillar});
  EXPECT_EQ(warning.reason, 0u) << warning.message;
  EXPECT_NEAR(warning.time_to_collision, std::atan2(4, 3) / 0.5, 1e-7);
  EXPECT_EQ(warning.segment, 3);
  EXPECT_EQ(warning.footprint, "trailer");
  EXPECT_EQ(warning.header.frame_id, "trailer");
  EXPECT_EQ(predictions.back().footprint, "trailer");
  EXPECT_NEAR(predictions.back().twist.linear.x, 1, 1e-9);
  EXPECT_NEAR(predictions.back().twist.angular.z, 0.5, 1e-9);
  EXPECT_NEAR(pipeline().repeat(at(100.3)).time_to_collision, std::atan2(4, 3) / 0.5 - 0.3, 1e-6);
}

TEST_F(PipelineBodies, WithoutTransformsItsMotionIsUnknownNotZero) {
  // The obstacles are in its own frame, so that only its motion is missing.
  send(100, 100, {circleAhead(4, 0)}, "trailer");
  pipeline().process(at(100.11));
  const Warning warning = warnings.back();
  EXPECT_EQ(warning.level, Warning::UNKNOWN);
  EXPECT_EQ(warning.reason, Warning::REASON_TRANSFORM);
  EXPECT_TRUE(std::isnan(warning.time_to_collision));
  EXPECT_EQ(warning.contact_free_time, 0);
  EXPECT_NE(warning.message.find("\"odom\" and \"trailer\""), std::string::npos) << warning.message;
}

TEST_F(PipelineBodies, WhatTouchesNowIsCertainWithoutAnyMotion) {
  send(100, 100, {circleAhead(1.2, 0)}, "trailer");
  pipeline().process(at(100.11));
  EXPECT_EQ(warnings.back().level, Warning::CRITICAL);
  EXPECT_EQ(warnings.back().time_to_collision, 0);
  EXPECT_EQ(warnings.back().reason, Warning::REASON_TRANSFORM);
}

TEST_F(PipelineBodies, WaitsForTheTransformOfTheStamp) {
  driveUntil(99.95, 1);
  send(100, 100, {circleAhead(4.5, 0)}, "trailer");
  EXPECT_TRUE(warnings.empty());
  setTransform("odom", "trailer", 100, 0, 0, 0);
  pipeline().process(at(100.05));
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_NEAR(warnings[0].time_to_collision, 3, 1e-9);
}

TEST_F(PipelineBodies, TransformsThatCeaseCountUntilMaxDataAge) {
  driveUntil(99.8, 1);
  const auto answer = [&](double t) {
    send(t, t, {circleAhead(4.5, 0)}, "trailer");
    pipeline().process(at(t + 0.11));
    return warnings.back();
  };
  const Warning older = answer(100.1);  // 0.3 s
  EXPECT_EQ(older.reason, 0u) << older.message;
  EXPECT_NEAR(older.time_to_collision, 3, 1e-9);
  EXPECT_NEAR(older.data_age, 0.41, 1e-6);
  const Warning repeated =
      pipeline().repeat(at(100.35));  // obstacles of 0.25 s, transforms of 0.55
  EXPECT_EQ(repeated.level, Warning::UNKNOWN);
  EXPECT_EQ(repeated.reason, Warning::REASON_TRANSFORM);
  EXPECT_TRUE(std::isnan(repeated.time_to_collision));
  const Warning too_old = answer(100.4);  // 0.6 s
  EXPECT_EQ(too_old.level, Warning::UNKNOWN);
  EXPECT_EQ(too_old.reason, Warning::REASON_TRANSFORM);
  EXPECT_NE(too_old.message.find("0.6 s old"), std::string::npos) << too_old.message;
}

TEST_F(PipelineBodies, ALoadOnTheBaseMovesByOdometryAsItIsCarriedRound) {
  // 1 m before a base that turns on the spot with 0.5 rad/s it is moved aside by 0.5 m/s.
  setBody(BodyMotion::kOdom);
  setTransform("base_link", "trailer", 0, 1, 0, 0, true);
  sendOdometry(100, 0, 0.5);
  send(100, {});
  EXPECT_EQ(warnings.back().level, Warning::CLEAR);
  EXPECT_NEAR(predictions.back().twist.linear.x, 0, 1e-12);
  EXPECT_NEAR(predictions.back().twist.linear.y, 0.5, 1e-12);
  EXPECT_EQ(predictions.back().twist.angular.z, 0.5);
}

TEST_F(PipelineBodies, RelativeVelocitiesAreSeenFromTheBaseNotFromTheBody) {
  // The base drives at 1 m/s, so that what comes at (-1, 0) m/s stands; the trailer, 3 m behind,
  // comes with 2 m/s. Its front is 1 m ahead of its frame: 4.5 - 0.5 - 1 = 3 m to go.
  parameters.obstacle_velocity = ObstacleVelocity::kRelative;
  driveUntil(100, 2);
  setTransform("odom", "base_link", 99, 2, 0, 0);
  setTransform("odom", "base_link", 100, 3, 0, 0);
  sendOdometry(100, 1);
  const Warning warning = send(100, {circleAhead(1.5, 1)});
  EXPECT_EQ(warning.reason, 0u) << warning.message;
  EXPECT_NEAR(warning.time_to_collision, 1.5, 1e-9);
  EXPECT_NEAR(predictions.back().twist.linear.x, 2, 1e-9);
}

TEST_F(PipelineBodies, RelativeVelocitiesNeedTheMotionOfTheBase) {
  parameters.obstacle_velocity = ObstacleVelocity::kRelative;
  driveUntil(100, 2);
  setTransform("odom", "base_link", 99, 2, 0, 0);
  setTransform("odom", "base_link", 100, 3, 0, 0);
  send(100, {circleAhead(1.5, 1)});
  pipeline().process(at(100.11));
  EXPECT_EQ(warnings.back().level, Warning::UNKNOWN);
  EXPECT_EQ(warnings.back().reason, Warning::REASON_ODOM_MISSING);
  EXPECT_TRUE(std::isnan(warnings.back().time_to_collision));
}

TEST_F(PipelineBodies, Fault19AClockThatJumpsBackDropsTheTransformsToo) {
  simulated = true;
  driveUntil(100, 1);
  EXPECT_EQ(sendOverGround(100, 100, {circleAhead(4.4, 0)}).level, Warning::WARN);
  pipeline().process({ros::Time(99.5), ros::SteadyTime(100.1)});
  ObstacleArray array;
  array.header.frame_id = "trailer";
  array.header.stamp = ros::Time(99.6);
  pipeline().receiveObstacles(serialized(array), {ros::Time(99.6), ros::SteadyTime(100.2)});
  pipeline().process({ros::Time(99.75), ros::SteadyTime(100.35)});
  EXPECT_EQ(warnings.back().level, Warning::UNKNOWN);
  EXPECT_EQ(warnings.back().reason, Warning::REASON_TRANSFORM) << warnings.back().message;
}

}  // namespace
}  // namespace footprint_collision_predictor
