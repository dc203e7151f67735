#include "waiting_queue.hpp"

#include "planar_pose.hpp"

namespace footprint_collision_predictor {
namespace {

constexpr std::size_t kCapacity = 100;

}  // namespace

const std_msgs::Header& Waiting::header() const {
  return std::visit([](const auto& m) -> const std_msgs::Header& { return m.header; }, message);
}

WaitingQueue::WaitingQueue(const Parameters& parameters, const tf2::BufferCore& tf,
                           const OdometryHistory& odometry)
    : parameters_(parameters), tf_(tf), odometry_(odometry) {}

std::optional<Waiting> WaitingQueue::pop(const Moment& now) {
  if (queue_.empty()) return std::nullopt;
  const bool expired =
      secondsBetween(queue_.front().arrived.steady, now.steady) >= parameters_.transform_tolerance;
  if (!expired && queue_.size() <= kCapacity && !isReady(queue_.front(), now)) return std::nullopt;
  Waiting first = std::move(queue_.front());
  queue_.pop_front();
  return first;
}

bool WaitingQueue::isReady(const Waiting& waiting, const Moment& now) const {
  const std_msgs::Header& header = waiting.header();
  if (header.stamp.isZero() || header.frame_id.empty()) return true;  // will be refused
  if (now.ros.isZero()) return false;  // a simulated clock that has not started
  if (!canLookUpPose(tf_, header.frame_id, parameters_.base_frame, header.stamp)) return false;
  return std::holds_alternative<geometry_msgs::PolygonStamped>(waiting.message) ||
         hasMotion(header.stamp);
}

bool WaitingQueue::hasMotion(const ros::Time& stamp) const {
  if (parameters_.ego_motion == EgoMotion::kStatic) return true;
  if (!odometry_.reaches(stamp)) return false;
  const auto sample = odometry_.at(stamp);
  return !sample || canLookUpPose(tf_, parameters_.base_frame, sample->frame, stamp);
}

}  // namespace footprint_collision_predictor
