#include "scenario.hpp"

#include <algorithm>

namespace footprint_collision_predictor::tools {
namespace {

Point rotateToFixed(const Point& p) {
  return {kHeading.x * p.x - kHeading.y * p.y, kHeading.y * p.x + kHeading.x * p.y};
}

}  // namespace

const Scenario* findScenario(const std::string& name) {
  const auto& all = scenarios();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Scenario& s) { return s.name == name; });
  return found == all.end() ? nullptr : &*found;
}

std::optional<Interval> footprintTouch(const Scenario& scenario) {
  std::optional<Interval> all;
  for (const auto& touch : scenario.touches) {
    if (!touch) continue;
    all =
        all ? Interval{std::min(all->begin, touch->begin), std::max(all->end, touch->end)} : *touch;
  }
  return all;
}

std::optional<double> timeToCollision(const std::optional<Interval>& touch, double t) {
  if (!touch || t > touch->end || touch->begin - t > kHorizon) return std::nullopt;
  return std::max(0.0, touch->begin - t);
}

Point robotPosition(const Scenario& scenario, double t) {
  const double way = scenario.robot_speed * t;
  return {kRobotStart.x + way * kHeading.x, kRobotStart.y + way * kHeading.y};
}

Point obstaclePosition(const Scenario& scenario, const ScenarioObstacle& obstacle, double t) {
  const Point robot = robotPosition(scenario, t);
  const Point offset = rotateToFixed(
      {obstacle.start.x + t * obstacle.relative.x, obstacle.start.y + t * obstacle.relative.y});
  return {robot.x + offset.x, robot.y + offset.y};
}

Point obstacleVelocity(const Scenario& scenario, const ScenarioObstacle& obstacle) {
  return rotateToFixed({obstacle.relative.x + scenario.robot_speed, obstacle.relative.y});
}

}  // namespace footprint_collision_predictor::tools
