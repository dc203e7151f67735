// The formulas against numbers worked out by hand.
#include "contact_formulas.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace footprint_collision_predictor::tools {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr Line kSegment = {{0, -1}, {0, 1}};

double straight(Point p, Point v, double radius, Point a = {0, 0}) {
  return straightContact(p, v, a, radius, kSegment).value_or(-1);
}

TEST(ContactFormulasTest, Straight) {
  EXPECT_NEAR(straight({3, 0.5}, {-2, 0}, 1), 1, 1e-15);    // inside, from the right
  EXPECT_NEAR(straight({-3, 0.5}, {2, 0}, 1), 1, 1e-15);    // from the left
  EXPECT_NEAR(straight({0, 5}, {0, -1}, 1), 3, 1e-15);      // end on
  EXPECT_NEAR(straight({4, 1.6}, {-1, 0}, 1), 3.2, 1e-15);  // an end: 0.6^2 + 0.8^2 = 1
  EXPECT_EQ(straight({4, 2.1}, {-1, 0}, 1), -1);            // past it
  EXPECT_EQ(straight({4, 0}, {1, 0}, 1), -1);               // away
  EXPECT_EQ(straight({4, 0}, {0, 0}, 1), -1);               // at rest
  EXPECT_EQ(straight({0.5, 0}, {1, 0}, 1), 0);              // touching now
}

TEST(ContactFormulasTest, Accelerated) {
  EXPECT_NEAR(straight({3, 0}, {0, 0}, 1, {-1, 0}), 2, 1e-15);                  // 2 = t^2 / 2
  EXPECT_NEAR(straight({4, 0}, {-1, 0}, 1, {-1, 0}), std::sqrt(7) - 1, 1e-15);  // 3 = t + t^2 / 2
}

TEST(ContactFormulasTest, Round) {
  const auto round = [](Point p, double radius, Point about = {0, 0}) {
    return roundContact(p, about, 0.5, radius, {{2, -1}, {2, 1}}).value_or(-1);
  };
  // On a circle of 2 round the origin, clockwise from the top; it is 0.5 from the upper end (2, 1)
  // when the angle between them is acos((5 + 4 - 0.25) / (4 sqrt 5)).
  const double corner = std::atan2(1, 2);
  const double between = std::acos(8.75 / (4 * std::sqrt(5)));
  EXPECT_NEAR(round({0, 2}, 0.5), (kPi / 2 - corner - between) / 0.5, 1e-14);
  EXPECT_NEAR(round({0, -2}, 0.5), (3 * kPi / 2 - corner - between) / 0.5, 1e-14);  // all round
  EXPECT_EQ(round({0, 1}, 0.5), -1);  // on a circle that stays 1 away
  EXPECT_EQ(round({2.2, 0}, 0.5), 0);
  EXPECT_NEAR(round({10, 12}, 0.5, {10, 10}), -1, 1e-14);
  // On a circle of 0.8 the inside is touched: 0.8 cos = 0.5, and 0.8 sin < 1.
  const auto inside = roundContact({0, 0.8}, {0, 0}, 1, 1.5, {{2, -1}, {2, 1}});
  EXPECT_NEAR(inside.value_or(-1), kPi / 2 - std::acos(0.5 / 0.8), 1e-14);
}

}  // namespace
}  // namespace footprint_collision_predictor::tools
