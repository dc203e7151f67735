#include "planar_pose.hpp"

#include <cmath>
#include <sstream>

namespace footprint_collision_predictor {
namespace {

constexpr double kCosineOfLargestTilt = 0.86602540378443865;  // 30 degrees

std::string newestText(const std::optional<ros::Time>& newest) {
  if (!newest)
    return "there is none at any time; check that both frames are published and connected";
  std::ostringstream text;
  text << "the newest there is is from " << *newest;
  return text.str();
}

}  // namespace

PlanarPose project(const geometry_msgs::Transform& transform) {
  const auto& t = transform.translation;
  const auto& q = transform.rotation;
  if (!(std::isfinite(t.x) && std::isfinite(t.y) && std::isfinite(t.z) && std::isfinite(q.x) &&
        std::isfinite(q.y) && std::isfinite(q.z) && std::isfinite(q.w)))
    throw std::domain_error("it contains a number that is not finite");
  // For quaternions of any length: tf2 lets those pass that are off by up to one per cent.
  const double ww = q.w * q.w, xx = q.x * q.x, yy = q.y * q.y, zz = q.z * q.z;
  if (ww - xx - yy + zz < kCosineOfLargestTilt * (ww + xx + yy + zz))
    throw std::domain_error("it is tilted by more than 30 degrees; everything here is planar");
  const core::Vec2 x_axis(ww + xx - yy - zz, 2 * (q.x * q.y + q.w * q.z));
  return {{t.x, t.y}, x_axis.normalized()};
}

PlanarPose lookUpPose(const tf2::BufferCore& tf, const std::string& reference,
                      const std::string& frame, const ros::Time& time) {
  if (reference == frame) return {};
  const auto where = [&] {
    std::ostringstream text;
    text << "transform between \"" << reference << "\" and \"" << frame << "\" at " << time << ": ";
    return text.str();
  };
  try {
    return project(tf.lookupTransform(reference, frame, time).transform);
  } catch (const std::domain_error& error) {
    throw TransformError(where() + error.what());
  } catch (const std::exception& error) {
    // tf2's own, and std::runtime_error for times too far from those that tf2 knows
    throw TransformError(where() + error.what() + " (" +
                         newestText(newestTransform(tf, reference, frame)) + ")");
  }
}

bool canLookUpPose(const tf2::BufferCore& tf, const std::string& reference,
                   const std::string& frame, const ros::Time& time) try {
  return reference == frame || tf.canTransform(reference, frame, time);
} catch (const std::exception&) {
  return false;
}

std::optional<ros::Time> newestTransform(const tf2::BufferCore& tf, const std::string& reference,
                                         const std::string& frame) try {
  if (reference == frame) return ros::Time(0);
  return tf.lookupTransform(reference, frame, ros::Time(0)).header.stamp;
} catch (const std::exception&) {
  return std::nullopt;
}

}  // namespace footprint_collision_predictor
