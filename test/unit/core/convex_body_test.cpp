// How a point lies to a convex footprint, by hand.
#include "convex_body.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace footprint_collision_predictor::core {
namespace {

Away away(const std::vector<Vec2>& vertices, const Vec2& p) {
  const Polygon footprint(vertices);
  return ConvexBody(footprint.sides()).awayFrom(p - footprint.centroid());
}

// Segments: 0 below, 1 in front, 2 above, 3 behind; one vertex more in the middle of the front.
const std::vector<Vec2> kBox{{-1, -0.5}, {1, -0.5}, {1, 0.5}, {-1, 0.5}};
const std::vector<Vec2> kSplit{{-1, -0.5}, {1, -0.5}, {1, 0}, {1, 0.5}, {-1, 0.5}};

void expectAway(const Away& a, const Vec2& vector, double beyond, std::size_t segment) {
  EXPECT_NEAR((a.vector - vector).norm(), 0, 1e-15);
  EXPECT_NEAR(a.beyond, beyond, 1e-15);
  EXPECT_EQ(a.segment, segment);
}

TEST(ConvexBody, BesideASide) {
  expectAway(away(kBox, {3, 0.25}), {2, 0}, 0, 1);
  expectAway(away(kSplit, {3, -0.25}), {2, 0}, 0, 1);
  expectAway(away(kSplit, {3, 0.25}), {2, 0}, 0, 2);
}

TEST(ConvexBody, BeyondAVertex) {
  // From the upper front corner, farther along one of the sides or along the other.
  for (const Vec2& from : {Vec2(3, 1), Vec2(1, 3)}) {
    const Away a = away(kBox, Vec2(1, 0.5) + from);
    EXPECT_NEAR((a.vector - from).norm(), 0, 1e-15);
    EXPECT_NEAR(a.beyond, 1, 1e-15);
    EXPECT_TRUE(a.segment == 1 || a.segment == 2);
  }
}

TEST(ConvexBody, OfManySides) {
  // More than are gone through at once. Their middles lie at cos(pi / 40).
  std::vector<Vec2> round;
  for (int i = 0; i < 40; ++i) round.emplace_back(std::cos(i * M_PI / 20), std::sin(i * M_PI / 20));
  for (const std::size_t i : {0u, 15u, 16u, 31u, 32u, 39u}) {
    const double angle = (static_cast<double>(i) + 0.5) * M_PI / 20;
    const Vec2 outwards(std::cos(angle), std::sin(angle));
    const Away a = away(round, 2 * outwards);
    EXPECT_NEAR((a.vector - (2 - std::cos(M_PI / 40)) * outwards).norm(), 0, 1e-14);
    EXPECT_EQ(a.beyond, 0);
    EXPECT_EQ(a.segment, i);
  }
}

TEST(ConvexBody, OfASliverWithATinySide) {
  // Its tiny side is far below what rounding leaves of a point's place: all but a line.
  const std::vector<Vec2> sliver{{0, 3e-323}, {-3e-323, -34}, {-std::ldexp(1, -62), 0}};
  const Segment line{{0, 0}, {0, -34}};
  for (int i = 0; i < 720; ++i) {
    const double angle = (i + 0.3) * M_PI / 360;
    const Vec2 p = 65 * Vec2(std::cos(angle), std::sin(angle));
    EXPECT_NEAR((away(sliver, p).vector - (p - closestPoint(line, p))).norm(), 0, 1e-12) << i;
  }
}

TEST(ConvexBody, WithinNamesTheSideThatIsNext) {
  expectAway(away(kBox, {1 - 1e-9, 0}), {0, 0}, 0, 1);
  expectAway(away(kBox, {-1 + 1e-9, 0.2}), {0, 0}, 0, 3);
}

}  // namespace
}  // namespace footprint_collision_predictor::core
