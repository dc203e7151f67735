// How far off things are now, and how fast they close at contact.
#include <gtest/gtest.h>

#include "footprint_collision_predictor/predictor.hpp"

namespace footprint_collision_predictor::core {
namespace {

const std::vector<Vec2> kBox{{-1, -0.5}, {1, -0.5}, {1, 0.5}, {-1, 0.5}};

Prediction predicted(const std::vector<Obstacle>& obstacles, const Twist& twist = {}) {
  return predict(Polygon(kBox), twist, obstacles, 10);
}

Obstacle still(double x, double y, double radius) { return {{{x, y}, {0, 0}, {0, 0}}, radius}; }

double closingSpeed(const Motion& motion, double radius, const Twist& twist = {}) {
  const Prediction p = predicted({{motion, radius}}, twist);
  return p.first ? p.first->closing_speed : -1;
}

TEST(Clearance, IsThePositiveGapOutside) {
  EXPECT_NEAR(*predicted({still(3, 0, 0.5)}).clearance, 1.5, 1e-12);    // a side
  EXPECT_NEAR(*predicted({still(4, 4.5, 0.5)}).clearance, 4.5, 1e-12);  // a corner, 3-4-5
}

TEST(Clearance, IsZeroWhenTouchingAndNegativeInAnOverlap) {
  EXPECT_NEAR(*predicted({still(1.5, 0, 0.5)}).clearance, 0, 1e-12);
  EXPECT_NEAR(*predicted({still(1.3, 0, 0.5)}).clearance, -0.2, 1e-12);
}

TEST(Clearance, CountsTheDepthOfACentreInside) {
  EXPECT_NEAR(*predicted({still(0.8, 0, 0.05)}).clearance, -0.25, 1e-12);
  EXPECT_NEAR(*predicted({still(0, 0, 2)}).clearance, -2.5, 1e-12);
  EXPECT_NEAR(*predicted({still(0, 0, 0)}).clearance, -0.5, 1e-12);
}

TEST(Clearance, IsTheSmallestOfAllObstacles) {
  EXPECT_NEAR(*predicted({still(9, 0, 0.5), still(0, 2, 0.5), still(-9, 0, 0.5)}).clearance, 1,
              1e-12);
  EXPECT_NEAR(*predicted({still(0.8, 0, 0.05), still(9, 0, 0.5)}).clearance, -0.25, 1e-12);
}

TEST(Clearance, DoesNotDependOnTheWinding) {
  const std::vector<Vec2> clockwise(kBox.rbegin(), kBox.rend());
  const Prediction p = predict(Polygon(clockwise), {}, {still(0.8, 0, 0.05)}, 10);
  EXPECT_NEAR(*p.clearance, -0.25, 1e-12);
}

TEST(Clearance, IsOfNowAndNotOfLater) {
  EXPECT_NEAR(*predicted({{{{5, 0}, {-1, 0}, {0, 0}}, 0.5}}).clearance, 3.5, 1e-12);
}

TEST(ClosingSpeed, IsAlongTheNormalAtContact) {
  EXPECT_NEAR(closingSpeed({{5, 0}, {-1, 0}, {0, 0}}, 0.5), 1, 1e-9);
  EXPECT_NEAR(closingSpeed({{3, -1.5}, {-2, 2}, {0, 0}}, 0.5), 2, 1e-9);       // at (1.5, 0)
  EXPECT_NEAR(closingSpeed({{-5, -0.25}, {2, 0.125}, {0, 0}}, 0.5), 2, 1e-9);  // the back
}

TEST(ClosingSpeed, OfACornerIsTowardsTheCorner) {
  EXPECT_NEAR(closingSpeed({{7, 8.5}, {-3, -4}, {0, 0}}, 5), 5, 1e-9);
  // At t = 1 the centre is (3, 4) from the corner: (-5, 0) along (-0.6, -0.8) is 3.
  EXPECT_NEAR(closingSpeed({{9, 4.5}, {-5, 0}, {0, 0}}, 5), 3, 1e-9);
}

TEST(ClosingSpeed, IsRelativeToTheFootprint) {
  EXPECT_NEAR(closingSpeed({{5, 0}, {-1, 0}, {0, 0}}, 0.5, {{0.5, 0}, 0}), 1.5, 1e-9);
  EXPECT_NEAR(closingSpeed({{5, 0}, {0, 0}, {0, 0}}, 0.5, {{2, 0}, 0}), 2, 1e-9);
}

TEST(ClosingSpeed, IncludesTheAccelerationUntilContact) {
  EXPECT_NEAR(closingSpeed({{5, 0}, {0, 0}, {-7, 0}}, 0.5), 7, 1e-9);  // 3.5 m in 1 s
  EXPECT_NEAR(closingSpeed({{5, 0}, {-4, 0}, {1, 0}}, 0.5), 3, 1e-9);  // 4 t - t^2 / 2 = 3.5
}

TEST(ClosingSpeed, IsZeroWhenSeparatingOrAtRest) {
  EXPECT_EQ(closingSpeed({{1.25, 0}, {3, 0}, {0, 0}}, 0.5), 0);
  EXPECT_EQ(closingSpeed({{1.25, 0}, {0, 3}, {0, 0}}, 0.5), 0);
  EXPECT_EQ(closingSpeed({{1.25, 0}, {0, 0}, {0, 0}}, 0.5), 0);
}

}  // namespace
}  // namespace footprint_collision_predictor::core
