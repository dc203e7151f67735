// Bad input is refused by name, and what is certain is still said.
#include <cmath>
#include <limits>
#include <utility>

#include "pipeline_fixture.hpp"

namespace footprint_collision_predictor {
namespace {

using Warning = CollisionWarning;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

class PipelineFaults : public PipelineFixture {
 protected:
  void settle(double until) {
    for (double t = until - 0.3; t < until - 1e-6; t += 0.1) send(t, {});
  }
  void expectUnknown(const Warning& warning, std::uint32_t reason, const std::string& word) {
    EXPECT_EQ(warning.level, Warning::UNKNOWN);
    EXPECT_EQ(warning.reason & reason, reason) << warning.message;
    EXPECT_NE(warning.message.find(word), std::string::npos) << warning.message;
    EXPECT_EQ(warning.contact_free_time, 0);
    EXPECT_FALSE(std::isinf(warning.time_to_collision));
  }
};

TEST_F(PipelineFaults, Fault02OneBadObstacleMakesUnknownAndNamesItsField) {
  settle(100);
  Obstacle bad = circleAhead(100, 0);
  bad.id = 42;
  bad.velocity.y = kNaN;
  const Warning warning = send(100, {circleAhead(30, 0), bad});
  expectUnknown(warning, Warning::REASON_OBSTACLES_INVALID, "42");
  EXPECT_NE(warning.message.find("velocity.y"), std::string::npos) << warning.message;
  EXPECT_TRUE(std::isnan(warning.clearance));
  EXPECT_TRUE(std::isnan(predictions.back().segments[0].time_to_collision));
  EXPECT_EQ(predictions.back().segments[0].contact_free_time, 0);
}

TEST_F(PipelineFaults, Fault02ACertainHitAmongTheOthersIsStillCritical) {
  Obstacle bad = circleAhead(100, 0);
  bad.radius = -1;
  const Warning warning = send(100, {bad, circleAhead(3, 2)});
  EXPECT_EQ(warning.level, Warning::CRITICAL);
  EXPECT_TRUE(warning.reason & Warning::REASON_OBSTACLES_INVALID);
  EXPECT_NEAR(warning.time_to_collision, 1, 1e-9);
  EXPECT_EQ(warning.contact_free_time, 0);
  EXPECT_EQ(predictions.back().segments[3].obstacle_index, 1);
}

TEST_F(PipelineFaults, Fault09TruncatedMessage) {
  ObstacleArray array;
  array.header.frame_id = "base_link";
  array.header.stamp = ros::Time(100);
  array.obstacles.resize(2);
  const RawMessage whole = serialized(array);
  for (std::size_t length = 0; length < whole.bytes.size(); ++length) {
    RawMessage part = whole;
    part.bytes.resize(length);
    pipeline().receiveObstacles(part, at(100));
    expectUnknown(warnings.back(), Warning::REASON_OBSTACLES_INVALID, "/obstacles");
  }
  RawMessage longer = whole;
  longer.bytes.push_back(0);
  pipeline().receiveObstacles(longer, at(100));
  expectUnknown(warnings.back(), Warning::REASON_OBSTACLES_INVALID, "bytes follow");
}

TEST_F(PipelineFaults, ARefusedMessageLeavesTheLastGoodOnePredicted) {
  send(100, {circleAhead(3, 2)});
  RawMessage nonsense = serialized(ObstacleArray());
  nonsense.bytes.clear();
  pipeline().receiveObstacles(nonsense, at(100.1));
  EXPECT_EQ(warnings.back().level, Warning::CRITICAL);
  EXPECT_NEAR(warnings.back().time_to_collision, 0.9, 1e-9);
  EXPECT_EQ(warnings.back().reason, Warning::REASON_OBSTACLES_INVALID);
  EXPECT_EQ(pipeline().repeat(at(100.2)).reason, Warning::REASON_OBSTACLES_INVALID);
  EXPECT_EQ(send(100.3, {}).reason, 0u);
}

TEST_F(PipelineFaults, Fault11FrameNames) {
  expectUnknown(send(100, 100, {}, ""), Warning::REASON_TRANSFORM, "frame_id");
  send(100, 100, {}, "nowhere");
  pipeline().process(at(100.11));
  expectUnknown(warnings.back(), Warning::REASON_TRANSFORM, "nowhere");
  EXPECT_NE(warnings.back().message.find("base_link"), std::string::npos);
  EXPECT_EQ(send(100.2, 100.2, {}, "/base_link").reason, Warning::REASON_SETTLING);
}

TEST_F(PipelineFaults, Fault15To17Stamps) {
  expectUnknown(send(100, 0, {}), Warning::REASON_STAMP, "stamp 0");
  expectUnknown(send(100, 99.4, {}), Warning::REASON_OBSTACLES_STALE, "0.6 s old");
  send(100, 100.06, {});
  pipeline().process(at(100.1));
  expectUnknown(warnings.back(), Warning::REASON_STAMP, "--hz 1000");
  send(100.2, 4.2e9, {});
  pipeline().process(at(100.3));
  expectUnknown(warnings.back(), Warning::REASON_STAMP, "years");
  expectUnknown(send(1e9, 5e8, {}), Warning::REASON_OBSTACLES_STALE, "years old");
}

TEST_F(PipelineFaults, Fault16ASimulatedClockThatComesLateMayCatchUp) {
  simulated = true;
  send(100, 100.09, {circleAhead(3, 2)});
  EXPECT_TRUE(warnings.empty()) << "the clock may have been held up on its way here";
  pipeline().process({ros::Time(100.08), ros::SteadyTime(100.01)});
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0].reason, 0u);
  EXPECT_NEAR(warnings[0].time_to_collision, 1, 1e-9);
}

