// Nothing old looks fresh, nothing refused is forgotten too early, and nothing uncertain looks
// certain.
#include <cmath>
#include <limits>

#include "pipeline_fixture.hpp"

namespace footprint_collision_predictor {
namespace {

using Warning = CollisionWarning;

class PipelineFreshness : public PipelineFixture {
 protected:
  static RawMessage truncated() {
    RawMessage message = serialized(ObstacleArray());
    message.bytes.resize(3);
    return message;
  }
};

TEST_F(PipelineFreshness, AMessageEvaluatedWithOldOdometryIsUnknown) {
  parameters.ego_motion = EgoMotion::kOdom;
  parameters.clear_after = 1;
  sendOdometry(100, 0);
  send(100.49, {});
  pipeline().process(at(100.6));  // no newer odometry within transform_tolerance
  EXPECT_EQ(warnings.back().level, Warning::UNKNOWN);
  EXPECT_EQ(warnings.back().reason, Warning::REASON_ODOM_STALE);
  EXPECT_NEAR(warnings.back().data_age, 0.6, 1e-6);
}

TEST_F(PipelineFreshness, AMessageThatGrowsTooOldWhileWaitingIsUnknown) {
  parameters.clear_after = 1;
  setTransform("odom", "base_link", 99, 0, 0, 0);
  send(100.45, 100, {}, "odom");
  setTransform("odom", "base_link", 101, 0, 0, 0);
  pipeline().process(at(100.54));
  EXPECT_EQ(warnings.back().level, Warning::UNKNOWN);
  EXPECT_EQ(warnings.back().reason, Warning::REASON_OBSTACLES_STALE);
}

TEST_F(PipelineFreshness, AnEarlierGoodMessageDoesNotUndoALaterRefusal) {
  parameters.ego_motion = EgoMotion::kOdom;
  parameters.clear_after = 1;
  sendOdometry(99.9, 0);
  send(100, {});  // waits for odometry
  pipeline().receiveObstacles(truncated(), at(100.02));
  sendOdometry(100.03, 0);
  ASSERT_EQ(warnings.size(), 2u);
  EXPECT_EQ(warnings[0].level, Warning::CLEAR);
  EXPECT_EQ(warnings[1].level, Warning::UNKNOWN);
  EXPECT_EQ(pipeline().repeat(at(100.04)).reason, Warning::REASON_OBSTACLES_INVALID);
}

TEST_F(PipelineFreshness, AStampThatTf2CannotComputeWithIsRefusedLikeAnyOther) {
  parameters.footprint.reset();
  parameters.clear_after = 1;
  setTransform("odom", "base_link", 99, 0, 0, 0);
  setTransform("odom", "base_link", 101, 0, 0, 0);
  sendFootprint(100, 100, 0.5);
  EXPECT_EQ(send(100, {}).level, Warning::CLEAR);
  sendFootprint(100.1, 4294967290.0, 0.5, "odom");
  pipeline().process(at(100.25));
  const Warning after = pipeline().repeat(at(100.3));
  EXPECT_EQ(after.level, Warning::UNKNOWN);
  EXPECT_EQ(after.reason & Warning::REASON_FOOTPRINT_INVALID, Warning::REASON_FOOTPRINT_INVALID);
}

TEST_F(PipelineFreshness, RepeatsDoNotCarryOnWhatMovesInUnknownWays) {
  parameters.ego_motion = EgoMotion::kOdom;
  send(100, {circleAhead(1.5, 2)});  // would touch at 100.25, if the robot stood still
  pipeline().process(at(100.11));
  const Warning repeated = pipeline().repeat(at(100.4));
  EXPECT_EQ(repeated.level, Warning::UNKNOWN);
  EXPECT_TRUE(std::isnan(repeated.time_to_collision));
}

TEST_F(PipelineFreshness, AFootprintThatGrowsIsSeenAtOnce) {
  parameters.footprint.reset();
  parameters.clear_after = 1;
  sendFootprint(100, 100, 0.5F);
  EXPECT_EQ(send(100, {circleAhead(2, 0)}).level, Warning::CLEAR);
  sendFootprint(100.05, 100.05, 1.75F);
  const Warning repeated = pipeline().repeat(at(100.1));
  EXPECT_EQ(repeated.level, Warning::CRITICAL);
  EXPECT_EQ(repeated.time_to_collision, 0);
}

TEST_F(PipelineFreshness, AFootprintAfterTheObstaclesDoesNotMakeThemClear) {
  parameters.footprint.reset();
  parameters.clear_after = 1;
  send(100, {});
  sendFootprint(100.05, 100.05, 0.5F);
  EXPECT_EQ(pipeline().repeat(at(100.1)).level, Warning::UNKNOWN);
  EXPECT_EQ(send(100.2, {}).level, Warning::CLEAR);
}

TEST_F(PipelineFreshness, OdometryOfAnotherClockBeforeTheSimulatedOneStartsIsForgotten) {
  simulated = true;
  parameters.ego_motion = EgoMotion::kOdom;
  nav_msgs::Odometry odometry;
  odometry.header.stamp = ros::Time(1.7e9);
  odometry.child_frame_id = "base_link";
  pipeline().receiveOdometry(serialized(odometry), {ros::Time(), ros::SteadyTime(10.0)});
  sendOdometry(100, 0);
  EXPECT_EQ(send(100, {circleAhead(3, 2)}).level, Warning::CRITICAL);
  EXPECT_EQ(warnings.back().reason, 0u);
}

TEST_F(PipelineFreshness, IgnoredOdometryDoesNotUndoARefusal) {
  parameters.ego_motion = EgoMotion::kOdom;
  sendOdometry(100, 0);
  sendOdometry(100.02, std::numeric_limits<double>::quiet_NaN());
  sendOdometry(100.04, 99, 0, 0);
  const auto reason = pipeline().repeat(at(100.05)).reason;
  EXPECT_EQ(reason & Warning::REASON_ODOM_INVALID, Warning::REASON_ODOM_INVALID);
}

TEST_F(PipelineFreshness, MessagesWithOneStampCountOnce) {
  send(100, {circleAhead(3, 2)});
  send(100.1, {});
  send(100.1, {});
  EXPECT_EQ(send(100.1, {}).level, Warning::CRITICAL);
  send(100.2, {});
  EXPECT_EQ(send(100.3, {}).level, Warning::CLEAR);
}

TEST_F(PipelineFreshness, Fault35AnEvaluationThatTookTooLongIsUnknown) {
  for (double t = 100; t < 100.25; t += 0.1) send(t, {});
  const Warning clear = warnings.back();
  ASSERT_EQ(clear.level, Warning::CLEAR);
  EXPECT_EQ(finishedAfter(0.04, clear, parameters).level, Warning::CLEAR);
  EXPECT_NEAR(finishedAfter(0.04, clear, parameters).data_age, 0.04, 1e-6);
  const Warning late = finishedAfter(0.06, clear, parameters);
  EXPECT_EQ(late.level, Warning::UNKNOWN);
  EXPECT_EQ(late.reason, Warning::REASON_DEADLINE);
  EXPECT_EQ(late.contact_free_time, 0);
  EXPECT_TRUE(std::isnan(late.time_to_collision));
  EXPECT_EQ(olderBy(0.6, clear, parameters).reason, Warning::REASON_OBSTACLES_STALE);
}

TEST_F(PipelineFreshness, ACertainHitStaysCriticalWhenLateButNotWhenTooOld) {
  const Warning critical = send(100, {circleAhead(3, 2)});
  const Warning late = finishedAfter(0.06, critical, parameters);
  EXPECT_EQ(late.level, Warning::CRITICAL);
  EXPECT_NEAR(late.time_to_collision, 1, 1e-9);
  EXPECT_EQ(late.contact_free_time, 0);
  const Warning old = olderBy(0.6, critical, parameters);
  EXPECT_EQ(old.level, Warning::UNKNOWN);
  EXPECT_TRUE(std::isnan(old.time_to_collision));
  EXPECT_EQ(old.segment, -1);
}

}  // namespace
}  // namespace footprint_collision_predictor
