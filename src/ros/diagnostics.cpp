#include "diagnostics.hpp"

#include <ros/console.h>

#include "diagnostic_texts.hpp"
#include "moment.hpp"

namespace footprint_collision_predictor {
namespace {

constexpr double kOldReport = 1;  // [s] The worker reports many times as often.

}  // namespace

Diagnostics::Diagnostics(ros::NodeHandle& node, ros::NodeHandle& private_node,
                         const Sources& sources, const Report& first)
    : sources_(sources), report_(first), updater_(node, private_node, private_node.getNamespace()) {
  updater_.setHardwareID("none");
  updater_.add("collision", [this](Status& status) { describe(sources_.warnings.last(), status); });
  updater_.add("master", [this](Status& status) { describe(sources_.master.view(), status); });
  updater_.add("configuration",
               [this](Status& status) { describe(sources_.reconfiguration.report(), status); });
  add("obstacles", [](const Report& r, Status& status) { describe(r.obstacles, status); });
  if (first.footprint)
    add("footprint", [](const Report& r, Status& status) { describe(*r.footprint, status); });
  if (first.odometry)
    add("odom", [](const Report& r, Status& status) { describe(*r.odometry, status); });
  add("transforms", describeTransforms);
  add("computation",
      [](const Report& r, Status& status) { describe(r.computation, r.max_data_age, status); });
  add("clock", [](const Report& r, Status& status) { describe(r.clock, status); });
  timer_ = node.createWallTimer(ros::WallDuration(updater_.getPeriod()),
                                [this](const ros::WallTimerEvent&) { publish(); });
}

void Diagnostics::update(const Report& report) {
  const std::lock_guard<std::mutex> lock(mutex_);
  report_ = report;
}

void Diagnostics::add(const std::string& name, const Describe& describe) {
  updater_.add(name, [this, describe](Status& status) {
    const std::lock_guard<std::mutex> lock(mutex_);
    describe(report_, status);
    const double age = secondsBetween(report_.made, ros::SteadyTime::now());
    if (age > kOldReport)
      status.summaryf(diagnostic_msgs::DiagnosticStatus::ERROR,
                      "no evaluation has come round for %.1f s: the machine or node is overloaded",
                      age);
  });
}

/// A ~diagnostic_period that is changed to nonsense at run time makes the updater throw.
void Diagnostics::publish() try { updater_.force_update(); } catch (const std::exception& error) {
  ROS_ERROR_STREAM_THROTTLE(60, "no diagnostics: " << error.what() << " (~diagnostic_period?)");
}

}  // namespace footprint_collision_predictor
