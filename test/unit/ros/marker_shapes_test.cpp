// Lines, dashes and poses of the pictures for RViz.
#include "marker_shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

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

/// [m] from the nearest edge.
double gap(const core::Vec2& p, const Path& outline) {
  double nearest = 1e9;
  for (std::size_t i = 0; i < outline.size(); ++i)
    nearest = std::min(nearest, core::distance({outline[i], outline[(i + 1) % outline.size()]}, p));
  return nearest;
}

double areaOf(const Points& triangles) {
  double area = 0;
  for (std::size_t i = 0; i + 2 < triangles.size(); i += 3)
    area += 0.5 * std::abs(core::cross(xy(triangles[i + 1]) - xy(triangles[i]),
                                       xy(triangles[i + 2]) - xy(triangles[i])));
  return area;
}

const Path kLine = {{-1, 0}, {1, 0}};
const Path kSquare = {{1, 1}, {-1, 1}, {-1, -1}, {1, -1}};
const Path kCorner = {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};  // like an L

Path reversed(Path path) {
  std::reverse(path.begin(), path.end());
  return path;
}

TEST(MarkerShapes, PathsAreRoundedAtADistance) {
  for (const Path& outline : {kLine, kSquare, kCorner, reversed(kLine), reversed(kSquare),
                              reversed(kCorner), Path{{0, 0}, {0, 0}, {3, 0}, {3, 1}}}) {
    const Path path = rounded(outline, 0.3);
    EXPECT_GT(path.size(), outline.size());
    double left = 0, right = 0;
    for (const core::Vec2& p : path) {
      EXPECT_NEAR(gap(p, outline), 0.3, 1e-9) << p.transpose();
      left = std::min(left, p.x());
      right = std::max(right, p.x());
    }
    double ends[2] = {0, 0};
    for (const core::Vec2& p : outline) {
      ends[0] = std::min(ends[0], p.x());
      ends[1] = std::max(ends[1], p.x());
    }
    EXPECT_NEAR(left, ends[0] - 0.3, 0.01) << "all round, not inside";
    EXPECT_NEAR(right, ends[1] + 0.3, 0.01);
  }
}

TEST(MarkerShapes, PathsAtNoDistanceAreThemselves) {
  EXPECT_EQ(rounded(kLine, 0), kLine);
  EXPECT_EQ(rounded(reversed(kCorner), 0), kCorner);
}

TEST(MarkerShapes, OutlinesMoveAndTheirRadiusGrows) {
  const core::Obstacle obstacle({{0, 0}, {1, 2}, {0, 0}}, 0.1, 0.2, kLine);
  for (const core::Vec2& p : outlineAt(obstacle, 1, 0))
    EXPECT_NEAR(gap(p, {{0, 2}, {2, 2}}), 0.3, 1e-9);
  const core::Obstacle circle({{0, 0}, {1, 2}, {0, 0}}, 0.1, 0.2);
  for (const core::Vec2& p : outlineAt(circle, 1, 0))
    EXPECT_NEAR((p - core::Vec2(1, 2)).norm(), 0.3, 1e-9);
  const Path twice = {{1, 0}, {1, 0}};
  for (const core::Vec2& p : outlineAt(core::Obstacle(circle.motion(), 0.1, 0.2, twice), 1, 0))
    EXPECT_NEAR((p - core::Vec2(2, 2)).norm(), 0.3, 1e-9) << "a line without length";
}

TEST(MarkerShapes, ANarrowDentIsDrawnNearby) {
  const Path dented = {{0, 0}, {4, 0}, {2.0001, 0}, {4, 1e-5}, {4, 2}, {0, 2}};
  for (const core::Vec2& p : rounded(dented, 0.3)) EXPECT_LT(gap(p, dented), 7);
}

TEST(MarkerShapes, FillsCoverTheArea) {
  const std::pair<Path, double> cases[] = {
      {kSquare, 4}, {kCorner, 3}, {{{0, 0}, {1, 0}, {2, 0}, {2, 2}, {0, 2}}, 4}, {kLine, 0}};
  for (const auto& [path, area] : cases)
    for (const Path& winding : {path, reversed(path)}) {
      Points triangles;
      addFilled(winding, 0, triangles);
      EXPECT_NEAR(areaOf(triangles), area, 1e-9);
    }
}

TEST(MarkerShapes, FillingEndsWhateverThePath) {
  Points triangles;
  addFilled({{0, 0}, {2, 2}, {2, 0}, {0, 2}}, 0, triangles);
  addFilled({{0, 0}, {1, 0}, {2, 0}, {1, 0}}, 0, triangles);
  EXPECT_LT(triangles.size(), 7u);
  Points none;
  addFilled(Path(5000, {1, 1}), 0, none);
  EXPECT_TRUE(none.empty());
}

}  // namespace
}  // namespace footprint_collision_predictor
