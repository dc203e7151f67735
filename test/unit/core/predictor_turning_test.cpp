// Footprints that turn, by hand.
#include <gtest/gtest.h>

#include <cmath>

#include "footprint_collision_predictor/predictor.hpp"

namespace footprint_collision_predictor::core {
namespace {

// Segments: 0 below, 1 in front, 2 above, 3 behind.
const std::vector<Vec2> kBox{{-1, -0.5}, {1, -0.5}, {1, 0.5}, {-1, 0.5}};
const std::vector<Vec2> kWall{{0, -3}, {0, 3}};
const double kReach = std::hypot(1, 0.5);  // of a corner

Obstacle still(double x, double y, double radius, const std::vector<Vec2>& outline = {}) {
  return {{{x, y}, {0, 0}, {0, 0}}, radius, 0, outline};
}

Prediction predicted(const Twist& twist, const Obstacle& obstacle, double horizon = 20) {
  return predict(Polygon(kBox), twist, {obstacle}, horizon);
}

TEST(Turning, ACornerSweepsAWall) {
  const double time = std::atan(0.5) - std::acos(1.1 / kReach);  // until its x is 1.1
  const Prediction left = predicted({{0, 0}, 1}, still(1.1, 0, 0, kWall));
  ASSERT_TRUE(left.first);
  EXPECT_NEAR(left.first->contact.time, time, 1e-8);
  EXPECT_EQ(left.first->segment, 0u);  // the corner of 0 and 1
  EXPECT_EQ(left.first->contact.feature, Feature::kEnd);
  EXPECT_EQ(left.first->contact.point, Vec2(1, -0.5));
  EXPECT_NEAR(left.first->closing_speed, std::sqrt(kReach * kReach - 1.21), 1e-6);
  ASSERT_TRUE(left.segments[0] && left.segments[1]);
  EXPECT_NEAR(left.segments[1]->contact.time, time, 1e-8);

  const Prediction right = predicted({{0, 0}, -2}, still(1.1, 0, 0, kWall));
  ASSERT_TRUE(right.first);
  EXPECT_NEAR(right.first->contact.time, time / 2, 1e-8);
  EXPECT_EQ(right.first->contact.point, Vec2(1, 0.5));
  EXPECT_EQ(right.first->segment, 1u);
  EXPECT_FALSE(predicted({{0, 0}, 1}, still(kReach + 1e-6, 0, 0, kWall)).first);
}

TEST(Turning, ASideSweepsAPoint) {
  const double reach = 0.7 * std::sqrt(2);      // the point is so far away, at 45 degrees
  const double angle = std::asin(0.5 / reach);  // of the upper side's point that reaches so far
  const Prediction p = predicted({{0, 0}, 0.5}, still(0.7, 0.7, 0));
  ASSERT_TRUE(p.first);
  EXPECT_NEAR(p.first->contact.time, (M_PI / 4 - angle) / 0.5, 1e-8);
  EXPECT_EQ(p.first->segment, 2u);
  EXPECT_NEAR((p.first->contact.point - Vec2(reach * std::cos(angle), 0.5)).norm(), 0, 1e-8);
  EXPECT_FALSE(predicted({{0, 0}, 0.5}, still(0.8, 0.8, 0)).first);  // beyond the corners
}

TEST(Turning, WhatItDrivesRoundIsNeverMet) {
  // Ten rounds on a circle of 4 m; the upper side passes the post in its centre at 4 - 0.5 m.
  const Obstacle post = still(0, 4, 3.4999);
  const Twist round{{4, 0}, 1};
  EXPECT_FALSE(firstContact(Polygon(kBox), round, post, 20 * M_PI));
  const Prediction p = predicted(round, post, 20 * M_PI);
  EXPECT_FALSE(p.first);
  EXPECT_NEAR(p.closest->distance, 1e-4, 1e-6);
  EXPECT_EQ(firstContact(Polygon(kBox), round, still(0, 4, 3.5001), 20 * M_PI)->contact.time, 0);
}

TEST(Turning, WhatStandsOnTheArcIsMetByTheFront) {
  // On its circle of 4 m about (0, 4) the footprint's origin is at the point after a quarter; the
  // front, 1 m ahead of it, is there by asin(1 / 4) earlier.
  const Prediction p = predicted({{1, 0}, 0.25}, still(4, 4, 0));
  ASSERT_TRUE(p.first);
  EXPECT_NEAR(p.first->contact.time, 4 * (M_PI / 2 - std::asin(0.25)), 1e-8);
  EXPECT_EQ(p.first->segment, 1u);
  // In the robot's frame: 1 m ahead, and by 4 - sqrt(16 - 1) to the left.
  EXPECT_NEAR((p.first->contact.point - Vec2(1, 4 - std::sqrt(15))).norm(), 0, 1e-6);
  EXPECT_NEAR(p.first->closing_speed, 0.25 * std::sqrt(15), 1e-6);
}

TEST(Turning, WhatStandsInTheCentreOfTheArcIsNeverMet) {
  const Prediction p = predicted({{1, 0}, 0.5}, still(0, 2, 1.4), 100);
  EXPECT_FALSE(p.first);
  ASSERT_TRUE(p.closest && p.clearance);
  EXPECT_NEAR(p.closest->distance, 0.1, 1e-6);  // 2 - 0.5 - 1.4, all the time
  EXPECT_NEAR(*p.clearance, 0.1, 1e-12);
  EXPECT_TRUE(predicted({{1, 0}, 0.5}, still(0, 2, 1.5), 100).first);
}

TEST(Turning, TheFarthestCornerPassesAtItsReach) {
  // About (0, 2): the corners at (1, -0.5) and (-1, -0.5) reach sqrt(1 + 6.25).
  const double reach = std::hypot(1, 2.5);
  const Prediction p = predicted({{1, 0}, 0.5}, still(6, 2, 0.5), 3);
  ASSERT_TRUE(p.closest);
  EXPECT_FALSE(p.first);
  EXPECT_NEAR(p.closest->distance, 5.5 - reach, 1e-6);
  EXPECT_NEAR(p.closest->time, std::atan(2.5) / 0.5, 1e-2);
}

TEST(Turning, ByNearlyNothingIsGoingStraight) {
  const Obstacle disc{{{5, 0.25}, {-1, 0}, {0, 0}}, 0.5};
  for (const double w : {0.0, 1e-300, 1e-15, -1e-12, 1e-9}) {
    const Prediction p = predicted({{1, 0}, w}, disc);
    ASSERT_TRUE(p.first);
    EXPECT_NEAR(p.first->contact.time, 1.75, 1e-8) << w;
    EXPECT_EQ(p.first->segment, 1u);
  }
}

}  // namespace
}  // namespace footprint_collision_predictor::core
