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
  std::ostringstream text;
  text << (warning.level == CollisionWarning::CRITICAL ? "CRITICAL" : "WARN") << ": contact in "
       << warning.time_to_collision << " s, segment " << warning.segment << ", obstacle "
       << warning.obstacle_id << (warning.message.empty() ? "" : "; ") << warning.message;
  return text.str();
}

void log(const CollisionWarning& warning) {
  if (warning.level == CollisionWarning::CLEAR)
    ROS_INFO_STREAM("CLEAR" << (warning.message.empty() ? "" : ": ") << warning.message);
  else if (warning.level == CollisionWarning::UNKNOWN)
    ROS_WARN_STREAM("UNKNOWN: " << warning.message);
  else
    ROS_WARN_STREAM(described(warning));
}

}  // namespace

WarningPublisher::WarningPublisher(ros::NodeHandle& node)
    : publisher_(node.advertise<CollisionWarning>("collision_warning", kQueueSize)),
      last_time_(ros::SteadyTime::now()) {
  last_.session = std::random_device{}();
}

void WarningPublisher::publish(CollisionWarning warning) {
  const std::lock_guard<std::mutex> lock(mutex_);
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

void WarningPublisher::publishAgain() {
  CollisionWarning again = last();
  again.data_age += silence();
  publish(std::move(again));
}

double WarningPublisher::silence() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return secondsBetween(last_time_, ros::SteadyTime::now());
}

CollisionWarning WarningPublisher::last() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return last_;
}

}  // namespace footprint_collision_predictor
