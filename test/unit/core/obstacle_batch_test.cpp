// Many obstacles at once, where single precision would not do.
#include "footprint_collision_predictor/obstacle_batch.hpp"

#include <gtest/gtest.h>

#include "footprint_collision_predictor/predictor.hpp"

namespace footprint_collision_predictor::core {
namespace {

const Polygon kBox({{-1, -0.5}, {1, -0.5}, {1, 0.5}, {-1, 0.5}});
const Motion kAtRest{{0, 0}, {0, 0}, {0, 0}};

TEST(ObstacleBatch, BoundingCircleHoldsTheObstacle) {
  for (const double radius : {0.0, 0.1, 1.0 / 3.0, 1e6 / 7.0}) {
    ObstacleBatch batch({Obstacle(kAtRest, radius)});
    batch.add(Obstacle(kAtRest, radius, 0, {{-3, 0}, {3, 4}}));  // the farther end is 5 away
    EXPECT_GE(batch.boundingRadius(0), radius);
    EXPECT_LE(batch.boundingRadius(0), 1.001 * radius);
    EXPECT_GE(batch.boundingRadius(1), radius + 5);
    EXPECT_LE(batch.boundingRadius(1), 1.001 * (radius + 5));
  }
}

TEST(ObstacleBatch, FindsWhatIsNearWhereTheFirstIsFarAway) {
  // The float next to 1e8 is 8 m away from it.
  const Obstacle far({{1e8, 1e8}, {0, 0}, {0, 0}}, 1);
  const Obstacle near({{4, 0.2}, {-1, 0}, {0, 0}}, 0.25);  // comes to x = 1.25 after 2.75 s
  const auto first = firstContact(kBox, {}, ObstacleBatch({far, near}), 10);
  ASSERT_TRUE(first);
  EXPECT_EQ(first->obstacle, 1u);
  EXPECT_NEAR(first->contact.time, 2.75, 1e-9);
}

}  // namespace
}  // namespace footprint_collision_predictor::core
