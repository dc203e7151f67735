#include "frame_motion.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace footprint_collision_predictor {
namespace {

/// x cot(x), also where x is 0.
double timesCotangent(double x) {
  return std::abs(x) < 1e-4 ? 1 - x * x / 3 : x / std::tan(x);  // the next term is x^4 / 45
}

bool isUsable(const core::Twist& twist) {
  const auto usable = [](double rate) { return std::abs(rate) <= core::kMaxRate; };  // not for NaN
  return usable(twist.linear.x()) && usable(twist.linear.y()) && usable(twist.angular);
}

}  // namespace

core::Twist twistBetween(const PlanarPose& from, const PlanarPose& to, double seconds) {
  const core::Vec2 way = from.pointToLocal(to.position);
  const core::Vec2 axis = from.vectorToLocal(to.x_axis);
  const double half = std::atan2(axis.y(), axis.x()) / 2;
  return {(timesCotangent(half) * way - half * core::leftNormal(way)) / seconds,
          2 * half / seconds};
}

FrameMotion frameMotion(const tf2::BufferCore& tf, const std::string& fixed_frame,
                        const std::string& frame, const ros::Time& stamp) {
  const auto newest = newestTransform(tf, fixed_frame, frame);
  const bool ends_before = newest && !newest->isZero() && *newest < stamp;
  const ros::Time end = ends_before ? *newest : stamp;
  const ros::Duration interval(std::min(kMotionInterval, end.toSec() / 2));
  const PlanarPose from = lookUpPose(tf, fixed_frame, frame, end - interval);
  const PlanarPose to = lookUpPose(tf, fixed_frame, frame, end);
  const core::Twist twist = twistBetween(from, to, interval.toSec());
  if (isUsable(twist)) return {twist, end};
  std::ostringstream text;
  text << "transforms between \"" << fixed_frame << "\" and \"" << frame << "\" at " << end
       << " give a velocity of (" << twist.linear.x() << ", " << twist.linear.y() << ", "
       << twist.angular << "); it must be at most " << core::kMaxRate;
  throw TransformError(text.str());
}

}  // namespace footprint_collision_predictor
