// Scenarios whose answers are known exactly.
//
// The robot drives straight or on an arc, with constant speed and yaw rate. The predictor takes
// every motion to go on as it is at the moment of a message, and so do the answers: what a later
// message says of a person who has changed course is that message's answer.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "contact_formulas.hpp"

namespace footprint_collision_predictor::tools {

constexpr double kHorizon = 5.0;       ///< [s]
constexpr double kWarnTime = 3.0;      ///< [s]
constexpr double kCriticalTime = 1.5;  ///< [s]

/// What can be chosen when a scenario is made; nothing: the scenario's own.
struct ScenarioOptions {
  std::optional<double> speed;   ///< [m/s] of the robot
  std::optional<double> radius;  ///< [m] of the obstacles that matter
  std::uint64_t seed = 1;
  std::size_t count = 20;  ///< pedestrians of a crowd
  double rate = 10;        ///< [Hz] of the obstacles messages
  double duration = 8;     ///< [s]
  double noise = 0;        ///< [m] standard deviation of each coordinate of measured positions
};

/// An obstacle at one moment, in the axes of the robot's base frame then.
struct Circle {
  std::int64_t id;
  double radius;       ///< [m]
  Point position;      ///< [m] centre
  Point velocity;      ///< [m/s] over ground
  Point acceleration;  ///< [m/s^2]
};

/// One of the robot's rigid parts.
struct Body {
  std::string name;
  std::string frame;
  Point origin;                 ///< [m] of its frame in the base frame, whose axes it shares
  std::vector<Point> vertices;  ///< [m] in its frame
};

/// No obstacles messages in between [s].
struct Silence {
  double after;
  double before;
};

struct Scenario {
  std::string name;
  std::string summary;     ///< one line
  std::string derivation;  ///< the answers, for checking by hand
  double robot_speed = 0;  ///< [m/s]
  double yaw_rate = 0;     ///< [rad/s] >= 0; obstacles stand still where it is not 0
  std::vector<Body> bodies;
  /// The obstacles at t [s] since the start.
  std::function<std::vector<Circle>(double t)> circles;
  std::optional<Silence> silence;
  bool looped = false;  ///< the clock jumps back to the start at the end, and all comes once more
};

/// A scenario by its name, before anything has been chosen.
struct ScenarioKind {
  std::string name;
  std::string summary;
  bool has_speed;  ///< whether the robot's speed can be chosen
  std::function<Scenario(const ScenarioOptions&)> make;
};

/// In the order in which they are listed to the user.
const std::vector<ScenarioKind>& scenarioKinds();
/// nullptr when there is none of that name.
const ScenarioKind* findScenario(const std::string& name);

/// Segments of the body in the base frame, in the order of its vertices.
std::vector<Line> segmentsOf(const Body& body);

/// Where the robot is.
struct Pose {
  Point position;  ///< [m] in the fixed frame
  double heading;  ///< [rad]
};
Pose robotPose(const Scenario& scenario, double t);

/// A contact that the predictor must find.
struct Contact {
  double time;  ///< [s] from the message
  std::int64_t obstacle_id;
};

/// First contact with the segment within the horizon, as the motions of these circles go on.
std::optional<Contact> firstContact(const Scenario& scenario, const std::vector<Circle>& circles,
                                    const Line& segment);

/// The circles as they are measured: with noise, the same for the same seed and moment.
std::vector<Circle> measured(const Scenario& scenario, const ScenarioOptions& options, double t);

}  // namespace footprint_collision_predictor::tools
