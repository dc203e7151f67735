// Named questions in which the segment's body turns.
#include <cmath>

#include "time_to_collision_cases.hpp"

namespace footprint_collision_predictor::test {
namespace {

using core::Feature;

const Segment kBar{{0, 0}, {4, 0}};
constexpr bool kGraze = true;

Case pillar(const Segment& segment, const Vec2& position, double radius, const Twist& twist,
            double horizon = 10) {
  return {segment, {position, {0, 0}, {0, 0}}, radius, horizon, 0, twist};
}

NamedCase hit(const std::string& name, const Case& question, double time, Feature feature,
              const Vec2& point, bool graze = false) {
  return {name, question, time, feature, point, graze};
}

NamedCase none(const std::string& name, const Case& question) {
  return {name, question, std::nullopt, Feature::kInside, {0, 0}, false};
}

// The bar turns about its start by 1 rad/s and meets what stands there.
std::vector<NamedCase> inPlaceCases() {
  const Twist left{{0, 0}, 1};
  const Twist right{{0, 0}, -1};
  const double third = std::asin(1.0 / 3);                  // 3 m away, and 1 m beside the bar
  const double last = std::acos((16 + 20.25 - 0.36) / 36);  // 0.6 m from the end, by cosines
  return {
      hit("turns left onto a point", pillar(kBar, {0, 3}, 0, left), M_PI / 2, Feature::kInside,
          {3, 0}),
      hit("turns right onto a point", pillar(kBar, {0, -3}, 0, right), M_PI / 2, Feature::kInside,
          {3, 0}),
      hit("turns right onto a point on its left", pillar(kBar, {0, 3}, 0, right), 1.5 * M_PI,
          Feature::kInside, {3, 0}),
      hit("turns left onto a pillar", pillar(kBar, {0, 3}, 1, left), M_PI / 2 - third,
          Feature::kInside, {std::sqrt(8.0), 0}),
      hit("turns right onto a pillar", pillar(kBar, {0, -3}, 1, right), M_PI / 2 - third,
          Feature::kInside, {std::sqrt(8.0), 0}),
      hit("turns its end onto a pillar", pillar(kBar, {0, 4.5}, 0.6, left), M_PI / 2 - last,
          Feature::kEnd, {4, 0}),
      hit("grazes a pillar with its end", pillar(kBar, {0, 5}, 1, left), M_PI / 2, Feature::kEnd,
          {4, 0}, kGraze),
      none("turns many times below a pillar", pillar(kBar, {0, 5}, 0.999, left, 100)),
      none("turns towards a pillar until the horizon", pillar(kBar, {0, 3}, 1, left, 1.23)),
      hit("touches the pillar and turns away", pillar(kBar, {2, 1}, 1, right), 0, Feature::kInside,
          {2, 0}),
      hit("touches the pillar and turns towards it", pillar(kBar, {2, 1}, 1, left), 0,
          Feature::kInside, {2, 0}),
      // About its middle: the pillar stands 1 m from there, and 1/2 m beside the bar in the end.
      hit("turns about its middle", pillar(kBar, {2, 1}, 0.5, {{0, -2}, 1}), M_PI / 3,
          Feature::kInside, {2 + std::sqrt(0.75), 0}),
  };
}

// Forwards by u, about (0, u / w).
std::vector<NamedCase> arcCases() {
  const Segment origin{{0, 0}, {0, 0}};
  const Segment bumper{{1, -0.5}, {1, 0.5}};
  return {
      // The way is a circle of 1 m, and 1 m away from its point at 180 degrees is that at 120.
      hit("arc onto a pillar on its way", pillar(origin, {0, 2}, 1, {{1, 0}, 1}), 2 * M_PI / 3,
          Feature::kStart, {0, 0}),
      hit("arc to the right onto a pillar on its way", pillar(origin, {0, -2}, 1, {{1, 0}, -1}),
          2 * M_PI / 3, Feature::kStart, {0, 0}),
      // Its corners keep within 2.7 m of (0, 2); the pillar is 5.4 m away.
      none("arc past a pillar straight ahead", pillar(bumper, {5, 0}, 0.3, {{1, 0}, 0.5}, 60)),
      hit("straight onto the pillar ahead", pillar(bumper, {5, 0}, 0.3, {{1, 0}, 0}), 3.7,
          Feature::kInside, {1, 0}),
      // About (0, 2), which is not on the bar. From there the pillar is (2, 2), then (2, -2).
      hit("arc about a centre off the body", pillar({{1, 0}, {3, 0}}, {2, 4}, 0, {{3, 0}, 1.5}),
          M_PI / 3, Feature::kInside, {2, 0}),
      hit("sideways and backwards, the same arc",  // seen from a body turned by 180 degrees
          pillar({{-1, 0}, {-3, 0}}, {-2, -4}, 0, {{-3, 0}, 1.5}), M_PI / 3, Feature::kInside,
          {-2, 0}),
  };
}

// After one second the bar points along y, and the disc is 1 m beside it.
std::vector<NamedCase> movingCases() {
  const Twist quarter{{0, 0}, M_PI / 2};
  const Twist one_turn_a_second{{0, 0}, 2 * M_PI};
  return {
      hit("turns onto a disc that comes", {kBar, {{-1, 3}, {0, -1}, {0, 0}}, 1, 10, 0, quarter}, 1,
          Feature::kInside, {2, 0}),
      hit("turns onto a disc that falls", {kBar, {{-1, 2.5}, {0, 0}, {0, -1}}, 1, 10, 0, quarter},
          1, Feature::kInside, {2, 0}),
      hit("turns onto a disc that grows",
          {kBar, {{-1, 2}, {0, 0}, {0, 0}}, 0.75, 10, 0.25, quarter}, 1, Feature::kInside, {2, 0}),
      // The disc comes down by half a metre a second; when the bar points at it for the third time
      // its rim is at 4 m, after it was at 5 and 4.5.
      hit("reaches it in the third turn",
          {kBar, {{0, 6.125}, {0, -0.5}, {0, 0}}, 1, 10, 0, one_turn_a_second}, 2.25, Feature::kEnd,
          {4, 0}),
      hit("reaches it in the third turn to the right",
          {kBar, {{0, -6.125}, {0, 0.5}, {0, 0}}, 1, 10, 0, {{0, 0}, -2 * M_PI}}, 2.25,
          Feature::kEnd, {4, 0}),
  };
}

}  // namespace

std::vector<NamedCase> turningCases() {
  std::vector<NamedCase> all;
  for (const auto& part : {inPlaceCases(), arcCases(), movingCases()})
    all.insert(all.end(), part.begin(), part.end());
  return all;
}

}  // namespace footprint_collision_predictor::test
