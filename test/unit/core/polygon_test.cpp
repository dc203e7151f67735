// Area, centroid and inside of valid footprints.
#include "footprint_collision_predictor/polygon.hpp"

#include <gtest/gtest.h>

namespace footprint_collision_predictor::core {
namespace {

using Vertices = std::vector<Vec2>;

// The lecture's box, clockwise.
const Vertices kBox{{1, 1}, {1, 2}, {2, 2}, {2, 1}};
// An L: a 3 x 1 foot and a 1 x 2 stem on its left; area 5.
const Vertices kL{{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}};

Vertices reversed(const Vertices& v) { return {v.rbegin(), v.rend()}; }

void expectNear(const Vec2& a, const Vec2& b, double tolerance) {
  EXPECT_NEAR(a.x(), b.x(), tolerance);
  EXPECT_NEAR(a.y(), b.y(), tolerance);
}

TEST(Polygon, TheBoxOfTheLecture) {
  EXPECT_EQ(signedArea(kBox), -1);
  expectNear(centroid(kBox), {1.5, 1.5}, 1e-15);
  const Polygon box(kBox);
  EXPECT_EQ(box.area(), 1);
  EXPECT_FALSE(box.isCounterClockwise());
  expectNear(box.centroid(), {1.5, 1.5}, 1e-15);
}

TEST(Polygon, Fault04TheWindingChangesOnlyTheSign) {
  EXPECT_EQ(signedArea(reversed(kBox)), 1);
  expectNear(centroid(reversed(kBox)), {1.5, 1.5}, 1e-15);
  EXPECT_TRUE(Polygon(reversed(kBox)).isCounterClockwise());
  EXPECT_EQ(Polygon(reversed(kL)).area(), 5);
}

TEST(Polygon, KeepsTheNumberingOfTheUser) {
  for (const Vertices& vertices : {kBox, reversed(kBox)}) {
    const Polygon box(vertices);
    ASSERT_EQ(box.size(), 4u);
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_EQ(box.segment(i).start, vertices[i]);
      EXPECT_EQ(box.segment(i).end, vertices[(i + 1) % 4]);
    }
  }
}

TEST(Polygon, FarFromTheOriginNothingIsLost) {
  const Vec2 corner{1e6, 1e6};
  const Polygon robot(
      {corner, corner + Vec2{1, 0}, corner + Vec2{1, 0.59375}, corner + Vec2{0, 0.59375}});
  EXPECT_EQ(robot.area(), 0.59375);
  expectNear(robot.centroid(), corner + Vec2{0.5, 0.296875}, 1e-9);
  const Polygon rounded({{1e6, 1e6}, {1e6 + 1, 1e6}, {1e6 + 1, 1e6 + 0.6}, {1e6, 1e6 + 0.6}});
  expectNear(rounded.centroid(), {1e6 + 0.5, 1e6 + 0.3}, 1e-9);
}

TEST(Polygon, Fault04ConcaveCentroid) {
  // (3 * (1.5, 0.5) + 2 * (0.5, 2)) / 5 = (1.1, 1.1)
  expectNear(Polygon(kL).centroid(), {1.1, 1.1}, 1e-15);
  expectNear(Polygon(reversed(kL)).centroid(), {1.1, 1.1}, 1e-15);
  EXPECT_EQ(Polygon(kL).area(), 5);
}

TEST(Polygon, Fault04CollinearVerticesAreAccepted) {
  const Polygon p({{0, 0}, {1, 0}, {2, 0}, {2, 2}, {0, 2}, {0, 1}});
  EXPECT_EQ(p.area(), 4);
  EXPECT_EQ(p.size(), 6u);
  expectNear(p.centroid(), {1, 1}, 1e-15);
}

TEST(Polygon, Fault04VeryShortEdgesAreAccepted) {
  EXPECT_NEAR(Polygon({{0, 0}, {2, 0}, {2, 1e-12}, {2, 1}, {1e-9, 1}, {0, 1}}).area(), 2, 1e-9);
  EXPECT_NO_THROW(Polygon({{0, 0}, {1e-6, 0}, {0, 1e-6}}));
}

TEST(Polygon, TheLimitsThemselvesAreAccepted) {
  EXPECT_NO_THROW(Polygon({{0, 0}, {1e4, 0}, {0, 1e4}}));
  EXPECT_NO_THROW(Polygon({{1e8, -1e8}, {1e8 - 1, -1e8}, {1e8, -1e8 + 1}}));
}

TEST(SignedArea, OfFewerThanThreeIsZero) {
  EXPECT_EQ(signedArea({}), 0);
  EXPECT_EQ(signedArea({{1, 2}}), 0);
  EXPECT_EQ(signedArea({{1, 2}, {3, 5}}), 0);
}

TEST(Centroid, WithoutAreaIsRefused) {
  EXPECT_THROW(centroid({{0, 0}, {1, 0}, {2, 0}}), InvalidPolygon);
  EXPECT_THROW(centroid({}), InvalidPolygon);
}

TEST(Contains, TellsInsideFromOutsideInEitherWinding) {
  for (const Vertices& vertices : {kL, reversed(kL)}) {
    const Polygon l(vertices);
    EXPECT_TRUE(l.contains({0.5, 0.5}));
    EXPECT_TRUE(l.contains({0.5, 2.9}));
    EXPECT_TRUE(l.contains({2.9, 0.5}));
    EXPECT_FALSE(l.contains({2, 2}));  // the notch
    EXPECT_FALSE(l.contains({-1, 1}));
    EXPECT_FALSE(l.contains({4, 0.5}));
    EXPECT_FALSE(l.contains({1.5, -1}));
  }
}

TEST(Contains, CountsARayThroughAVertexOnce) {
  const Polygon diamond({{1, 0}, {0, 1}, {-1, 0}, {0, -1}});
  EXPECT_TRUE(diamond.contains({0, 0}));
  EXPECT_FALSE(diamond.contains({-2, 0}));
  EXPECT_FALSE(diamond.contains({2, 0}));
  EXPECT_FALSE(diamond.contains({-1, 1}));
  EXPECT_FALSE(Polygon(kL).contains({-1, 0}));
  EXPECT_FALSE(Polygon(kL).contains({-1, 3}));
}

}  // namespace
}  // namespace footprint_collision_predictor::core
