// The scenarios' expected answers against numbers worked out by hand, and against dense sampling of
// the distance in the fixed frame (which knows nothing of the formulas).
#include "scenario.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace footprint_collision_predictor::tools {
namespace {

const Scenario& named(const std::string& name) { return *findScenario(name); }

Point toBase(const Point& p, const Point& robot) {
  const double x = p.x - robot.x;
  const double y = p.y - robot.y;
  return {0.8 * x + 0.6 * y, -0.6 * x + 0.8 * y};
}

double distanceTo(std::size_t segment, const Point& p) {
  const Point a = kFootprint.at(segment);
  const Point b = kFootprint.at((segment + 1) % kSegments);
  const double x = std::clamp(p.x, std::min(a.x, b.x), std::max(a.x, b.x));
  const double y = std::clamp(p.y, std::min(a.y, b.y), std::max(a.y, b.y));
  return std::hypot(p.x - x, p.y - y);  // axis-parallel segments only
}

/// Smallest gap between any obstacle and the segment at time t [m].
double gap(const Scenario& scenario, std::size_t segment, double t) {
  double least = 1e9;
  for (const auto& o : scenario.obstacles) {
    const Point p = toBase(obstaclePosition(scenario, o, t), robotPosition(scenario, t));
    least = std::min(least, distanceTo(segment, p) - o.radius);
  }
  return least;
}

TEST(ScenarioTest, CrossingByHand) {
  const auto& s = named("crossing");
  EXPECT_NEAR(footprintTouch(s)->begin, 7.56, 1e-12);
  EXPECT_NEAR(s.touches[3]->begin, 7.56, 1e-12);
  EXPECT_NEAR(s.touches[2]->begin, 7.58, 1e-12);
  EXPECT_FALSE(s.touches[0] || s.touches[1]);
}

TEST(ScenarioTest, HeadOnByHand) {
  const auto& s = named("head_on");
  EXPECT_NEAR(footprintTouch(s)->begin, 7.46, 1e-12);
  EXPECT_NEAR(s.touches[0]->begin, 7.5001923788646684, 1e-12);
  EXPECT_NEAR(s.touches[2]->begin, 7.5941687604822300, 1e-12);
  EXPECT_NEAR(s.touches[1]->begin, 8.06, 1e-12);
}

TEST(ScenarioTest, TimesCountDownThenStayAtZeroThenEnd) {
  const Interval touch{6.0, 7.0};
  EXPECT_FALSE(timeToCollision(touch, 0.5));
  EXPECT_EQ(timeToCollision(touch, 1.0), 5.0);  // exactly at the horizon counts
  EXPECT_EQ(timeToCollision(touch, 4.0), 2.0);
  EXPECT_EQ(timeToCollision(touch, 6.5), 0.0);
  EXPECT_EQ(timeToCollision(touch, 7.0), 0.0);
  EXPECT_FALSE(timeToCollision(touch, 7.001));
  EXPECT_FALSE(timeToCollision(std::nullopt, 1.0));
}

TEST(ScenarioTest, PersonInCrossingWalksAcrossTheRobotsWay) {
  // Over ground at right angles to the heading (0.8, 0.6), to the right, at 0.8 m/s.
  const auto& s = named("crossing");
  const Point v = obstacleVelocity(s, s.obstacles[1]);
  EXPECT_NEAR(v.x, 0.48, 1e-12);
  EXPECT_NEAR(v.y, -0.64, 1e-12);
  const Point standing = obstacleVelocity(s, s.obstacles[0]);
  EXPECT_NEAR(std::hypot(standing.x, standing.y), 0.0, 1e-12);
}

TEST(ScenarioTest, NearMissLeavesFiveCentimetres) {
  const auto& s = named("near_miss");
  double least = 1e9;
  for (int i = 0; i <= 12000; ++i) {
    for (std::size_t k = 0; k < kSegments; ++k) least = std::min(least, gap(s, k, i / 1000.0));
  }
  EXPECT_NEAR(least, 0.05, 1e-9);
  EXPECT_NEAR(gap(s, 2, 6.0), 0.05, 1e-12);
}

TEST(ScenarioTest, SamplingTheDistanceAgreesForEverySegment) {
  for (const auto& s : scenarios()) {
    for (std::size_t k = 0; k < kSegments; ++k) {
      for (int i = 0; i <= 12000; ++i) {
        const double t = i / 1000.0 + 0.00037;  // off the boundaries, where rounding would decide
        const auto& touch = s.touches.at(k);
        const bool expected = touch && t >= touch->begin && t <= touch->end;
        ASSERT_EQ(gap(s, k, t) <= 0, expected) << s.name << " segment " << k << " t " << t;
      }
    }
  }
}

TEST(ScenarioTest, SegmentAndIdAreThoseOfTheFirstTouch) {
  for (const auto& s : scenarios()) {
    const auto first = footprintTouch(s);
    ASSERT_EQ(first.has_value(), s.segment.has_value()) << s.name;
    ASSERT_EQ(first.has_value(), s.obstacle_id.has_value()) << s.name;
    if (!first) continue;
    const auto segment = static_cast<std::size_t>(*s.segment);
    EXPECT_EQ(s.touches.at(segment)->begin, first->begin) << s.name;
  }
}

}  // namespace
}  // namespace footprint_collision_predictor::tools
