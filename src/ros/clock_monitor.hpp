// Notices a ROS clock that has not started, stands still, or jumps back.
#pragma once

#include <cstdint>

#include "findings.hpp"
#include "moment.hpp"

namespace footprint_collision_predictor {

/// For the diagnostics.
struct ClockReport {
  bool simulated = false;
  ros::Time time;
  double standing_still = 0;  ///< [s] of steady time since the clock last advanced
  std::uint64_t jumps_back = 0;
  Findings findings;
};

class ClockMonitor {
 public:
  /// \param simulated whether the ROS clock is /clock; only such a clock can stand still
  /// \param longest_stop [s] of steady time for which it may
  ClockMonitor(bool simulated, double longest_stop);

  void setLongestStop(double seconds) { longest_stop_ = seconds; }
  /// \return true when the ROS clock has jumped back since the last call
  bool jumpedBack(const Moment& now);
  Findings findings(const Moment& now) const;
  ClockReport report(const Moment& now) const;
  bool isSimulated() const { return simulated_; }

 private:
  bool simulated_;
  double longest_stop_;
  Moment last_advance_;
  std::uint64_t jumps_back_ = 0;
};

}  // namespace footprint_collision_predictor
