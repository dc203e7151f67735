#include "warning_publisher.hpp"

#include <ros/console.h>

#include <random>
#include <sstream>

#include "findings.hpp"
#include "moment.hpp"

namespace footprint_collision_predictor {
namespace {

// Bounds the memory a consumer that does not read can take. More than one, so that two messages in
// a burst both arrive.
constexpr std::uint32_t kQueueSize = 100;

std::string described(const CollisionWarning& warning) {
  static const char* const kNames[] = {"UNKNOWN", "CLEAR", "WARN", "CRITICAL"};
  std::ostringstream text;
  text << kNames[warning.level];
  if (warning.collision_predicted != 0)
    text << ": contact in " << warning.time_to_collision << " s, segment " << warning.segment
         << ", obstacle " << warning.obstacle_id;
  if (!warning.message.empty()) text << ": " << warning.message;
  return text.str();
}

void log(const CollisionWarning& warning) {
  if (warning.level == CollisionWarning::CLEAR)
    ROS_INFO_STREAM(described(warning));
  else
    ROS_WARN_STREAM(described(warning));
}

}  // namespace

WarningPublisher::WarningPublisher(ros::NodeHandle& node)
    : publisher_(node.advertise<CollisionWarning>("collision_warning", kQueueSize)),
      last_time_(ros::SteadyTime::now()) {
  last_.session = std::random_device{}();
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
  logChange(warning);
  publisher_.publish(warning);
  last_ = std::move(warning);
  last_time_ = ros::SteadyTime::now();
}

/// A new level is told at once; new reasons for the same level at most once a second.
void WarningPublisher::logChange(const CollisionWarning& warning) {
  const ros::SteadyTime now = ros::SteadyTime::now();
  const bool quiet = secondsBetween(logged_time_, now) > 1;
  const bool first = logged_time_.isZero();
  if (!first && warning.level == logged_.level && (warning.reason == logged_.reason || !quiet))
    return;
  log(warning);
  logged_ = warning;
  logged_time_ = now;
}

CollisionWarning WarningPublisher::last() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return last_;
}

}  // namespace footprint_collision_predictor
