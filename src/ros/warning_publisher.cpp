#include "warning_publisher.hpp"

#include <ros/console.h>

#include <utility>

#include "moment.hpp"

namespace footprint_collision_predictor {
namespace {

// Bounds the memory a consumer that does not read can take. More than one, so that two messages in
// a burst both arrive.
constexpr std::uint32_t kQueueSize = 100;

void log(const LogLine& line) {
  if (line.is_good_news)
    ROS_INFO_STREAM(line.text);
  else
    ROS_WARN_STREAM(line.text);
}

}  // namespace

WarningPublisher::WarningPublisher(ros::NodeHandle& node, std::uint32_t session,
                                   CollisionWarning first)
    : publisher_(node.advertise<CollisionWarning>("collision_warning", kQueueSize)),
      last_(std::move(first)),
      last_time_(ros::SteadyTime::now()) {
  last_.session = session;
}

void WarningPublisher::publish(const CollisionWarning& warning) {
  const std::lock_guard<std::mutex> lock(mutex_);
  send(warning);
}

void WarningPublisher::publishIfSilent(double seconds, const Substitute& substitute) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const double silence = secondsBetween(last_time_, ros::SteadyTime::now());
  if (silence >= seconds) send(substitute(last_, silence));
}

void WarningPublisher::send(CollisionWarning warning) {
  warning.session = last_.session;
  warning.sequence = last_.sequence + 1;
  publisher_.publish(warning);
  last_time_ = ros::SteadyTime::now();
  if (const auto line = log_.update(warning, last_time_)) log(*line);
  last_ = std::move(warning);
}

CollisionWarning WarningPublisher::last() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return last_;
}

}  // namespace footprint_collision_predictor
