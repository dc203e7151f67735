#include "waiting_queue.hpp"

#include "input_findings.hpp"
#include "planar_pose.hpp"

namespace footprint_collision_predictor {
namespace {

constexpr std::size_t kCapacity = 100;

/// Will be refused, whatever comes.
bool isHopeless(const std_msgs::Header& header) {
  return header.stamp.isZero() || header.frame_id.empty();
}

}  // namespace

WaitingQueue::WaitingQueue(const Parameters& parameters, const Body& body,
                           const tf2::BufferCore& tf, const OdometryHistory& odometry)
    : parameters_(parameters), body_(body), tf_(tf), odometry_(odometry) {}

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
  if (const auto* obstacles = std::get_if<ObstacleArray>(&waiting.message))
    return isHopeless(obstacles->header) ||
           (leadOf(obstacles->header.stamp, waiting.arrived, now) <= kLargestLead &&
            isPlaced(obstacles->header, now) && hasMotion(obstacles->header.stamp));
  if (const auto* footprint = std::get_if<geometry_msgs::PolygonStamped>(&waiting.message))
    return isHopeless(footprint->header) || isPlaced(footprint->header, now);
  return true;
}

bool WaitingQueue::isPlaced(const std_msgs::Header& header, const Moment& now) const {
  const bool clock_started = !now.ros.isZero();
  return clock_started && canLookUpPose(tf_, header.frame_id, body_.frame, header.stamp);
}

bool WaitingQueue::hasMotion(const ros::Time& stamp) const {
  const bool by_tf = body_.motion == BodyMotion::kTf;
  if (by_tf && !canLookUpPose(tf_, parameters_.fixed_frame, body_.frame, stamp)) return false;
  if (!needsOdometry(parameters_, body_)) return true;
  if (!odometry_.reaches(stamp)) return false;
  const auto sample = odometry_.at(stamp);
  return !sample || canLookUpPose(tf_, body_.frame, sample->frame, stamp);
}

}  // namespace footprint_collision_predictor