TEST_F(PipelineFaults, Fault22OlderStampsAreIgnoredAndEqualOnesReplace) {
  settle(100);
  send(100, {circleAhead(3, 2)});
  const Warning ignored = send(100.05, 99.95, {});
  EXPECT_EQ(ignored.level, Warning::CRITICAL);
  EXPECT_EQ(ignored.reason, Warning::REASON_OUT_OF_ORDER);
  const Warning replaced = send(100.05, 100, {circleAhead(5, 1)});
  EXPECT_NEAR(replaced.time_to_collision, 4, 1e-9);
  EXPECT_EQ(replaced.reason, 0u);
}

TEST_F(PipelineFaults, Fault14DuplicateIdsArePredictedAndNamed) {
  settle(100);
  const Warning warning = send(100, {circleAhead(30, 0), circleAhead(3, 2)});
  EXPECT_EQ(warning.reason, Warning::REASON_DUPLICATE_ID);
  EXPECT_NEAR(warning.time_to_collision, 1, 1e-9);
  Obstacle nameless = circleAhead(30, 0);
  nameless.id = -1;
  EXPECT_EQ(send(100.1, {nameless, nameless}).reason, 0u);
}

TEST_F(PipelineFaults, Fault07TooManyObstacles) {
  parameters.max_obstacles = 2;
  expectUnknown(send(100, {circleAhead(9, 0), circleAhead(9, 0), circleAhead(9, 0)}),
                Warning::REASON_LIMIT, "~max_obstacles 2");
}

TEST_F(PipelineFaults, Fault23FootprintOdometryAndObstaclesStampedApartAreBroughtToOneTime) {
  parameters.footprint.reset();
  parameters.ego_motion = EgoMotion::kOdom;
  setTransform("odom", "base_link", 99.8, 0, 0, 0);
  setTransform("odom", "base_link", 100, 2, 0, 0);
  sendFootprint(100, 99.8, 0.5, "odom");  // about base_link as it was then
  sendOdometry(100, 99.95, 1, 0);
  sendOdometry(100.01, 100.01, 3, 0);
  // 3 m before base_link at its stamp; less half a footprint and the radius, at 1 m/s.
  const Warning warning = send(100.02, 100, {circleAhead(5, 0)}, "odom");
  EXPECT_NEAR(warning.time_to_collision, 2, 1e-9) << warning.message;
}

TEST_F(PipelineFaults, Fault37AnExceptionIsUnknownAndTheNextMessageIsAnswered) {
  bool fails = true;
  std::vector<Warning> answers;
  Pipeline failing(parameters, bodiesOf(parameters).front(), {"/obstacles", "/footprint", "/odom"},
                   tf, simulated, [&](const Answer& answer) {
                     if (std::exchange(fails, false)) throw std::runtime_error("out of luck");
                     answers.push_back(answer.warning);
                   });
  ObstacleArray array;
  array.header.frame_id = "base_link";
  array.header.stamp = ros::Time(100);
  failing.receiveObstacles(serialized(array), at(100));
  ASSERT_EQ(answers.size(), 1u);
  expectUnknown(answers[0], Warning::REASON_OBSTACLES_INVALID, "out of luck");
  array.header.stamp = ros::Time(100.1);
  failing.receiveObstacles(serialized(array), at(100.1));
  EXPECT_EQ(answers.back().reason, Warning::REASON_SETTLING) << answers.back().message;
}

}  // namespace
}  // namespace footprint_collision_predictor
