// The motion of a frame over ground, by the differences of transforms.
#pragma once

#include <tf2/buffer_core.h>

#include <string>

#include "footprint_collision_predictor/motion.hpp"
#include "planar_pose.hpp"

namespace footprint_collision_predictor {

/// [s] From one transform to the other.
constexpr double kMotionInterval = 0.1;

/// The constant twist, in the axes of the body, that takes it from one pose to another: the
/// logarithm of SE(2) (Lynch and Park, "Modern Robotics", 2017), so that an arc is not cut short.
/// \param seconds > 0, in which it turns by less than half a turn
core::Twist twistBetween(const PlanarPose& from, const PlanarPose& to, double seconds);

struct FrameMotion {
  core::Twist twist;  ///< of the frame's origin, along its axes
  ros::Time
      newest;  ///< the transform until which it is known: that of the stamp, or the last before
};

/// The twist over the last kMotionInterval until the stamp, exact where it is constant (and where
/// tf has no transform for a moment asked for, but for its straight line between two).
/// \throws TransformError when one is missing or gives a velocity beyond kMaxRate
FrameMotion frameMotion(const tf2::BufferCore& tf, const std::string& fixed_frame,
                        const std::string& frame, const ros::Time& stamp);

}  // namespace footprint_collision_predictor
