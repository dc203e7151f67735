// Notices a ROS clock that has not started, stands still, or jumps back.
#pragma once

#include "findings.hpp"
#include "moment.hpp"

namespace footprint_collision_predictor {

class ClockMonitor {
 public:
  /// \param simulated whether the ROS clock is /clock; only such a clock can stand still
  /// \param longest_stop [s] of steady time for which it may
  ClockMonitor(bool simulated, double longest_stop);

  /// \return true when the ROS clock has jumped back since the last call
  bool jumpedBack(const Moment& now);
  Findings findings(const Moment& now) const;
  bool isSimulated() const { return simulated_; }

 private:
  bool simulated_;
  double longest_stop_;
  Moment last_advance_;
};

}  // namespace footprint_collision_predictor
