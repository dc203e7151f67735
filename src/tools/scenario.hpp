// Scenarios whose answers are known exactly, by formulas short enough to check by hand.
//
// None of this uses the solver of the core: a solver that is checked against itself is not checked.
//
// The robot drives straight with constant speed, so seen from its base frame every obstacle moves
// on a straight line with constant velocity. A circle on a straight line touches a segment (and the
// solid footprint) during one interval of time, since both are convex. Such an interval for each
// segment is the whole answer: before it, the time to collision counts down to its begin; within
// it, it is 0; after it, there is none.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace footprint_collision_predictor::tools {

struct Point {
  double x;
  double y;
};

/// [s] since the start of the scenario; both ends touch.
struct Interval {
  double begin;
  double end;
};

/// A circle with constant velocity.
struct ScenarioObstacle {
  std::int64_t id;
  double radius;   ///< [m]
  Point start;     ///< [m] centre at the start, in the robot's base frame
  Point relative;  ///< [m/s] velocity as seen from the robot, axes of the base frame
};

constexpr std::size_t kSegments = 4;
using TouchIntervals = std::array<std::optional<Interval>, kSegments>;

/// Length and width of the footprint are 0.6 m and 0.4 m. Segments: 0 left, 1 rear, 2 right, 3
/// front.
constexpr std::array<Point, kSegments> kFootprint = {
    {{0.3, 0.2}, {-0.3, 0.2}, {-0.3, -0.2}, {0.3, -0.2}}};

/// Direction of travel in the fixed frame (of a 3-4-5 triangle, so exact and in no axis).
constexpr Point kHeading = {0.8, 0.6};
/// [m] where the robot is at the start, fixed frame.
constexpr Point kRobotStart = {2.0, -1.0};

constexpr double kHorizon = 5.0;       ///< [s]
constexpr double kWarnTime = 3.0;      ///< [s]
constexpr double kCriticalTime = 1.5;  ///< [s]

struct Scenario {
  std::string name;
  std::string summary;     ///< one line
  std::string derivation;  ///< the answers, for checking by hand
  double robot_speed;      ///< [m/s]
  std::vector<ScenarioObstacle> obstacles;
  TouchIntervals touches;                   ///< when the dangerous obstacle touches each segment
  std::optional<int> segment;               ///< the one touched first
  std::optional<std::int64_t> obstacle_id;  ///< of the obstacle that touches it
};

/// In the order in which they are listed to the user.
const std::vector<Scenario>& scenarios();
/// nullptr when there is none of that name.
const Scenario* findScenario(const std::string& name);

/// When the solid footprint is touched: from the first segment's begin to the last one's end.
std::optional<Interval> footprintTouch(const Scenario& scenario);
/// Time to collision [s] at time t, within kHorizon.
std::optional<double> timeToCollision(const std::optional<Interval>& touch, double t);

/// [m] of the robot in the fixed frame at time t.
Point robotPosition(const Scenario& scenario, double t);
/// [m] centre of the obstacle in the fixed frame at time t.
Point obstaclePosition(const Scenario& scenario, const ScenarioObstacle& obstacle, double t);
/// [m/s] over ground, axes of the fixed frame.
Point obstacleVelocity(const Scenario& scenario, const ScenarioObstacle& obstacle);

}  // namespace footprint_collision_predictor::tools
