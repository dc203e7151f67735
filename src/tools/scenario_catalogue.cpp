// All scenarios by name, and the parts that they share.
#include "scenario_parts.hpp"

namespace footprint_collision_predictor::tools {
namespace {

Body base() {
  return {"footprint",
          "base_link",
          {0, 0},
          {{kHalfLength, kHalfWidth},
           {-kHalfLength, kHalfWidth},
           {-kHalfLength, -kHalfWidth},
           {kHalfLength, -kHalfWidth}}};
}

Scenario staleTracker(const ScenarioOptions& options) {
  Scenario s = crossing(options);
  s.silence = Silence{2.0, 4.0};
  s.derivation += " Between 2 s and 4 s the tracker says nothing.";
  return s;
}

Scenario loopedClock(const ScenarioOptions& options) {
  Scenario s = crossing(options);
  s.looped = true;
  s.derivation += " At the end the clock jumps back to the start, and all comes once more.";
  return s;
}

Scenario none(const ScenarioOptions& options) {
  Scenario s = driving(options, 0.5);
  s.derivation = "Every obstacles message is empty, which says \"nothing there\": always CLEAR.";
  s.circles = [](double) { return std::vector<Circle>(); };
  return s;
}

}  // namespace

Scenario driving(const ScenarioOptions& options, double speed) {
  Scenario s;
  s.robot_speed = options.speed.value_or(speed);
  s.bodies = {base()};
  return s;
}

std::function<Circle(double)> passing(std::int64_t id, double radius, Point place, double when,
                                      Point velocity, double robot_speed) {
  const Point relative = {velocity.x - robot_speed, velocity.y};
  return [=](double t) {
    return Circle{id,
                  radius,
                  {place.x + (t - when) * relative.x, place.y + (t - when) * relative.y},
                  velocity,
                  {0, 0}};
  };
}

const std::vector<ScenarioKind>& scenarioKinds() {
  static const std::vector<ScenarioKind> all = {
      {"crossing", "a person walks across the robot's way; another one stands aside", true,
       crossing},
      {"head_on", "a person comes straight towards the robot", true, headOn},
      {"overtaking", "a faster cart runs into the robot from behind", true, overtaking},
      {"near_miss", "a person crosses ahead and misses the front right corner by 5 cm", true,
       nearMiss},
      {"graze", "a person crosses ahead and touches the front right corner by 1 mm", true, graze},
      {"cut_in", "another robot beside this one turns in front of it", true, cutIn},
      {"brake", "the one ahead brakes", true, brake},
      {"turn_in_place", "the robot turns on the spot beside a pillar", false, turnInPlace},
      {"arc_past_pillar", "the robot drives an arc, and its corner touches a pillar", true,
       arcPastPillar},
      {"crowd", "pedestrians all round, as many and where --count and --seed say", true, crowd},
      {"trailer", "a person walks into the trailer behind the robot (two footprints)", true,
       trailer},
      {"stale_tracker", "as crossing, but the tracker falls silent for two seconds", true,
       staleTracker},
      {"looped_clock", "as crossing, twice: the clock jumps back in between", true, loopedClock},
      {"none", "the robot drives with nothing around it", true, none}};
  return all;
}

}  // namespace footprint_collision_predictor::tools
