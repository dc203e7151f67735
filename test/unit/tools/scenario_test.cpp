// The scenarios' answers against what their derivations say, and against small steps of time: robot
// and obstacles are moved in the fixed frame, which knows nothing of the formulas.
#include "scenario.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace footprint_collision_predictor::tools {
namespace {

Scenario made(const std::string& name, const ScenarioOptions& options = {}) {
  return findScenario(name)->make(options);
}

/// [s] since the start, as a message at t says; -1: none.
double contactOf(const std::string& name, std::size_t segment, double t, std::size_t body = 0,
                 const ScenarioOptions& options = {}) {
  const Scenario s = made(name, options);
  const auto contact = firstContact(s, s.circles(t), segmentsOf(s.bodies.at(body)).at(segment));
  return contact ? t + contact->time : -1;
}

TEST(ScenarioTest, AsDerived) {
  EXPECT_NEAR(contactOf("crossing", 3, 4), 7.56, 1e-12);
  EXPECT_NEAR(contactOf("crossing", 2, 4), 7.58, 1e-12);
  EXPECT_EQ(contactOf("crossing", 0, 4), -1);
  EXPECT_EQ(contactOf("crossing", 1, 4), -1);
  EXPECT_NEAR(contactOf("head_on", 3, 4), 7.46, 1e-12);
  EXPECT_NEAR(contactOf("head_on", 0, 4), 7.5001923788646684, 1e-12);
  EXPECT_NEAR(contactOf("head_on", 2, 4), 7.5941687604822300, 1e-12);
  EXPECT_NEAR(contactOf("head_on", 1, 4), 8.06, 1e-12);
  EXPECT_NEAR(contactOf("overtaking", 1, 4), 6.43, 1e-12);
  EXPECT_NEAR(contactOf("graze", 2, 4), 6 - std::sqrt(0.09 - 0.299 * 0.299), 1e-9);
  EXPECT_NEAR(contactOf("cut_in", 3, 3), 5, 1e-12);
  EXPECT_EQ(contactOf("cut_in", 3, 2.9), -1);
  EXPECT_NEAR(contactOf("brake", 3, 3), 5, 1e-12);
  EXPECT_NEAR(contactOf("brake", 3, 4.2), 5, 1e-12);
  EXPECT_EQ(contactOf("brake", 3, 2.9), -1);
  EXPECT_NEAR(contactOf("trailer", 0, 4, 1), 6.36, 1e-12);
  EXPECT_EQ(contactOf("trailer", 1, 4, 0), -1);
  for (std::size_t k = 0; k < 4; ++k) EXPECT_EQ(contactOf("near_miss", k, 4), -1);
}

TEST(ScenarioTest, TurningAsDerived) {
  EXPECT_NEAR(contactOf("turn_in_place", 0, 2), 5.57, 1e-12);
  EXPECT_NEAR(contactOf("turn_in_place", 3, 2), 5.57, 1e-12);
  EXPECT_NEAR(contactOf("arc_past_pillar", 2, 2), 5.57, 1e-12);
  EXPECT_NEAR(contactOf("arc_past_pillar", 3, 2), 5.57, 1e-12);
}

TEST(ScenarioTest, ChoicesMoveTheContactAlong) {
  ScenarioOptions options;
  options.radius = 0.5;
  options.speed = 1.2;
  for (const char* name : {"crossing", "stale_tracker", "looped_clock"})
    EXPECT_NEAR(contactOf(name, 3, 5, 0, options), 7.56, 1e-12);
  EXPECT_NEAR(contactOf("overtaking", 1, 4, 0, options), 6.43, 1e-12);
  EXPECT_NEAR(contactOf("cut_in", 3, 3, 0, options), 5, 1e-12);
  EXPECT_NEAR(contactOf("arc_past_pillar", 2, 2, 0, options), 5.57, 1e-12);
  EXPECT_NEAR(contactOf("turn_in_place", 0, 2, 0, options), 5.57, 1e-12);
}

Point turned(const Point& p, double heading) {
  return {std::cos(heading) * p.x - std::sin(heading) * p.y,
          std::sin(heading) * p.x + std::cos(heading) * p.y};
}

/// Smallest gap [m] between circles and segment `dt` after the message at t: the robot follows its
/// pose, the circles their motion in the fixed frame.
double gap(const Scenario& s, const std::vector<Circle>& circles, const Line& segment, double t,
           double dt) {
  const Pose then = robotPose(s, t);
  const Pose now = robotPose(s, t + dt);
  double least = 1e9;
  for (const Circle& c : circles) {
    const Point way = {c.position.x + c.velocity.x * dt + c.acceleration.x * dt * dt / 2,
                       c.position.y + c.velocity.y * dt + c.acceleration.y * dt * dt / 2};
    const Point offset = turned(way, then.heading);
    const Point seen = turned(
        {then.position.x + offset.x - now.position.x, then.position.y + offset.y - now.position.y},
        -now.heading);
    least = std::min(least, distance(seen, segment) - c.radius);
  }
  return least;
}

double sampledContact(const Scenario& s, const std::vector<Circle>& circles, const Line& segment,
                      double t) {
  constexpr double kStep = 1e-3;  // [s]
  for (double dt = 0; dt <= kHorizon; dt += kStep)
    if (gap(s, circles, segment, t, dt) <= 1e-12) return dt;
  return -1;
}

TEST(ScenarioTest, SmallStepsOfTimeAgreeForEverySegment) {
  for (const ScenarioKind& kind : scenarioKinds()) {
    const Scenario s = kind.make({});
    for (double t = 0.0137; t < 9; t += 0.71) {
      const auto circles = s.circles(t);
      for (const Body& body : s.bodies) {
        for (const Line& segment : segmentsOf(body)) {
          const auto contact = firstContact(s, circles, segment);
          const double exact = contact ? contact->time : -1;
          EXPECT_NEAR(sampledContact(s, circles, segment, t), exact, 1.01e-3)
              << kind.name << " t " << t << " segment (" << segment.start.x << ", "
              << segment.start.y << ") to (" << segment.end.x << ", " << segment.end.y << ")";
        }
      }
    }
  }
}

TEST(ScenarioTest, WhatIsSeenIsOneMotion) {
  // Positions of successive moments differ by the velocity that is told: the robot's frame and what
  // is told of it fit each other.
  constexpr double kStep = 1e-4;
  const auto fixed = [](const Scenario& s, double t) {
    const Pose robot = robotPose(s, t);
    const Point offset = turned(s.circles(t).back().position, robot.heading);
    return Point{robot.position.x + offset.x, robot.position.y + offset.y};
  };
  for (const ScenarioKind& kind : scenarioKinds()) {
    if (kind.name == "none") continue;
    const Scenario s = kind.make({});
    for (const double t : {0.5, 2.5, 3.5, 5.9}) {
      const Point before = fixed(s, t - kStep);
      const Point after = fixed(s, t + kStep);
      const Point velocity = turned(s.circles(t).back().velocity, robotPose(s, t).heading);
      EXPECT_NEAR((after.x - before.x) / (2 * kStep), velocity.x, 1e-6) << kind.name << " at " << t;
      EXPECT_NEAR((after.y - before.y) / (2 * kStep), velocity.y, 1e-6) << kind.name << " at " << t;
    }
  }
}

TEST(ScenarioTest, SeedDecides) {
  ScenarioOptions options;
  options.noise = 0.1;
  const Scenario s = made("crowd", options);
  const auto once = measured(s, options, 1);
  const auto again = measured(s, options, 1);
  EXPECT_EQ(once[3].position.x, again[3].position.x);
  EXPECT_NE(once[3].position.x, s.circles(1)[3].position.x);
  options.seed = 2;
  EXPECT_NE(once[3].velocity.x, made("crowd", options).circles(1)[3].velocity.x);
  EXPECT_NE(once[3].position.x - s.circles(1)[3].position.x,
            measured(s, options, 1)[3].position.x - s.circles(1)[3].position.x);
}

TEST(ScenarioTest, NoiseHasTheDeviationThatWasAskedFor) {
  ScenarioOptions options;
  options.noise = 0.1;
  const Scenario s = made("crossing", options);
  double sum = 0;
  constexpr int kMoments = 20000;
  for (int i = 0; i < kMoments; ++i) {
    const double error =
        measured(s, options, i * 0.01)[1].position.x - s.circles(i * 0.01)[1].position.x;
    sum += error * error;
  }
  EXPECT_NEAR(std::sqrt(sum / kMoments), 0.1, 0.002);
}

}  // namespace
}  // namespace footprint_collision_predictor::tools
