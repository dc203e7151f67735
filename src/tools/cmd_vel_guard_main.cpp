// cmd_vel_guard: an example of a consumer of collision warnings, to copy from. Hands velocity
// commands on while it is safe to go on, and commands a stop otherwise.
//
// cmd_vel_in -> cmd_vel, by collision_warning. It stops at CRITICAL and whenever anything is
// unknown; when it ends itself, the base must stop by its own time-out, as for any source of
// commands.
#include <geometry_msgs/Twist.h>
#include <ros/ros.h>

#include "footprint_collision_predictor/ros/warning_watchdog.hpp"

namespace {

using footprint_collision_predictor::CollisionWarning;
using footprint_collision_predictor::WarningWatchdog;

// [s] While it is not safe, a stop is commanded so often, whether commands come or not.
constexpr double kPeriod = 0.02;

// Those of one robot come one right after another on one topic; a shorter queue would drop some.
constexpr std::uint32_t kMostFootprints = 20;

/// All callbacks come from one ros::spin(), so the watchdog needs no lock.
class CmdVelGuard {
 public:
  CmdVelGuard() {
    // What matters is the newest; of warnings, that of each footprint. The steady timer goes on
    // when simulated time stops.
    const auto fast = ros::TransportHints().tcpNoDelay();
    command_ = node_.advertise<geometry_msgs::Twist>("cmd_vel", 1);
    warnings_ = node_.subscribe("collision_warning", kMostFootprints, &CmdVelGuard::takeWarning,
                                this, fast);
    commands_ = node_.subscribe("cmd_vel_in", 1, &CmdVelGuard::handOn, this, fast);
    timer_ = node_.createSteadyTimer(ros::WallDuration(kPeriod), &CmdVelGuard::watch, this);
  }

 private:
  void takeWarning(const CollisionWarning& warning) {
    watchdog_.take(warning, ros::Time::now(), ros::SteadyTime::now());
    stopUnlessSafe();
  }

  void handOn(const geometry_msgs::Twist& command) {
    if (stopUnlessSafe()) command_.publish(command);
  }

  void watch(const ros::SteadyTimerEvent&) { stopUnlessSafe(); }

  bool stopUnlessSafe() {
    const WarningWatchdog::Answer answer = watchdog_.safeToGoOn(ros::SteadyTime::now());
    if (!answer.safe) {
      command_.publish(geometry_msgs::Twist());
      ROS_WARN_STREAM_COND(safe_, "stopping: " << answer.why);
    }
    ROS_INFO_STREAM_COND(answer.safe && !safe_, "safe to go on");
    safe_ = answer.safe;
    return safe_;
  }

  ros::NodeHandle node_;
  WarningWatchdog watchdog_;
  bool safe_ = true;  // so that the reason for the first stop is told
  ros::Publisher command_;
  ros::Subscriber warnings_;
  ros::Subscriber commands_;
  ros::SteadyTimer timer_;
};

}  // namespace

int main(int argc, char** argv) {
  ros::init(argc, argv, "cmd_vel_guard");
  const CmdVelGuard guard;
  ros::spin();
  return 0;
}
