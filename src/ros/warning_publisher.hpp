// Sends the warnings, from whichever thread has one.
#pragma once

#include <ros/node_handle.h>
#include <ros/publisher.h>

#include <cstdint>
#include <functional>
#include <mutex>

#include "footprint_collision_predictor/CollisionWarning.h"
#include "warning_log.hpp"

namespace footprint_collision_predictor {

/// For one footprint; several share the topic. Thread-safe. Fills in `sequence` and `session`, and
/// logs changes of level and of reasons.
class WarningPublisher {
 public:
  /// \param first counts as the last one until there is another
  WarningPublisher(ros::NodeHandle& node, std::uint32_t session, CollisionWarning first);

  void publish(const CollisionWarning& warning);

  /// What to send instead, given the last one and for how long [s] none has gone out.
  using Substitute = std::function<CollisionWarning(const CollisionWarning& last, double silence)>;
  /// Sends the substitute when none has gone out for this long [s] of steady time.
  void publishIfSilent(double seconds, const Substitute& substitute);
  CollisionWarning last() const;

 private:
  void send(CollisionWarning warning);

  mutable std::mutex mutex_;
  ros::Publisher publisher_;
  CollisionWarning last_;
  ros::SteadyTime last_time_;
  WarningLog log_;
};

}  // namespace footprint_collision_predictor
