#include "scenario.hpp"

#include <algorithm>
#include <cmath>

#include "random_numbers.hpp"

namespace footprint_collision_predictor::tools {
namespace {

// At the start, in no axis of the fixed frame.
constexpr Point kStart = {2.0, -1.0};           // [m]
const double kStartHeading = std::atan2(3, 4);  // [rad]

std::optional<double> contactTime(const Scenario& scenario, const Circle& circle,
                                  const Line& segment) {
  const double speed = scenario.robot_speed;
  if (scenario.yaw_rate > 0)
    return roundContact(circle.position, {0, speed / scenario.yaw_rate}, scenario.yaw_rate,
                        circle.radius, segment);
  const Point relative = {circle.velocity.x - speed, circle.velocity.y};
  return straightContact(circle.position, relative, circle.acceleration, circle.radius, segment);
}

}  // namespace

const ScenarioKind* findScenario(const std::string& name) {
  const auto& all = scenarioKinds();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const ScenarioKind& s) { return s.name == name; });
  return found == all.end() ? nullptr : &*found;
}

std::vector<Line> segmentsOf(const Body& body) {
  std::vector<Line> segments;
  const auto placed = [&](const Point& p) {
    return Point{p.x + body.origin.x, p.y + body.origin.y};
  };
  for (std::size_t i = 0; i < body.vertices.size(); ++i)
    segments.push_back(
        {placed(body.vertices[i]), placed(body.vertices[(i + 1) % body.vertices.size()])});
  return segments;
}

Pose robotPose(const Scenario& scenario, double t) {
  const double turned = scenario.yaw_rate * t;
  const double heading = kStartHeading + turned;
  if (scenario.yaw_rate > 0) {
    const double bend = scenario.robot_speed / scenario.yaw_rate;  // radius of the arc
    return {{kStart.x + bend * (std::sin(heading) - std::sin(kStartHeading)),
             kStart.y - bend * (std::cos(heading) - std::cos(kStartHeading))},
            heading};
  }
  const double way = scenario.robot_speed * t;
  return {{kStart.x + way * std::cos(heading), kStart.y + way * std::sin(heading)}, heading};
}

std::optional<Contact> firstContact(const Scenario& scenario, const std::vector<Circle>& circles,
                                    const Line& segment) {
  std::optional<Contact> first;
  for (const Circle& circle : circles) {
    const auto time = contactTime(scenario, circle, segment);
    if (time && *time <= kHorizon && (!first || *time < first->time)) first = {*time, circle.id};
  }
  return first;
}

std::vector<Circle> measured(const Scenario& scenario, const ScenarioOptions& options, double t) {
  std::vector<Circle> circles = scenario.circles(t);
  if (options.noise == 0) return circles;
  RandomNumbers random(options.seed + static_cast<std::uint64_t>(std::llround(t * 1e9)));
  for (Circle& circle : circles) {
    circle.position.x += options.noise * random.normal();
    circle.position.y += options.noise * random.normal();
  }
  return circles;
}

}  // namespace footprint_collision_predictor::tools
