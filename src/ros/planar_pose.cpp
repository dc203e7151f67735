#include "planar_pose.hpp"

#include <tf2/exceptions.h>

#include <cmath>
#include <sstream>

namespace footprint_collision_predictor {
namespace {

constexpr double kCosineOfLargestTilt = 0.86602540378443865;  // 30 degrees

std::string newestTransform(const tf2::BufferCore& tf, const std::string& reference,
                            const std::string& frame) try {
  const ros::Time newest = tf.lookupTransform(reference, frame, ros::Time(0)).header.stamp;
  std::ostringstream text;
  text << "the newest there is is from " << newest;
  return text.str();
} catch (const tf2::TransformException&) {
  return "there is none at any time; check that both frames are published and connected";
}

}  // namespace

PlanarPose project(const geometry_msgs::Transform& transform) {
  const auto& t = transform.translation;
  const auto& q = transform.rotation;
  if (!(std::isfinite(t.x) && std::isfinite(t.y) && std::isfinite(t.z) && std::isfinite(q.x) &&
        std::isfinite(q.y) && std::isfinite(q.z) && std::isfinite(q.w)))
    throw std::domain_error("it contains a number that is not finite");
  if (1 - 2 * (q.x * q.x + q.y * q.y) < kCosineOfLargestTilt)
    throw std::domain_error("it is tilted by more than 30 degrees; everything here is planar");
  const core::Vec2 x_axis(1 - 2 * (q.y * q.y + q.z * q.z), 2 * (q.x * q.y + q.w * q.z));
  return {{t.x, t.y}, x_axis.normalized()};
}

PlanarPose lookUpPose(const tf2::BufferCore& tf, const std::string& reference,
                      const std::string& frame, const ros::Time& time) {
  if (reference == frame) return {};
  std::ostringstream where;
  where << "transform between \"" << reference << "\" and \"" << frame << "\" at " << time << ": ";
  try {
    return project(tf.lookupTransform(reference, frame, time).transform);
  } catch (const tf2::TransformException& error) {
    throw TransformError(where.str() + error.what() + " (" + newestTransform(tf, reference, frame) +
                         ")");
  } catch (const std::domain_error& error) {
    throw TransformError(where.str() + error.what());
  }
}

bool canLookUpPose(const tf2::BufferCore& tf, const std::string& reference,
                   const std::string& frame, const ros::Time& time) {
  return reference == frame || tf.canTransform(reference, frame, time);
}

}  // namespace footprint_collision_predictor
