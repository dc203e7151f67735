// Scenarios of a robot that turns, and their derivations.
// All coordinates are in the robot's base frame at the moment; T is the moment of contact in
// seconds since the start, r the radius, v the robot's speed.
#include <cmath>

#include "scenario_parts.hpp"

namespace footprint_collision_predictor::tools {
namespace {

/// What stands still, seen from a robot that turns to the left at `rate` about `about`: it goes
/// round it to the right. At `when` it is in the direction `angle`.
std::function<Circle(double)> goingRound(std::int64_t id, double radius, Point about, double rho,
                                         double angle, double when, double rate) {
  return [=](double t) {
    const double now = angle - rate * (t - when);
    return Circle{
        id, radius, {about.x + rho * std::cos(now), about.y + rho * std::sin(now)}, {0, 0}, {0, 0}};
  };
}

/// Angle between two sides a and b of a triangle, opposite to the third.
double angleBetween(double a, double b, double opposite) {
  return std::acos((a * a + b * b - opposite * opposite) / (2 * a * b));
}

}  // namespace

Scenario turnInPlace(const ScenarioOptions& options) {
  const double r = options.radius.value_or(kRadius);
  Scenario s = driving(options, 0);
  s.robot_speed = 0;
  s.yaw_rate = 0.1;
  const double reach = std::hypot(kHalfLength, kHalfWidth);
  const double rho = reach + r - 0.02;
  const double corner = std::atan2(kHalfWidth, kHalfLength);
  s.derivation =
      "The robot turns to the left at 0.1 rad/s on the spot. Its front left corner is d = "
      "sqrt(0.3^2 + 0.2^2) m from its centre, and a pillar (obstacle 2) stands rho = d + r - 0.02 "
      "m "
      "from it, so that the corner runs 2 cm into it: when the angle between the two is "
      "acos((d^2 + rho^2 - r^2) / (2 d rho)), at T = 5.57 s. The corner belongs to segments 0 and "
      "3; the lower is named.";
  s.circles = together(
      goingRound(2, r, {0, 0}, rho, corner + angleBetween(reach, rho, r), 5.57, s.yaw_rate));
  return s;
}

Scenario arcPastPillar(const ScenarioOptions& options) {
  const double r = options.radius.value_or(kRadius);
  Scenario s = driving(options, 0.5);
  s.yaw_rate = 0.25;
  const Point about = {0, s.robot_speed / s.yaw_rate};
  const Point corner = {kHalfLength - about.x, -kHalfWidth - about.y};
  const double reach = std::hypot(corner.x, corner.y);
  const double rho = reach + r - 0.02;
  s.derivation =
      "The robot drives an arc to the left at 0.25 rad/s, about (0, v / 0.25) m. Its front right "
      "corner goes round farthest out, on a circle of d = sqrt(0.3^2 + (0.2 + v / 0.25)^2) m; a "
      "pillar (obstacle 2) stands rho = d + r - 0.02 m from that centre, so that the corner runs 2 "
      "cm into it: when the angle between the two is acos((d^2 + rho^2 - r^2) / (2 d rho)), at "
      "T = 5.57 s. The corner belongs to segments 2 and 3; the lower is named. Straight on, the "
      "robot would pass it elsewhere.";
  const double touching = std::atan2(corner.y, corner.x) + angleBetween(reach, rho, r);
  s.circles = together(goingRound(2, r, about, rho, touching, 5.57, s.yaw_rate));
  return s;
}

}  // namespace footprint_collision_predictor::tools
