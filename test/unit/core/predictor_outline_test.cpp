// Lines and polygons, by hand.
#include <gtest/gtest.h>

#include <cmath>

#include "footprint_collision_predictor/predictor.hpp"

namespace footprint_collision_predictor::core {
namespace {

using Vertices = std::vector<Vec2>;

// Segments: 0 below, 1 in front, 2 above, 3 behind.
const Vertices kBox{{-1, -0.5}, {1, -0.5}, {1, 0.5}, {-1, 0.5}};
const Vertices kWall{{0, -3}, {0, 3}};
const Vertices kSquare{{-9, -9}, {9, -9}, {9, 9}, {-9, 9}};
const Vertices kL{{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}};

Obstacle moving(const Vec2& position, const Vec2& velocity, double radius, const Vertices& outline,
                double radius_rate = 0) {
  return {{position, velocity, {0, 0}}, radius, radius_rate, outline};
}

Prediction predicted(const Obstacle& obstacle, const Twist& twist = {}) {
  return predict(Polygon(kBox), twist, {obstacle}, 20);
}

void expectFirst(const Prediction& p, double time, std::size_t segment) {
  ASSERT_TRUE(p.first);
  EXPECT_NEAR(p.first->contact.time, time, 1e-9);
  EXPECT_EQ(p.first->segment, segment);
}

/// Those that are touched at `time`; all others are touched later or not at all.
void expectTouched(const Prediction& p, double time, const std::vector<std::size_t>& segments) {
  std::vector<std::size_t> touched;
  for (std::size_t i = 0; i < p.segments.size(); ++i) {
    if (!p.segments[i]) continue;
    EXPECT_GE(p.segments[i]->contact.time, time - 1e-9) << i;
    if (p.segments[i]->contact.time <= time + 1e-9) touched.push_back(i);
  }
  EXPECT_EQ(touched, segments);
}

TEST(Outline, AWallAheadMeetsTheWholeFront) {
  for (const double radius : {0.0, 0.5}) {
    const Prediction p = predicted(moving({5, 0}, {-2, 0}, radius, kWall));
    ASSERT_TRUE(p.first);
    EXPECT_NEAR(p.first->contact.time, 2 - radius / 2, 1e-9);
    EXPECT_EQ(p.first->contact.point.x(), 1);
    EXPECT_NEAR(p.first->closing_speed, 2, 1e-9);
    expectTouched(p, 2 - radius / 2, {0, 1, 2});  // with the corners, its neighbours
    ASSERT_TRUE(p.segments[3]);
    EXPECT_NEAR(p.segments[3]->contact.time, 3 - radius / 2, 1e-9);
  }
}

TEST(Outline, ASlantedWallMeetsTheCornerOfBothItsSegments) {
  const Prediction p = predicted(moving({4, 3.5}, {-1, -1}, 0, {{-2, 2}, {2, -2}}));
  expectFirst(p, 3, 1);
  EXPECT_EQ(p.first->contact.point, Vec2(1, 0.5));
  EXPECT_EQ(p.first->contact.feature, Feature::kEnd);
  EXPECT_NEAR(p.first->closing_speed, std::sqrt(2), 1e-9);
  expectTouched(p, 3, {1, 2});
  EXPECT_EQ(p.segments[2]->contact.feature, Feature::kStart);
}

TEST(Outline, AWallsEndMeetsASide) {
  const Prediction p = predicted(moving({0.25, 3}, {0, -1}, 0, {{0, 0}, {0, 2}}));
  expectFirst(p, 2.5, 2);
  EXPECT_NEAR((p.first->contact.point - Vec2(0.25, 0.5)).norm(), 0, 1e-9);
  EXPECT_EQ(p.first->contact.feature, Feature::kInside);
  EXPECT_NEAR(p.first->closing_speed, 1, 1e-9);
  expectFirst(predicted(moving({0.25, 3}, {0, -1}, 0.25, {{0, 2}, {0, 0}})), 2.25, 2);
}

TEST(Outline, AWallThatPassesAsideIsNotMet) {
  EXPECT_FALSE(predicted(moving({5, 3.01}, {-1, 0}, 0, {{0, -2.5}, {0, 2.5}})).first);
  EXPECT_FALSE(predicted(moving({5, 3.51}, {-1, 0}, 0.5, {{0, -2.5}, {0, 2.5}})).first);
  expectFirst(predicted(moving({5, 3}, {-1, 0}, 0, {{0, -2.5}, {0, 2.5}})), 4, 1);  // grazes above
}

TEST(Outline, ALineIsNotClosedAndAPolygonIs) {
  // A wedge open to the right, in which the box fits: closed, its right side comes first.
  const Vertices wedge{{8, -6}, {0, 0}, {8, 6}};
  const Prediction p = predicted(moving({-14, 0}, {1, 0}, 0, wedge));
  expectFirst(p, 5, 0);  // -14 + 8 + 5 = -1
  expectTouched(p, 5, {0, 2, 3});
  const Prediction tip = predicted(moving({9, 0}, {-1, 0}, 1, wedge));
  expectFirst(tip, 7, 1);
  EXPECT_NEAR((tip.first->contact.point - Vec2(1, 0)).norm(), 0, 1e-9);
}

TEST(Outline, APolygonAroundTheFootprintIsAContactNow) {
  const Prediction still = predicted(moving({1, 0}, {0, 0}, 0.5, kSquare));
  expectFirst(still, 0, 0);  // 7 m from all of the back, and so from the corner of 0 and 3
  EXPECT_EQ(still.first->contact.point.x(), -1);
  EXPECT_NEAR(*still.clearance, -7.5, 1e-12);
  expectTouched(still, 0, {});
  const Prediction leaving = predicted(moving({1, 0}, {1, 0}, 0.5, kSquare));
  expectFirst(leaving, 0, 0);
  expectTouched(leaving, 6.5, {0, 2, 3});
  EXPECT_NEAR(leaving.segments[1]->contact.time, 8.5, 1e-9);
}

TEST(Outline, APolygonWithinTheFootprintIsAContactNow) {
  const Vertices small{{-0.125, -0.125}, {0.125, -0.125}, {0.125, 0.125}, {-0.125, 0.125}};
  const Prediction still = predicted(moving({0.75, 0}, {0, 0}, 0.0625, small));
  expectFirst(still, 0, 1);
  EXPECT_EQ(still.first->contact.point.x(), 1);
  EXPECT_NEAR(*still.clearance, -0.1875, 1e-12);  // 0.125 + 0.0625
  expectTouched(still, 0, {});
  const Prediction leaving = predicted(moving({0.75, 0}, {-1, 0}, 0.0625, small));
  expectTouched(leaving, 1.5625, {3});
  const Prediction line = predicted(moving({0, 0}, {0, 0}, 0, {{0.5, 0}, {0.5, 0.25}}));
  expectFirst(line, 0, 2);
  EXPECT_NEAR(*line.clearance, -0.25, 1e-12);
}

TEST(Outline, TheNotchOfAConcavePolygonIsOutside) {
  // The inner corner is at (-1.5, -1); its sides run 2 m up and 2 m to the right.
  const Prediction still = predicted(moving({-2.5, -2}, {0, 0}, 0, kL));
  EXPECT_FALSE(still.first);
  EXPECT_NEAR(*still.clearance, 0.5, 1e-12);
  const Prediction upwards = predicted(moving({-2.5, -2}, {0, 0.25}, 0, kL));
  expectFirst(upwards, 2, 0);
  expectTouched(upwards, 2, {0, 3});
  const Prediction forwards = predicted(moving({-2.5, -2}, {0.25, 0}, 0.125, kL));
  ASSERT_TRUE(forwards.first);
  EXPECT_NEAR(forwards.first->contact.time, 1.5, 1e-9);
  expectTouched(forwards, 1.5, {0, 2, 3});
}

TEST(Outline, TheWindingAndTheStartChangeNothing) {
  const Vertices reversed(kL.rbegin(), kL.rend());
  Vertices rotated(kL.begin() + 2, kL.end());
  rotated.insert(rotated.end(), kL.begin(), kL.begin() + 2);
  for (const Vertices& outline : {kL, reversed, rotated})
    expectFirst(predicted(moving({-2.5, -2}, {0, 0.25}, 0.125, outline)), 1.5, 0);
}

TEST(Outline, GrowsAndAcceleratesAndIsDrivenInto) {
  const Prediction growing = predicted(moving({3, 0}, {0, 0}, 0.125, kWall, 0.25));
  ASSERT_TRUE(growing.first);
  EXPECT_NEAR(growing.first->contact.time, 7.5, 1e-9);
  const Prediction falling = predicted({{{5, 0}, {0, 0}, {-2, 0}}, 0, 0, kWall});
  ASSERT_TRUE(falling.first);
  EXPECT_NEAR(falling.first->contact.time, 2, 1e-9);
  EXPECT_NEAR(falling.first->closing_speed, 4, 1e-9);
  const Prediction driving = predicted(moving({5, 0}, {0, 0}, 0.5, kWall), {{0.5, 0}, 0});
  ASSERT_TRUE(driving.first);
  EXPECT_NEAR(driving.first->contact.time, 7, 1e-9);
}

TEST(Outline, ItsPlaceIsRelativeToTheCentre) {
  const Prediction p = predicted(moving({5, 10}, {-2, 0}, 0, {{1, -13}, {1, -7}}));
  ASSERT_TRUE(p.first);
  EXPECT_NEAR(p.first->contact.time, 2.5, 1e-9);
}

TEST(Outline, OfNoLengthIsAPoint) {
  expectFirst(predicted(moving({5, 0.25}, {-1, 0}, 0.25, {{0, 0}, {0, 0}})), 3.75, 1);
}

TEST(OutlineClearance, IsSigned) {
  const auto clearance = [](const Obstacle& o) { return predicted(o).clearance.value_or(99); };
  EXPECT_NEAR(clearance(moving({3, 0}, {0, 0}, 0.5, kWall)), 1.5, 1e-12);
  EXPECT_NEAR(clearance(moving({1.25, 0}, {0, 0}, 0.5, kWall)), -0.25, 1e-12);
  EXPECT_NEAR(clearance(moving({0, 0}, {0, 0}, 0.5, kWall)), -0.5, 1e-12);  // across the body
  EXPECT_NEAR(clearance(moving({4, 4.5}, {0, 0}, 0.5, {{0, 0}, {5, 0}})), 4.5, 1e-12);  // 3-4-5
  EXPECT_NEAR(clearance(moving({0, 9}, {0, 0}, 0, kSquare)), 0, 1e-12);  // its side is at y = 0
}

}  // namespace
}  // namespace footprint_collision_predictor::core
