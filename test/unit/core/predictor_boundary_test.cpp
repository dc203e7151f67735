// Obstacles whose centre comes to lie on the boundary itself, and those that touch by rounding.
#include <gtest/gtest.h>

#include "footprint_collision_predictor/predictor.hpp"

namespace footprint_collision_predictor::core {
namespace {

const std::vector<Vec2> kBox{{-1, -0.5}, {1, -0.5}, {1, 0.5}, {-1, 0.5}};

FootprintContact firstContact(const Obstacle& obstacle, bool reversed = false) {
  std::vector<Vec2> vertices = kBox;
  if (reversed) vertices.assign(kBox.rbegin(), kBox.rend());
  const Prediction p = predict(Polygon(vertices), {}, {obstacle}, 10);
  return p.first.value_or(FootprintContact{{-1, Feature::kInside, {0, 0}}, 99, 99, -1});
}

TEST(OnTheBoundary, APointClosesAlongTheSegmentsNormal) {
  const Obstacle point{{{4, -3.75}, {-3, 4}, {0, 0}}, 0};  // at (1, 0.25) after 1 s
  for (const bool reversed : {false, true}) {
    const FootprintContact first = firstContact(point, reversed);
    EXPECT_NEAR(first.contact.time, 1, 1e-9);
    EXPECT_NEAR(first.closing_speed, 3, 1e-9);
  }
}

TEST(OnTheBoundary, APointThatLeavesDoesNotClose) {
  for (const bool reversed : {false, true}) {
    const FootprintContact first = firstContact({{{1, 0.25}, {2, 1}, {0, 0}}, 0}, reversed);
    EXPECT_EQ(first.contact.time, 0);
    EXPECT_EQ(first.closing_speed, 0);
  }
}

TEST(OnTheBoundary, APointThatSlidesAlongDoesNotClose) {
  for (const bool reversed : {false, true})
    for (const double beside : {0.0, 0x1p-50, -0x1p-50}) {  // by no more than rounding
      const FootprintContact first =
          firstContact({{{1 + beside, 0.25}, {0, 3}, {0, 0}}, 0}, reversed);
      EXPECT_EQ(first.contact.time, 0);
      EXPECT_EQ(first.closing_speed, 0);
    }
}

TEST(OnTheBoundary, APointClosesOnAVertexWithAllItsSpeed) {
  const FootprintContact first = firstContact({{{4, 4.5}, {-3, -4}, {0, 0}}, 0});
  EXPECT_NEAR(first.contact.time, 1, 1e-9);
  EXPECT_NEAR(first.closing_speed, 5, 1e-9);
  EXPECT_EQ(first.segment, 1u);  // although rounding lets it meet segment 2 earlier
  EXPECT_TRUE(first.contact.feature == Feature::kEnd);
}

TEST(OnTheBoundary, TouchingTheFirstVertexNowNamesTheFirstSegment) {
  const FootprintContact first = firstContact({{{-1.375, -1}, {3, 4}, {0, 0}}, 0.625});  // 3-4-5
  EXPECT_EQ(first.contact.time, 0);
  EXPECT_EQ(first.segment, 0u);
  EXPECT_EQ(first.contact.point, Vec2(-1, -0.5));
  EXPECT_NEAR(first.closing_speed, 5, 1e-9);
}

TEST(OnTheBoundary, AGapOfRoundingIsContactNow) {
  const Obstacle leaving{{{1.1, 0.25}, {1, 0}, {0, 0}}, 0.1};  // 1.1 - 1 is a little more than 0.1
  const Prediction p = predict(Polygon(kBox), {}, {leaving}, 10);
  ASSERT_TRUE(p.first && p.clearance);
  EXPECT_GT(*p.clearance, 0);
  EXPECT_EQ(p.first->contact.time, 0);
  EXPECT_EQ(p.first->segment, 1u);
  EXPECT_EQ(p.first->closing_speed, 0);

  const Obstacle overlapping{{{-1.25, 0.25}, {1, 0}, {0, 0}}, 0.5};
  const Prediction both = predict(Polygon(kBox), {}, {leaving, overlapping}, 10);
  ASSERT_TRUE(both.first);
  EXPECT_EQ(both.first->obstacle, 1u);  // the deeper one
  EXPECT_EQ(both.first->segment, 3u);
}

TEST(InsideTheBoundary, ClosingIsGoingDeeper) {
  for (const bool reversed : {false, true}) {  // 0.25 behind the front
    EXPECT_NEAR(firstContact({{{0.75, 0}, {-2, 1}, {0, 0}}, 0.1}, reversed).closing_speed, 2, 1e-9);
    EXPECT_EQ(firstContact({{{0.75, 0}, {2, 1}, {0, 0}}, 0.1}, reversed).closing_speed, 0);
  }
}

TEST(InsideTheBoundary, OfEquallyNearSegmentsTheLowerIsNamed) {
  const FootprintContact first = firstContact({{{0, 0}, {1, 0}, {0, 0}}, 0.1});  // 0.5 to 0 and 2
  EXPECT_EQ(first.segment, 0u);
  EXPECT_EQ(first.contact.point, Vec2(0, -0.5));
}

TEST(OnTheBoundary, OfTwoThatOverlapNowTheDeeperIsNamedThoughItsCentreIsFarther) {
  const Obstacle deeper{{{3, 0}, {0, 0}, {0, 0}}, 4};  // 2 - 4
  const Obstacle nearer{{{2, 0}, {0, 0}, {0, 0}}, 2};  // 1 - 2
  const Prediction p = predict(Polygon(kBox), {}, {nearer, deeper}, 10);
  const Prediction q = predict(Polygon(kBox), {}, {deeper, nearer}, 10);
  ASSERT_TRUE(p.segments[1] && q.segments[1]);
  EXPECT_EQ(p.segments[1]->obstacle, 1u);
  EXPECT_EQ(q.segments[1]->obstacle, 0u);
  const Prediction same = predict(Polygon(kBox), {}, {deeper, deeper}, 10);
  ASSERT_TRUE(same.first);
  EXPECT_EQ(same.first->obstacle, 0u);  // of equals, the lower index
}

}  // namespace
}  // namespace footprint_collision_predictor::core
