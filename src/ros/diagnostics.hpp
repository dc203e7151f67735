// The node's entry in /diagnostics.
#pragma once

#include <diagnostic_updater/diagnostic_updater.h>

#include "warning_publisher.hpp"

namespace footprint_collision_predictor {

class Diagnostics {
 public:
  /// \param warnings outlives this
  Diagnostics(ros::NodeHandle& node, ros::NodeHandle& private_node,
              const WarningPublisher& warnings);

 private:
  void describe(diagnostic_updater::DiagnosticStatusWrapper& status) const;

  const WarningPublisher& warnings_;
  diagnostic_updater::Updater updater_;
  ros::WallTimer timer_;  // by wall time, so that it goes on when a simulated clock stands still
};

}  // namespace footprint_collision_predictor
