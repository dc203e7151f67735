// The time of a recording: what is evaluated when, and by which clock.
#include "analysis/replay.hpp"

#include <gtest/gtest.h>
#include <rosgraph_msgs/Clock.h>

#include "pipeline_fixture.hpp"

namespace footprint_collision_predictor::tools {
namespace {

constexpr double kBegin = 1000;  // [s]

class ReplayTest : public testing::Test {
 protected:
  ReplayTest() {
    parameters.footprint = squareOfOneMetre();
    parameters.ego_motion = EgoMotion::kStatic;
  }

  Replay& replay() {
    if (!replay_)
      replay_.emplace(parameters, bodiesOf(parameters).front(),
                      InputNames{"/obstacles", "/footprint", "/odom"},
                      Window{ros::Time(kBegin), ros::Time(kBegin + 100)},
                      [this](const Evaluation& e) { evaluations.push_back(e); });
    return *replay_;
  }

  template <typename Message>
  void take(Input input, double recorded, const Message& message) {
    replay().take({input, ros::Time(kBegin + recorded), serialized(message)});
  }

  void obstacles(double recorded, double stamp, const std::string& frame = "base_link") {
    ObstacleArray message;
    message.header.stamp = ros::Time(stamp);
    message.header.frame_id = frame;
    take(Input::kObstacles, recorded, message);
  }

  void clock(double recorded, double time) {
    rosgraph_msgs::Clock message;
    message.clock = ros::Time(time);
    take(Input::kClock, recorded, message);
  }

  Parameters parameters;
  std::vector<Evaluation> evaluations;

 private:
  std::optional<Replay> replay_;
};

TEST_F(ReplayTest, ElapsedCountsFromTheBeginOfTheWindow) {
  obstacles(2, kBegin + 2);
  EXPECT_NEAR(evaluations.back().elapsed, 2, 1e-9);
}

TEST_F(ReplayTest, ObstaclesBeforeTheWindowArePassedOver) {
  obstacles(-1, kBegin - 1);
  EXPECT_TRUE(evaluations.empty());
}

TEST_F(ReplayTest, SilenceIsSaidOnceAndFromTheBeginOn) {
  replay().finish(ros::Time(kBegin + 10));
  ASSERT_EQ(evaluations.size(), 1u);
  EXPECT_TRUE(evaluations[0].silence);
  EXPECT_NEAR(evaluations[0].elapsed, parameters.max_data_age, 1e-6);
  EXPECT_TRUE(evaluations[0].answer.warning.reason & CollisionWarning::REASON_OBSTACLES_MISSING);
}

TEST_F(ReplayTest, NoSilenceWhileMessagesCome) {
  for (int i = 0; i < 50; ++i) obstacles(0.4 * i, kBegin + 0.4 * i);
  for (const Evaluation& e : evaluations) EXPECT_FALSE(e.silence) << e.elapsed;
}

TEST_F(ReplayTest, WhatStillWaitsAtTheEndIsEvaluated) {
  obstacles(1, kBegin + 1, "laser");
  EXPECT_TRUE(evaluations.empty() || evaluations.back().silence);
  replay().finish(ros::Time(kBegin + 1));
  EXPECT_TRUE(evaluations.back().answer.warning.reason & CollisionWarning::REASON_TRANSFORM);
}

TEST_F(ReplayTest, ClockOfTheRecorderIsNotNeeded) {
  clock(0, kBegin);  // coarse, and the recorder's own
  obstacles(0.4, kBegin + 0.4);
  EXPECT_EQ(evaluations.back().answer.warning.reason, CollisionWarning::REASON_SETTLING);
}

TEST_F(ReplayTest, ClockOfASimulatorThatWasRecordedByTheWallClockCounts) {
  clock(0, 5);
  obstacles(0.01, 5);
  EXPECT_EQ(evaluations.back().answer.warning.reason, CollisionWarning::REASON_SETTLING);
}

TEST_F(ReplayTest, ClockThatJumpsBackStartsAnew) {
  clock(0, 50);
  obstacles(0.01, 50);
  clock(0.1, 2);
  obstacles(0.11, 2);
  ASSERT_EQ(evaluations.size(), 2u);
  EXPECT_TRUE(evaluations[1].answer.prediction) << evaluations[1].answer.warning.message;
}

}  // namespace
}  // namespace footprint_collision_predictor::tools
