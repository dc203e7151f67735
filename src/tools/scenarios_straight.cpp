// Scenarios of a robot that drives straight on, and their derivations.
// All coordinates are in the robot's base frame at the moment; T is the moment of contact in
// seconds since the start, r the radius, v the robot's speed.
#include <algorithm>
#include <cmath>

#include "random_numbers.hpp"
#include "scenario_parts.hpp"

namespace footprint_collision_predictor::tools {
namespace {

// Seen from the robot it moves by (-0.6, -0.8) m/s, and (0.8, -0.6) is square to that: at 6 s it is
// nearest to the front right corner, whose distance then decides.
Scenario passingTheCorner(const ScenarioOptions& options, double gap) {
  const double r = options.radius.value_or(kRadius);
  Scenario s = driving(options, 0.6);
  const Point place = {kHalfLength + 0.8 * (r + gap), -kHalfWidth - 0.6 * (r + gap)};
  s.circles = together(passing(7, r, place, 6, {s.robot_speed - 0.6, -0.8}, s.robot_speed));
  return s;
}

}  // namespace

Scenario crossing(const ScenarioOptions& options) {
  const double r = options.radius.value_or(kRadius);
  Scenario s = driving(options, 0.6);
  s.derivation =
      "Obstacle 7 walks to the right at 0.8 m/s over ground, so (-v, -0.8) m/s as seen from the "
      "robot, and is at (0.3 + r, -0.1) m at T = 7.56 s: there it touches the inside of the front "
      "(segment 3). With the robot's 0.6 m/s and r = 0.3 m the front right corner, and with it "
      "segment 2, follows when s^2 - 0.52 s + 0.10 = 0.3^2 with s = t - T: at T + 0.02 s; both are "
      "left at T + 0.50 s. Obstacle 3 stands 2.5 m to the right of the robot's way.";
  s.circles = together(passing(3, 0.2, {3.0, -2.5}, 0, {0, 0}, s.robot_speed),
                       passing(7, r, {kHalfLength + r, -0.1}, 7.56, {0, -0.8}, s.robot_speed));
  return s;
}

Scenario headOn(const ScenarioOptions& options) {
  const double r = options.radius.value_or(kRadius);
  Scenario s = driving(options, 0.4);
  s.derivation =
      "Obstacle 7 comes along y = 0.05 m at 0.6 m/s and touches the front (segment 3) at "
      "T = 7.46 s. With the robot's 0.4 m/s and r = 0.3 m it is at x = 8.06 - t, touches the left "
      "front corner (segment 0) at 7.76 - sqrt(0.3^2 - 0.15^2) s, the right one (segment 2) at "
      "7.76 - sqrt(0.3^2 - 0.25^2) s, and the rear (segment 1) at 8.06 s.";
  s.circles = together(passing(7, r, {kHalfLength + r, 0.05}, 7.46, {-0.6, 0}, s.robot_speed));
  return s;
}

Scenario overtaking(const ScenarioOptions& options) {
  const double r = options.radius.value_or(0.4);
  Scenario s = driving(options, 0.4);
  s.derivation =
      "A cart (obstacle 5) comes from behind along y = -0.05 m, 1 m/s faster than the robot, and "
      "touches the rear (segment 1) at x = -0.3 - r m at T = 6.43 s.";
  s.circles = together(
      passing(5, r, {-kHalfLength - r, -0.05}, 6.43, {s.robot_speed + 1, 0}, s.robot_speed));
  return s;
}

Scenario nearMiss(const ScenarioOptions& options) {
  Scenario s = passingTheCorner(options, 0.05);
  s.derivation =
      "As seen from the robot obstacle 7 moves by (-0.6, -0.8) m/s. At 6 s it is nearest, r + 0.05 "
      "m from the front right corner (0.3, -0.2) in the direction (0.8, -0.6), which is square to "
      "its motion: that leaves a gap of 0.05 m. Nothing is ever touched.";
  return s;
}

Scenario graze(const ScenarioOptions& options) {
  Scenario s = passingTheCorner(options, -0.001);
  s.derivation =
      "As near_miss, but at 6 s the centre is r - 0.001 m from the corner. It is within r for half "
      "a chord before and after: T = 6 - sqrt(r^2 - (r - 0.001)^2) s, since it moves at 1 m/s. The "
      "corner belongs to segments 2 and 3; the lower is named.";
  return s;
}

Scenario cutIn(const ScenarioOptions& options) {
  constexpr double kTurnsIn = 3;  // [s]
  const double r = options.radius.value_or(kRadius);
  Scenario s = driving(options, 0.8);
  s.derivation =
      "Obstacle 9 drives beside the robot, as fast as it, at (0.9 + r, 0.85) m: no contact is "
      "predicted. From 3 s on it moves by (-0.3, -0.4) m/s as seen from the robot: after 2 s it "
      "is at (0.3 + r, 0.05) m, where it touches the front (segment 3) at T = 5 s.";
  const double v = s.robot_speed;
  s.circles = [=](double t) {
    if (t < kTurnsIn)
      return std::vector<Circle>{{9, r, {kHalfLength + r + 0.6, 0.85}, {v, 0}, {0, 0}}};
    return together(passing(9, r, {kHalfLength + r, 0.05}, kTurnsIn + 2, {v - 0.3, -0.4}, v))(t);
  };
  return s;
}

Scenario brake(const ScenarioOptions& options) {
  constexpr double kBegins = 3;           // [s]
  constexpr double kDeceleration = 0.25;  // [m/s^2]
  const double r = options.radius.value_or(kRadius);
  Scenario s = driving(options, 0.6);
  s.derivation =
      "Obstacle 4 drives 0.5 m ahead of the front, as fast as the robot. From 3 s on it brakes by "
      "0.25 m/s^2, which is predicted to go on: 0.25 t^2 / 2 = 0.5 after 2 s, so it touches the "
      "front (segment 3) at T = 5 s, if it has not come to stand before: from 3 + v / 0.25 s on it "
      "stands, and says so.";
  const double v = s.robot_speed;
  s.circles = [=](double t) {
    const double braked = std::clamp(t - kBegins, 0.0, v / kDeceleration);
    const double stood = std::max(0.0, t - kBegins - v / kDeceleration);
    const double x = kHalfLength + r + 0.5 - kDeceleration * braked * braked / 2 - v * stood;
    const bool brakes = t >= kBegins && stood == 0;
    const double speed = stood > 0 ? 0 : v - kDeceleration * braked;
    return std::vector<Circle>{{4, r, {x, 0.05}, {speed, 0}, {brakes ? -kDeceleration : 0.0, 0}}};
  };
  return s;
}

Scenario crowd(const ScenarioOptions& options) {
  Scenario s = driving(options, 0.5);
  s.derivation =
      "Pedestrians at places and with velocities drawn from the seed; each is a straight motion as "
      "in crossing, and the earliest contact with a segment counts.";
  RandomNumbers random(options.seed);
  const double r = options.radius.value_or(0.25);
  std::vector<std::function<Circle(double)>> people;
  for (std::size_t i = 0; i < options.count; ++i) {
    const double direction = random.uniform(-3.14159, 3.14159);
    const double away = random.uniform(2, 12);
    const Point start = {away * std::cos(direction), away * std::sin(direction)};
    const Point velocity = {random.uniform(-1.2, 1.2), random.uniform(-1.2, 1.2)};
    people.push_back(
        passing(static_cast<std::int64_t>(i) + 1, r, start, 0, velocity, s.robot_speed));
  }
  s.circles = [people](double t) {
    std::vector<Circle> circles;
    for (const auto& person : people) circles.push_back(person(t));
    return circles;
  };
  return s;
}

Scenario trailer(const ScenarioOptions& options) {
  constexpr double kHitch = -0.9;  // [m]
  const double r = options.radius.value_or(kRadius);
  Scenario s = driving(options, 0.6);
  s.bodies[0].name = "base";
  s.bodies.push_back({"trailer",
                      "trailer",
                      {kHitch, 0},
                      {{0.4, 0.25}, {-0.4, 0.25}, {-0.4, -0.25}, {0.4, -0.25}}});
  s.derivation =
      "A trailer of 0.8 m x 0.5 m follows with its frame 0.9 m behind the base. Obstacle 7 walks "
      "to the right at 0.8 m/s and passes behind the base: at T = 6.36 s it is at (-0.9, 0.25 + r) "
      "m and touches the trailer's left side (its segment 0). The base is never touched.";
  s.circles = together(passing(7, r, {kHitch, 0.25 + r}, 6.36, {0, -0.8}, s.robot_speed));
  return s;
}

}  // namespace footprint_collision_predictor::tools
