#include "diagnostics.hpp"

namespace footprint_collision_predictor {

using diagnostic_msgs::DiagnosticStatus;

Diagnostics::Diagnostics(ros::NodeHandle& node, ros::NodeHandle& private_node,
                         const WarningPublisher& warnings)
    : warnings_(warnings), updater_(node, private_node) {
  updater_.setHardwareID("none");
  updater_.add("collision",
               [this](diagnostic_updater::DiagnosticStatusWrapper& status) { describe(status); });
  timer_ = node.createWallTimer(ros::WallDuration(updater_.getPeriod()),
                                [this](const ros::WallTimerEvent&) { updater_.force_update(); });
}

void Diagnostics::describe(diagnostic_updater::DiagnosticStatusWrapper& status) const {
  const CollisionWarning warning = warnings_.last();
  switch (warning.level) {
    case CollisionWarning::CLEAR:
      status.summary(DiagnosticStatus::OK, "clear");
      break;
    case CollisionWarning::WARN:
      status.summary(DiagnosticStatus::WARN, "contact ahead");
      break;
    case CollisionWarning::CRITICAL:
      status.summary(DiagnosticStatus::ERROR, "contact imminent");
      break;
    default:
      status.summary(DiagnosticStatus::ERROR, "unknown: " + warning.message);
  }
  status.add("time to collision [s]", warning.time_to_collision);
  status.add("clearance [m]", warning.clearance);
  status.add("data age [s]", warning.data_age);
  status.add("obstacles", warning.obstacle_count);
  status.add("message", warning.message);
}

}  // namespace footprint_collision_predictor
