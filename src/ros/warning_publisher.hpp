// Sends the warnings, from whichever thread has one.
#pragma once

#include <ros/node_handle.h>
#include <ros/publisher.h>

#include <mutex>

#include "footprint_collision_predictor/CollisionWarning.h"

namespace footprint_collision_predictor {

/// Thread-safe. Fills in `sequence` and `session`, and logs every change of level and of reasons.
class WarningPublisher {
 public:
  explicit WarningPublisher(ros::NodeHandle& node);

  void publish(CollisionWarning warning);
  /// Sends the last one once more, with the age that its data have by now.
  void publishAgain();
  /// [s] of steady time since the last one went out.
  double silence() const;
  CollisionWarning last() const;

 private:
  void logChange(const CollisionWarning& warning);

  mutable std::mutex mutex_;
  ros::Publisher publisher_;
  CollisionWarning last_;
  ros::SteadyTime last_time_;
  CollisionWarning logged_;
  ros::SteadyTime logged_time_;
};

}  // namespace footprint_collision_predictor
