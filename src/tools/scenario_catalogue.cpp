// The scenarios and their derivations. All coordinates are in the robot's base frame, where the
// robot stands still; T is the moment of contact in seconds since the start.
#include <cmath>

#include "scenario.hpp"

namespace footprint_collision_predictor::tools {
namespace {

// The centre comes in from ahead on the left: relative velocity (-0.6, -0.8) m/s, so 1 m/s.
//   front: its line x = 0.3 is reached when x = 0.6: T = (5.136 - 0.6) / 0.6 = 7.56 s. There
//          y = 5.948 - 0.8 T = -0.1, between the ends: the inside is touched.
// With s = t - T the centre is (0.6 - 0.6 s, -0.1 - 0.8 s). Squared distance from the corners:
//   (0.3, -0.2)   s^2 - 0.52 s + 0.10 <= 0.09  <=>  s = 0.26 -+ 0.24: from 0.02 to 0.50
//   (0.3, 0.2)    s^2 + 0.12 s + 0.18, and (-0.3, -0.2)   s^2 - 1.24 s + 0.82: always > 0.09
// so the right side is touched at its front corner at T + 0.02, and both it and the front until
// T + 0.50, when the centre (0.3, -0.5) is below that corner; left and rear never.
Scenario crossing() {
  const double contact = 7.56;
  Scenario s;
  s.name = "crossing";
  s.summary = "a person walks across the robot's way; another one stands aside";
  s.derivation =
      "As seen from the robot, obstacle 7 (radius 0.3 m) starts at (5.136, 5.948) m and moves by "
      "(-0.6, -0.8) m/s. It reaches x = 0.3 + 0.3 m, where it touches the front, at "
      "T = (5.136 - 0.6) / 0.6 = 7.56 s, then at y = 5.948 - 0.8 T = -0.1 m, so inside of segment "
      "3. The front right corner (0.3, -0.2), and with it segment 2, follows when "
      "s^2 - 0.52 s + 0.10 = 0.3^2 with s = t - T: at T + 0.02 s. Both are left at T + 0.50 s; "
      "segments 0 and 1 are never touched. Obstacle 3 stands 2.5 m to the right of the robot's "
      "way and never matters.";
  s.robot_speed = 0.6;
  s.obstacles = {{3, 0.2, {3.0, -2.5}, {-0.6, 0.0}}, {7, 0.3, {5.136, 5.948}, {-0.6, -0.8}}};
  s.touches[2] = Interval{contact + 0.02, contact + 0.50};
  s.touches[3] = Interval{contact, contact + 0.50};
  s.segment = 3;
  s.obstacle_id = 7;
  return s;
}

// The centre comes along y = 0.05 with closing speed 1 m/s from x = 8.06. It is at x at the time
// 8.06 - x, and the circle (radius 0.3) touches
//   front, x = 0.3, inside   while |x - 0.3| <= 0.3             so from x = 0.6 to 0
//   rear, x = -0.3, inside   while |x + 0.3| <= 0.3             so from x = 0 to -0.6
//   left, 0.15 away          from corner to corner, half chord sqrt(0.09 - 0.0225) = sqrt(0.0675)
//   right, 0.25 away         from corner to corner, half chord sqrt(0.09 - 0.0625) = sqrt(0.0275)
Scenario headOn() {
  const double left = std::sqrt(0.0675);
  const double right = std::sqrt(0.0275);
  Scenario s;
  s.name = "head_on";
  s.summary = "a person comes straight towards the robot";
  s.derivation =
      "As seen from the robot, obstacle 7 (radius 0.3 m) starts at (8.06, 0.05) m and moves by "
      "(-1, 0) m/s: robot 0.4 m/s, person 0.6 m/s. It touches the front (segment 3) after "
      "(8.06 - 0.3 - 0.3) / 1 = 7.46 s, the left front corner (segment 0) at "
      "7.76 - sqrt(0.3^2 - 0.15^2) s, the right one (segment 2) at 7.76 - sqrt(0.3^2 - 0.25^2) s, "
      "and the rear (segment 1) at 8.06 s.";
  s.robot_speed = 0.4;
  s.obstacles = {{7, 0.3, {8.06, 0.05}, {-1.0, 0.0}}};
  s.touches[0] = Interval{7.76 - left, 8.36 + left};
  s.touches[1] = Interval{8.06, 8.66};
  s.touches[2] = Interval{7.76 - right, 8.36 + right};
  s.touches[3] = Interval{7.46, 8.06};
  s.segment = 3;
  s.obstacle_id = 7;
  return s;
}

// The way of the centre runs at 0.35 m from the front right corner, the nearest point being
// corner + 0.35 (0.8, -0.6) = (0.58, -0.41), which it reaches at 6 s: from (0.58 + 3.6, -0.41
// + 4.8).
Scenario nearMiss() {
  Scenario s;
  s.name = "near_miss";
  s.summary = "a person crosses ahead and misses the front right corner by 5 cm";
  s.derivation =
      "As seen from the robot, obstacle 7 (radius 0.3 m) starts at (4.18, 4.39) m and moves by "
      "(-0.6, -0.8) m/s. Nearest to the robot is the front right corner (0.3, -0.2), at 6 s: the "
      "centre is then at (0.58, -0.41) m, at a distance of sqrt(0.28^2 + 0.21^2) = 0.35 m, which "
      "leaves a gap of 0.05 m. Nothing is ever touched.";
  s.robot_speed = 0.6;
  s.obstacles = {{7, 0.3, {4.18, 4.39}, {-0.6, -0.8}}};
  return s;
}

Scenario none() {
  Scenario s;
  s.name = "none";
  s.summary = "the robot drives with nothing around it";
  s.derivation = "Every obstacles message is empty, which says \"nothing there\": always CLEAR.";
  s.robot_speed = 0.5;
  return s;
}

}  // namespace

const std::vector<Scenario>& scenarios() {
  static const std::vector<Scenario> all = {crossing(), headOn(), nearMiss(), none()};
  return all;
}

}  // namespace footprint_collision_predictor::tools
