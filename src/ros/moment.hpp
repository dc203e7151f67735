// Two clocks: the ROS clock, which may be simulated, and the steady one, which never jumps.
#pragma once

#include <ros/time.h>

#include <cstdint>

namespace footprint_collision_predictor {

/// When a message arrived or something is evaluated. Offline, both clocks are the recording's.
struct Moment {
  ros::Time ros;  ///< zero while a simulated clock has not started
  ros::SteadyTime steady;
};

/// later - earlier [s], to the nanosecond for moments near each other. (ros::Duration throws for
/// stamps more than 68 years apart, which bad input may be.)
inline double secondsBetween(const ros::Time& earlier, const ros::Time& later) {
  const auto seconds = std::int64_t{later.sec} - std::int64_t{earlier.sec};
  const auto nanoseconds = std::int64_t{later.nsec} - std::int64_t{earlier.nsec};
  return static_cast<double>(seconds) + 1e-9 * static_cast<double>(nanoseconds);
}

inline double secondsBetween(const ros::SteadyTime& earlier, const ros::SteadyTime& later) {
  return (later - earlier).toSec();
}

}  // namespace footprint_collision_predictor
