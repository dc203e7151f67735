// Lines, dashes and poses of the pictures for RViz.
#include "marker_shapes.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace footprint_collision_predictor {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr Style kDashed = {0, 0, 0, 0.1, 0.3, 0.2};
constexpr Style kSolid = {0, 0, 0, 0.1, 0, 0};

core::Vec2 xy(const geometry_msgs::Point& p) { return {p.x, p.y}; }

double lengthOf(const Points& lines) {
  double length = 0;
  for (std::size_t i = 0; i + 1 < lines.size(); i += 2)
    length += (xy(lines[i + 1]) - xy(lines[i])).norm();
  return length;
}

TEST(MarkerShapes, AStraightPose) {
  const PlanarPose pose = poseAfter({{2, -1}, 0}, 1.5);
  EXPECT_EQ(pose.position, core::Vec2(3, -1.5));
  EXPECT_EQ(pose.x_axis, core::Vec2(1, 0));
}

TEST(MarkerShapes, APoseOnAnArc) {
  // A quarter of a circle of 1 m to the left, round (0, 1).
  const PlanarPose pose = poseAfter({{1, 0}, 1}, kPi / 2);
  EXPECT_LT((pose.position - core::Vec2(1, 1)).norm(), 1e-12);
  EXPECT_LT((pose.x_axis - core::Vec2(0, 1)).norm(), 1e-12);
  // Sideways and to the right: from (0, 0) round (1, 0).
  const PlanarPose aside = poseAfter({{0, 1}, -1}, kPi);
  EXPECT_LT((aside.position - core::Vec2(2, 0)).norm(), 1e-12);
  EXPECT_LT((aside.x_axis - core::Vec2(-1, 0)).norm(), 1e-12);
}

TEST(MarkerShapes, AnArcThatIsHardlyOneIsStraight) {
  for (const double yaw_rate : {1e-7, 1e-9, 1e-12})
    EXPECT_LT((poseAfter({{1, 0}, yaw_rate}, 1).position - core::Vec2(1, yaw_rate / 2)).norm(),
              1e-12);
}

TEST(MarkerShapes, DashesGoOnRoundCorners) {
  Points lines;
  addClosed({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, kDashed, 1, 0, lines);
  EXPECT_NEAR(lengthOf(lines), 8 * 0.3, 1e-9);  // 4 m hold 8 times a dash and a gap
  // The third dash is from 1.0 to 1.3 m: it begins where the second edge does.
  EXPECT_LT((xy(lines[4]) - core::Vec2(1, 0)).norm(), 1e-9);
}

TEST(MarkerShapes, ADashThatCrossesACornerIsBent) {
  Points lines;
  addClosed({{0, 0}, {0.6, 0}, {0.6, 0.6}}, kDashed, 1, 0, lines);
  ASSERT_GE(lines.size(), 6u);
  EXPECT_LT((xy(lines[3]) - core::Vec2(0.6, 0)).norm(), 1e-9);    // 0.5 to 0.6 m,
  EXPECT_LT((xy(lines[5]) - core::Vec2(0.6, 0.2)).norm(), 1e-9);  // and on to 0.8 m
}

TEST(MarkerShapes, DashesGrowWithTheUnit) {
  Points lines;
  addLine({0, 0}, {10, 0}, kDashed, 2, 0.5, lines);
  ASSERT_EQ(lines.size(), 20u);
  EXPECT_NEAR(lines[1].x, 0.6, 1e-9);
  EXPECT_EQ(lines[1].z, 0.5);
}

TEST(MarkerShapes, LongPathsHaveFewDashes) {
  Points lines;
  addLine({-1e8, 0}, {1e8, 0}, kDashed, 0.01, 0, lines);
  EXPECT_LE(lines.size(), 402u);
  EXPECT_NEAR(lengthOf(lines), 0.6 * 2e8, 1e6);
}

TEST(MarkerShapes, SolidLinesMeetAtTheOutsideOfTheirCorners) {
  Points lines;
  addClosed({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, kSolid, 1, 0, lines);
  ASSERT_EQ(lines.size(), 8u);
  EXPECT_LT((xy(lines[0]) - core::Vec2(-0.05, 0)).norm(), 1e-9);
  EXPECT_LT((xy(lines[1]) - core::Vec2(1.05, 0)).norm(), 1e-9);
  Points spike;  // a sharp corner is not drawn out beyond half the width
  addClosed({{0, 0}, {10, 0}, {0, 0.1}}, kSolid, 1, 0, spike);
  EXPECT_LT((xy(spike[1]) - core::Vec2(10.05, 0)).norm(), 1e-9);
}

TEST(MarkerShapes, ALineWithoutLengthIsNothing) {
  Points lines;
  addLine({1, 1}, {1, 1}, kSolid, 1, 0, lines);
  addLine({1, 1}, {1, 1}, kDashed, 1, 0, lines);
  addArrow({1, 1}, {1, 1}, 1, 0, lines);
  EXPECT_TRUE(lines.empty());
}

TEST(MarkerShapes, ACircle) {
  const core::Obstacle obstacle({{1, 2}, {1, 0}, {2, 0}}, 0.5);
  for (const core::Vec2& p : outlineAt(obstacle, 2, 0.1))
    EXPECT_NEAR((p - core::Vec2(7, 2)).norm(), 0.5, 1e-9);
  for (const core::Vec2& p : outlineAt(core::Obstacle({{1, 2}, {0, 0}, {0, 0}}, 0), 0, 0.1))
    EXPECT_NEAR((p - core::Vec2(1, 2)).norm(), 0.1, 1e-9) << "a point must be seen";
}

}  // namespace
}  // namespace footprint_collision_predictor
