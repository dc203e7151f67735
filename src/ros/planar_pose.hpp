// tf transforms, projected onto the plane.
#pragma once

#include <geometry_msgs/Transform.h>
#include <tf2/buffer_core.h>

#include <optional>
#include <stdexcept>
#include <string>

#include "footprint_collision_predictor/geometry.hpp"

namespace footprint_collision_predictor {

/// Thrown for a transform that is missing or unusable; what() names both frames and the time.
class TransformError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Pose of one frame in another, in the plane.
struct PlanarPose {
  core::Vec2 position{0, 0};
  core::Vec2 x_axis{1, 0};  ///< unit length

  /// From the outer frame into the posed one. Subtracts first, so that a map far from its origin
  /// costs no digits.
  core::Vec2 pointToLocal(const core::Vec2& p) const { return vectorToLocal(p - position); }
  core::Vec2 vectorToLocal(const core::Vec2& v) const {
    return {x_axis.dot(v), core::cross(x_axis, v)};
  }
  core::Vec2 vectorFromLocal(const core::Vec2& v) const {
    return v.x() * x_axis + v.y() * core::leftNormal(x_axis);
  }
};

/// Projects the x axis and the origin onto the plane.
/// \throws std::domain_error when a number is not finite or the frame is tilted by more than 30
/// degrees
PlanarPose project(const geometry_msgs::Transform& transform);

/// Pose of `frame` in `reference` at the given time. Equal frames give the identity without any tf.
/// \throws TransformError that names both frames, the time asked for and the newest there is
PlanarPose lookUpPose(const tf2::BufferCore& tf, const std::string& reference,
                      const std::string& frame, const ros::Time& time);

/// Whether lookUpPose would find the transform now.
bool canLookUpPose(const tf2::BufferCore& tf, const std::string& reference,
                   const std::string& frame, const ros::Time& time);

/// Stamp of the newest transform between two frames: zero when it is the same at all times, nothing
/// when there is none.
std::optional<ros::Time> newestTransform(const tf2::BufferCore& tf, const std::string& reference,
                                         const std::string& frame);

}  // namespace footprint_collision_predictor
