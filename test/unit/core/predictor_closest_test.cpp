// The closest approach, by hand.
#include <gtest/gtest.h>

#include <cmath>

#include "footprint_collision_predictor/predictor.hpp"

namespace footprint_collision_predictor::core {
namespace {

const std::vector<Vec2> kBox{{-1, -0.5}, {1, -0.5}, {1, 0.5}, {-1, 0.5}};

void expectClosest(const std::vector<Obstacle>& obstacles, double distance, double time,
                   double horizon = 10) {
  const Prediction p = predict(Polygon(kBox), {}, obstacles, horizon);
  ASSERT_TRUE(p.closest);
  EXPECT_NEAR(p.closest->distance, distance, 1e-6);
  EXPECT_NEAR(p.closest->time, time, 2e-3);  // flat: 1e-6 m are there for so long
}

TEST(Closest, IsBesideTheFootprintInPassing) {
  // Past the corner (1, 0.5) along (-1, -1): nearest where it is square to that, 2 m away.
  const double h = std::sqrt(2);
  const Vec2 nearest{1 + h, 0.5 + h};
  expectClosest({{{nearest - 3 * Vec2{1, -1}, {1, -1}, {0, 0}}, 0.5}}, 1.5, 3);
}

TEST(Closest, IsAtOnceWhenItLeaves) { expectClosest({{{{3, 0}, {1, 0.25}, {0, 0}}, 0.5}}, 1.5, 0); }

TEST(Closest, IsAtTheHorizonWhenItComes) {
  expectClosest({{{{9, 0}, {-1, 0}, {0, 0}}, 0.5}}, 3.5, 4, 4);
}

TEST(Closest, IsAtTheTurnOfWhatBrakesAndGoesBack) {
  expectClosest({{{{6, 0}, {-4, 0}, {2, 0}}, 0.5}}, 0.5, 2);  // 6 - 4 t + t^2, at 2 s 2
}

TEST(Closest, CountsTheGrowth) {
  // Leaves with 0.5 m/s and grows by as much as it leaves, then it is faster: 0.25 t^2.
  expectClosest({{{{3, 0}, {0.5, 0}, {0.5, 0}}, 0.25, 1}}, 1.5, 1);  // 1.75 - 0.5 t + 0.25 t^2
}

TEST(Closest, OfALineIsThatOfItsNearestPoint) {
  expectClosest({{{{3, 3}, {-1, 1}, {0, 0}}, 0.5, 0, {{-1, 0}, {1, 0}}}}, std::hypot(1, 2.5) - 0.5,
                0);
  // Its end comes down to 1 m, beside the corner, until it goes up again.
  expectClosest({{{{1.75, 5}, {0, -4}, {0, 2}}, 0, 0, {{0, 0}, {0, 9}}}}, std::hypot(0.75, 0.5), 2);
}

TEST(Closest, OfATurnIsThatOfTheCirclesItsVerticesGoRound) {
  // About (-1/16, 2), where it stands still; (1, 10) is farthest from there, and comes round often.
  const Twist twist{{32, 1}, 16};
  const double radius = std::hypot(1.0625, 8);
  for (const double away : {1e2, 1e4, 1e8}) {
    const std::vector<Obstacle> obstacles{{{{away, 0}, {0, 0}, {0, 0}}, 0.5}};
    const Prediction p = predict(Polygon({{0, 0}, {0, 1}, {1, 10}}), twist, obstacles, 8);
    ASSERT_TRUE(p.closest);
    EXPECT_NEAR(p.closest->distance, std::hypot(away + 0.0625, 2) - radius - 0.5,
                1e-6 + 1e-13 * away);
  }
}

TEST(Closest, IsNothingInAContactAndItsTime) {
  for (const double y : {0.0, 0.75}) {  // the front, a graze of the side
    const Prediction p = predict(Polygon(kBox), {}, {{{{5, y}, {-1, 0}, {0, 0}}, 0.25}}, 10);
    ASSERT_TRUE(p.first && p.closest);
    EXPECT_EQ(p.closest->distance, 0);
    EXPECT_EQ(p.closest->time, p.first->contact.time);
  }
  const Prediction within = predict(Polygon(kBox), {}, {{{{0.5, 0}, {1, 0}, {0, 0}}, 0.1}}, 10);
  EXPECT_EQ(within.closest->distance, 0);
  EXPECT_EQ(within.closest->time, 0);
}

TEST(Closest, IsTheSmallestOfAllObstacles) {
  const Obstacle one{{{9, 0}, {-1, 0}, {0, 0}}, 0.5};
  const Obstacle other{{{-4, 0}, {0, 1}, {0, 0}}, 0.5};
  expectClosest({one, other}, 2.5, 0, 4);
  expectClosest({other, one}, 2.5, 0, 4);
  expectClosest({other, one, other}, 1.5, 6, 6);
}

TEST(Closest, IsNothingWithoutObstacles) {
  EXPECT_FALSE(predict(Polygon(kBox), {}, {}, 10).closest);
}

TEST(Closest, WithinNoTimeIsTheGapNow) {
  expectClosest({{{{5, 0}, {-9, 0}, {0, 0}}, 0.5}}, 3.5, 0, 0);
}

}  // namespace
}  // namespace footprint_collision_predictor::core
