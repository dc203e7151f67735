// What the scenarios are made of.
#pragma once

#include "scenario.hpp"

namespace footprint_collision_predictor::tools {

constexpr double kRadius = 0.3;  // [m] of a person

// 0.6 m long, 0.4 m wide. Segments: 0 left, 1 rear, 2 right, 3 front.
constexpr double kHalfLength = 0.3;
constexpr double kHalfWidth = 0.2;

/// A robot alone.
Scenario driving(const ScenarioOptions& options, double speed);

/// A circle that is at `place` at the moment `when`, with a constant velocity over ground.
std::function<Circle(double)> passing(std::int64_t id, double radius, Point place, double when,
                                      Point velocity, double robot_speed);

template <typename... Circles>
std::function<std::vector<Circle>(double)> together(const Circles&... circles) {
  return [=](double t) { return std::vector<Circle>{circles(t)...}; };
}

// Straight on.
Scenario crossing(const ScenarioOptions& options);
Scenario headOn(const ScenarioOptions& options);
Scenario overtaking(const ScenarioOptions& options);
Scenario nearMiss(const ScenarioOptions& options);
Scenario graze(const ScenarioOptions& options);
Scenario cutIn(const ScenarioOptions& options);
Scenario brake(const ScenarioOptions& options);
Scenario crowd(const ScenarioOptions& options);
Scenario trailer(const ScenarioOptions& options);

// Turning.
Scenario turnInPlace(const ScenarioOptions& options);
Scenario arcPastPillar(const ScenarioOptions& options);

}  // namespace footprint_collision_predictor::tools
