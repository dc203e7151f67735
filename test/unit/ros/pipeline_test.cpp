// What obstacles messages and heartbeats say, from the inputs to the level.
#include <cmath>

#include "pipeline_fixture.hpp"

namespace footprint_collision_predictor {
namespace {

using Warning = CollisionWarning;
class PipelineTest : public PipelineFixture {};

TEST_F(PipelineTest, SaysUnknownAndWhatIsMissingBeforeAnyInput) {
  parameters.footprint.reset();
  parameters.ego_motion = EgoMotion::kOdom;
  const Warning warning = pipeline().repeat(at(100));
  EXPECT_EQ(warning.level, Warning::UNKNOWN);
  EXPECT_EQ(warning.reason, Warning::REASON_OBSTACLES_MISSING | Warning::REASON_FOOTPRINT_MISSING |
                                Warning::REASON_ODOM_MISSING);
  for (const char* word : {"/obstacles", "~footprint", "/odom"})
    EXPECT_NE(warning.message.find(word), std::string::npos) << warning.message;
  EXPECT_TRUE(std::isnan(warning.time_to_collision));
  EXPECT_EQ(warning.contact_free_time, 0);
  EXPECT_TRUE(std::isinf(warning.data_age));
}

TEST_F(PipelineTest, Fault10AnEmptyListIsClearOnceItHasSettled) {
  for (int i = 0; i < 2; ++i) {
    const Warning settling = send(100 + 0.1 * i, {});
    EXPECT_EQ(settling.level, Warning::UNKNOWN);
    EXPECT_EQ(settling.reason, Warning::REASON_SETTLING);
    EXPECT_EQ(settling.contact_free_time, 0);
  }
  const Warning clear = send(100.2, {});
  EXPECT_EQ(clear.level, Warning::CLEAR);
  EXPECT_EQ(clear.reason, 0u);
  EXPECT_EQ(clear.message, "");
  EXPECT_EQ(clear.contact_free_time, 5);
  EXPECT_TRUE(std::isinf(clear.time_to_collision));
  EXPECT_TRUE(std::isinf(clear.clearance));
  EXPECT_TRUE(std::isinf(clear.closest_distance));
  EXPECT_TRUE(std::isnan(clear.closest_time));
  EXPECT_EQ(clear.segment, -1);
}

TEST_F(PipelineTest, PredictsAGrowingRadius) {
  Obstacle growing = circleAhead(3, 0);  // 2 m from the front
  growing.radius_rate = 0.8;
  const Warning warning = send(100, {growing});
  EXPECT_NEAR(warning.time_to_collision, 2.5, 1e-9);
  EXPECT_EQ(warning.closing_speed, 0);
}

TEST_F(PipelineTest, PredictsALine) {
  Obstacle wall = circleAhead(3, 2, 0.5);  // across the way, 2 m from the front
  wall.outline.resize(2);
  wall.outline[0].y = -4;
  wall.outline[1].y = 4;
  const Warning warning = send(100, {wall});
  EXPECT_NEAR(warning.time_to_collision, 1, 1e-9);
  EXPECT_EQ(warning.segment,
            0);  // both ends of the front touch it; the left one is of segment 0 too
  EXPECT_EQ(warning.obstacle_id, 7);
  EXPECT_NEAR(warning.clearance, 2, 1e-12);
  EXPECT_EQ(warning.reason & Warning::REASON_NOT_PREDICTED, 0u);
}

TEST_F(PipelineTest, RefusesAnOutlineOfOneVertex) {
  Obstacle vertex = circleAhead(3, 0);
  vertex.outline.resize(1);
  EXPECT_EQ(send(100, {vertex}).reason & Warning::REASON_OBSTACLES_INVALID,
            Warning::REASON_OBSTACLES_INVALID);
}

TEST_F(PipelineTest, TellsTheClosestApproach) {
  // Passes the front at 1 m beside it, less its radius, after 2 s.
  Obstacle passing = circleAhead(1.5, 0);
  passing.position.y = -2;
  passing.velocity.y = 1;
  const Warning warning = send(100, {passing});
  EXPECT_NEAR(warning.closest_distance, 0.5, 1e-6);
  EXPECT_GE(warning.closest_time, 1.5 - 1e-3);  // anywhere along the front
  EXPECT_LE(warning.closest_time, 2.5 + 1e-3);
  Obstacle hit = circleAhead(3, 2);
  EXPECT_EQ(send(100.1, {hit}).closest_distance, 0);
  EXPECT_NEAR(warnings.back().closest_time, 1, 1e-9);
}

TEST_F(PipelineTest, ReportsTheFirstContactInEveryField) {
  // Front at 0.5 m, circle of 0.5 m at 3 m: 2 m to go at 2 m/s.
  const Warning warning = send(100, {circleAhead(3, 2)});
  EXPECT_EQ(warning.level, Warning::CRITICAL);
  EXPECT_EQ(warning.collision_predicted, 1);
  EXPECT_NEAR(warning.time_to_collision, 1, 1e-9);
  EXPECT_NEAR(warning.contact_free_time, 1, 1e-9);
  EXPECT_EQ(warning.segment, 3);
  EXPECT_EQ(warning.obstacle_id, 7);
  EXPECT_NEAR(warning.contact_point.x, 0.5, 1e-9);
  EXPECT_NEAR(warning.clearance, 2, 1e-9);
  EXPECT_NEAR(warning.closing_speed, 2, 1e-9);
  EXPECT_EQ(warning.obstacle_count, 1u);
  EXPECT_EQ(warning.header.frame_id, "base_link");
  EXPECT_EQ(warning.header.stamp, ros::Time(100));
  ASSERT_EQ(predictions.size(), 1u);
  ASSERT_EQ(predictions[0].segments.size(), 4u);
  EXPECT_NEAR(predictions[0].segments[3].time_to_collision, 1, 1e-9);
  EXPECT_EQ(predictions[0].segments[3].feature, SegmentPrediction::INSIDE);
  EXPECT_EQ(predictions[0].segments[3].obstacle_index, 0);
  EXPECT_NEAR(predictions[0].area, 1, 1e-12);
}

TEST_F(PipelineTest, CountsDownBetweenMessages) {
  send(100, {circleAhead(3, 2)});
  const Warning later = pipeline().repeat(at(100.25));
  EXPECT_EQ(later.header.stamp, ros::Time(100.25));
  EXPECT_NEAR(later.time_to_collision, 0.75, 1e-9);
  EXPECT_NEAR(later.clearance, 1.5, 1e-9);
  EXPECT_EQ(predictions.size(), 1u) << "a repeat is a warning only";
}

TEST_F(PipelineTest, FallsOnlyAfterClearAfterLowerMessages) {
  EXPECT_EQ(send(100, {circleAhead(3, 2)}).level, Warning::CRITICAL);
  EXPECT_EQ(send(100.1, {}).level, Warning::CRITICAL);
  EXPECT_EQ(pipeline().repeat(at(100.15)).level, Warning::CRITICAL);
  EXPECT_EQ(send(100.2, {}).level, Warning::CRITICAL);
  const Warning released = send(100.3, {});
  EXPECT_EQ(released.level, Warning::CLEAR);
}

TEST_F(PipelineTest, AGapInTheStampsRestartsTheCount) {
  send(100, {circleAhead(3, 2)});
  send(100.1, {});
  send(100.2, {});
  EXPECT_EQ(send(101, {}).level, Warning::CRITICAL);
  EXPECT_EQ(send(101.1, {}).level, Warning::CRITICAL);
  EXPECT_EQ(send(101.2, {}).level, Warning::CLEAR);
}

TEST_F(PipelineTest, Fault18LossOfDataIsNeverHeldBack) {
  send(100, {circleAhead(3, 2)});
  EXPECT_EQ(pipeline().repeat(at(100.45)).level, Warning::CRITICAL);
  const Warning stale = pipeline().repeat(at(100.55));
  EXPECT_EQ(stale.level, Warning::UNKNOWN);
  EXPECT_EQ(stale.reason, Warning::REASON_OBSTACLES_STALE);
  EXPECT_TRUE(std::isnan(stale.time_to_collision));
  EXPECT_EQ(stale.contact_free_time, 0);
  EXPECT_NEAR(stale.data_age, 0.55, 1e-6);
}

TEST_F(PipelineTest, AnOldWallClockStampIsNoticedByTheSteadyClock) {
  send(100, {});
  const Moment wall_clock_set_back{ros::Time(99.99), ros::SteadyTime(100.6)};
  EXPECT_EQ(pipeline().repeat(wall_clock_set_back).reason, Warning::REASON_OBSTACLES_STALE);
}

TEST_F(PipelineTest, AFootprintThatIsMissingIsNamedForEveryMessage) {
  parameters.footprint.reset();
  const Warning warning = send(100, {circleAhead(3, 2)});
  EXPECT_EQ(warning.level, Warning::UNKNOWN);
  EXPECT_EQ(warning.reason, Warning::REASON_FOOTPRINT_MISSING);
  EXPECT_TRUE(predictions.empty());
}

}  // namespace
}  // namespace footprint_collision_predictor
