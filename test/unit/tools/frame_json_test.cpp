// What a report keeps of one evaluation.
#include "analysis/frame_json.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "pipeline_fixture.hpp"

namespace footprint_collision_predictor::tools {
namespace {

using Json = nlohmann::json;

class FrameJsonTest : public testing::Test {
 protected:
  FrameJsonTest() {
    parameters.footprint = squareOfOneMetre();
    parameters.ego_motion = EgoMotion::kStatic;
    parameters.clear_after = 1;
    message.header.stamp = ros::Time(1000);
    message.header.frame_id = "base_link";
  }

  Json frame() {
    Replay replay(parameters, bodiesOf(parameters).front(), InputNames{"/obstacles", "", ""},
                  Window{ros::Time(998), ros::Time(1100)},
                  [this](const Evaluation& e) { json_ = Json::parse(frameJson(e)); });
    replay.take({Input::kObstacles, ros::Time(1000), serialized(message)});
    return json_;
  }

  Parameters parameters;
  ObstacleArray message;

 private:
  Json json_;
};

TEST_F(FrameJsonTest, ContactAhead) {
  message.obstacles = {circleAhead(3, 1)};  // 2 m from the front
  const Json json = frame();
  EXPECT_EQ(json[0], 2);  // since the window's begin
  EXPECT_NEAR(json[2].get<double>(), 2, 1e-9);
  EXPECT_NEAR(json[3].get<double>(), 2, 1e-9);
  EXPECT_NEAR(json[4].get<double>(), 1, 1e-9);
  EXPECT_EQ(json[5], 3);
  EXPECT_EQ(json[6], 7);
  const Json& scene = json[8];
  EXPECT_EQ(scene[0], Json::parse("[0, 0, 0]"));
  EXPECT_EQ(scene[1], Json::parse("[5000, 0]"));
  EXPECT_EQ(scene[2][3], 2);
  EXPECT_EQ(scene[3], Json::parse("[[0, 7, 2.0, 30000, 0, -10000, 0, 5000]]"));
  EXPECT_EQ(scene[4], 0);
  EXPECT_EQ(scene[5], Json::parse("[[5000, 5000], [-5000, 5000], [-5000, -5000], [5000, -5000]]"));
}

TEST_F(FrameJsonTest, NoneIsNullAndUnknownIsNot) {
  Json json = frame();
  EXPECT_TRUE(json[2].is_null());
  EXPECT_TRUE(json[3].is_null());
  EXPECT_EQ(json[5], nullptr);
  EXPECT_EQ(json[8][2], Json::parse("[null, null, null, null]"));
  message.header.frame_id = "camera";
  json = frame();
  EXPECT_EQ(json[2], "?");
  EXPECT_EQ(json[3], "?");
  EXPECT_TRUE(json[8].is_null());
}

TEST_F(FrameJsonTest, LineThatBrakesAndGrows) {
  Obstacle line = circleAhead(3, 1, 0.25);
  line.acceleration.x = 0.5;
  line.radius_rate = 0.125;
  line.outline.resize(2);
  line.outline[0].y = -1;
  line.outline[1].y = 1;
  message.obstacles = {line};
  const Json obstacle = frame()[8][3][0];
  EXPECT_EQ(obstacle[7], 2500);
  EXPECT_EQ(obstacle[8], 5000);
  EXPECT_EQ(obstacle[10], 1250);
  EXPECT_EQ(obstacle[11], Json::parse("[[0, -10000], [0, 10000]]"));
}

TEST_F(FrameJsonTest, OfVeryManyObstaclesThoseThatMatter) {
  for (int i = 0; i < 100; ++i) message.obstacles.push_back(circleAhead(-100 + i, 0, 0.1));
  message.obstacles.push_back(circleAhead(-200, -60, 0.1));  // comes from behind
  const Json scene = frame()[8];
  ASSERT_EQ(scene[3].size(), kMostObstaclesKept);
  EXPECT_EQ(scene[4], 101 - kMostObstaclesKept);
  EXPECT_EQ(scene[3][0][0], 100);
  EXPECT_EQ(scene[3][1][0], 99);
}

TEST_F(FrameJsonTest, IdsThatJavaScriptWouldRoundAreText) {
  message.obstacles = {circleAhead(3, 1)};
  message.obstacles[0].id = 9007199254740993;
  const Json json = frame();
  EXPECT_EQ(json[6], "9007199254740993");
  EXPECT_EQ(json[8][3][0][1], "9007199254740993");
}

TEST_F(FrameJsonTest, LongOutlineIsShortened) {
  Obstacle wall = circleAhead(3, 0, 0);
  wall.outline.resize(1000);
  for (std::size_t i = 0; i < wall.outline.size(); ++i) {
    wall.outline[i].x = std::cos(0.00628 * static_cast<double>(i));
    wall.outline[i].y = std::sin(0.00628 * static_cast<double>(i));
  }
  message.obstacles = {wall};
  const std::size_t kept = frame()[8][3][0][11].size();
  EXPECT_GE(kept, 30u);
  EXPECT_LE(kept, 60u);
}

}  // namespace
}  // namespace footprint_collision_predictor::tools
