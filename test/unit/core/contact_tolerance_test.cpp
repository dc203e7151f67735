// The tolerance is a promise to users: some 1e-14 of the coordinates, no more and no less.
#include <gtest/gtest.h>

#include <limits>

#include "footprint_collision_predictor/time_to_collision.hpp"

namespace footprint_collision_predictor::core {
namespace {

constexpr double kUnit = 32 * std::numeric_limits<double>::epsilon();
const Segment kLine{{0, 0}, {3, 0}};
const Motion kMotion{{4, -2}, {1, -1}, {2, 0}};

TEST(ContactTolerance, CountsTheCoordinatesRelativeToTheFartherEnd) {
  EXPECT_EQ(contactTolerance(kLine, {kMotion, 0.5}, 0), 6.5 * kUnit);
  EXPECT_EQ(contactTolerance({kLine.end, kLine.start}, {kMotion, 0.5}, 0), 6.5 * kUnit);
}

TEST(ContactTolerance, GrowsWithTheWay) {
  EXPECT_EQ(contactTolerance(kLine, {kMotion, 0.5}, 2), 14.5 * kUnit);  // 6.5 + 2 * 2 + 2 * 4 / 2
}

TEST(ContactTolerance, GrowsWithTheRadius) {
  EXPECT_EQ(contactTolerance(kLine, {kMotion, 0.5, 1.5}, 0), 6.5 * kUnit);
  EXPECT_EQ(contactTolerance(kLine, {kMotion, 0.5, 1.5}, 2), 17.5 * kUnit);
}

TEST(ContactTolerance, DoesNotDependOnTheOrigin) {
  const Vec2 far{0x1p20, -0x1p21};
  const Segment line{kLine.start + far, kLine.end + far};
  const Motion motion{kMotion.position + far, kMotion.velocity, kMotion.acceleration};
  EXPECT_EQ(contactTolerance(line, {motion, 0.5}, 2), 14.5 * kUnit);
}

TEST(ContactTolerance, OfACircleAtRestOnAPointIsThatOfItsRadius) {
  const Vec2 p{7, 7};
  EXPECT_EQ(contactTolerance({p, p}, {{p, {0, 0}, {0, 0}}, 0.25}, 9), 0.25 * kUnit);
}

}  // namespace
}  // namespace footprint_collision_predictor::core
