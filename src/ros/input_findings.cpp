#include "input_findings.hpp"

#include <cmath>
#include <iomanip>
#include <sstream>

#include "footprint_collision_predictor/motion.hpp"

namespace footprint_collision_predictor {
namespace {

template <typename... Parts>
std::string join(const Parts&... parts) {
  std::ostringstream text;
  text << std::setprecision(3);
  (text << ... << parts);
  return text.str();
}

std::string duration(double seconds) {
  constexpr double kYear = 365.25 * 86400;
  if (seconds < 7200) return join(seconds, " s");
  return seconds < kYear ? join(seconds / 3600, " hours") : join(seconds / kYear, " years");
}

/// A zero stamp, or one ahead of the clock.
Findings impossibleStamp(const ros::Time& stamp, double lead, double largest_lead,
                         const std::string& topic) {
  Findings findings;
  if (stamp.isZero())
    findings.add(CollisionWarning::REASON_STAMP,
                 "the message on " + topic + " has stamp 0: its source must stamp its messages");
  else if (lead > largest_lead)
    findings.add(CollisionWarning::REASON_STAMP,
                 "the message on " + topic + " is stamped " + duration(lead) +
                     " ahead of the clock: synchronise the machines' clocks; when replaying fast, "
                     "use rosbag play --clock --hz 1000");
  return findings;
}

}  // namespace

Findings refusal(const InputReasons& input, std::uint32_t reason, const std::string& why) {
  Findings findings;
  findings.add(reason, "the message on " + input.topic + " is refused: " + why);
  return findings;
}

double leadOf(const ros::Time& stamp, const Moment& arrived, const Moment& now) {
  const double lead = secondsBetween(now.ros, stamp);
  return arrived.ros.isZero() ? lead : lead + secondsBetween(arrived.steady, now.steady);
}

Findings headerFindings(const std_msgs::Header& header, const Moment& arrived, const Moment& now,
                        double max_data_age, const std::string& topic) {
  const ros::Time clock = arrived.ros.isZero() ? now.ros : arrived.ros;
  Findings findings;
  if (header.frame_id.empty())
    findings.add(
        CollisionWarning::REASON_OBSTACLES_INVALID | CollisionWarning::REASON_TRANSFORM,
        "the message on " + topic + " has an empty frame_id: its source must name a frame");
  if (clock.isZero() && !header.stamp.isZero()) {
    findings.add(CollisionWarning::REASON_CLOCK,
                 "a message came on " + topic +
                     " before the simulated clock started: play the "
                     "recording with --clock, or set /use_sim_time to false");
    return findings;
  }
  findings.add(
      impossibleStamp(header.stamp, leadOf(header.stamp, arrived, now), kLargestLead, topic));
  const double age = secondsBetween(header.stamp, clock);
  if (!header.stamp.isZero() && age > max_data_age)
    findings.add(CollisionWarning::REASON_OBSTACLES_STALE,
                 "the message on " + topic + " was " + duration(age) +
                     " old when it came (~max_data_age " + duration(max_data_age) +
                     "): replaying? use rosbag play --clock and set /use_sim_time to true");
  return findings;
}

Findings odometryFindings(const nav_msgs::Odometry& odometry, const Moment& now,
                          double largest_lead, const std::string& topic) {
  const auto usable = [](double rate) { return std::abs(rate) <= core::kMaxRate; };  // not for NaN
  const auto& twist = odometry.twist.twist;
  Findings findings;
  if (!(usable(twist.linear.x) && usable(twist.linear.y) && usable(twist.angular.z)))
    findings.add(CollisionWarning::REASON_ODOM_INVALID,
                 join("the message on ", topic, " is refused: its twist (", twist.linear.x, ", ",
                      twist.linear.y, ", ", twist.angular.z, ") must be finite and at most ",
                      core::kMaxRate));
  if (odometry.header.stamp.isZero() || !now.ros.isZero())
    findings.add(impossibleStamp(odometry.header.stamp,
                                 secondsBetween(now.ros, odometry.header.stamp), largest_lead,
                                 topic));
  return findings;
}

std::string staleText(const std::string& topic, double age, double max_data_age) {
  return join("the newest usable message on ", topic, " is ", duration(age), " old (~max_data_age ",
              duration(max_data_age), "): is its source running?");
}

std::string oldTransformsText(const std::string& fixed_frame, const std::string& frame, double age,
                              double max_data_age) {
  return join("the newest transform between \"", fixed_frame, "\" and \"", frame, "\" is ",
              duration(age), " old (~max_data_age ", duration(max_data_age),
              "), so that the motion of \"", frame, "\" is not known: is its source running?");
}

std::string ignoredText(const std::string& topic, std::size_t so_far) {
  return join("a message on ", topic, " older than the newest was ignored (", so_far,
              " so far): do several sources publish there?");
}

}  // namespace footprint_collision_predictor
