// What is known of the inputs: their newest good values, their ages, and what is wrong with them.
#pragma once

#include <optional>
#include <string>

#include "clock_monitor.hpp"
#include "findings.hpp"
#include "moment.hpp"
#include "odometry_history.hpp"
#include "parameters.hpp"

namespace footprint_collision_predictor {

/// Topic names as texts to people give them.
struct InputNames {
  std::string obstacles;
  std::string footprint;
  std::string odom;
};

class Inputs {
 public:
  Inputs(const Parameters& parameters, const InputNames& names, bool simulated_clock);

  /// A looped recording or restarted simulator: all that belongs to the old time goes.
  /// \return whether the clock has jumped back since the last call
  bool forgetIfClockJumpedBack(const Moment& now);

  /// Stamp and arrival of a good obstacles message, which ends what was wrong with earlier ones.
  void acceptObstacles(const Moment& stamp_and_arrival);
  void acceptFootprint(const core::Polygon& footprint);
  /// One older than the newest is ignored and counted.
  void acceptOdometry(const OdometrySample& sample);

  /// Until the next good message of that input.
  void refuseObstacles(const Findings& why) { obstacles_refusal_ = why; }
  void refuseFootprint(const Findings& why) { footprint_refusal_ = why; }
  void refuseOdometry(const Findings& why) { odometry_refusal_ = why; }
  /// For a message older than the newest.
  Findings ignoreObstacles();

  /// Stamp and arrival of the newest good obstacles message.
  const std::optional<Moment>& newest() const { return newest_; }
  const std::optional<core::Polygon>& footprint() const { return footprint_; }
  const OdometryHistory& odometry() const { return odometry_; }

  /// What is missing or was refused.
  Findings standing() const;
  /// What is too old, and what is wrong with the clock: nothing can be told from such inputs.
  /// \param used the odometry that the obstacles are evaluated with, if any
  Findings tooOld(const Moment& now, const std::optional<OdometrySample>& used) const;
  /// [s] of the oldest input; infinite before the first obstacles message.
  double age(const Moment& now, const std::optional<OdometrySample>& used) const;

 private:
  double ageOf(const ros::Time& stamp, const ros::SteadyTime& arrived, const Moment& now) const;
  double obstaclesAge(const Moment& now) const;
  double odometryAge(const Moment& now, const std::optional<OdometrySample>& sample) const;

  const Parameters parameters_;
  const InputNames names_;
  ClockMonitor clock_;
  bool clock_started_ = false;
  std::optional<Moment> newest_;
  std::optional<core::Polygon> footprint_;
  OdometryHistory odometry_;
  Findings obstacles_refusal_;
  Findings footprint_refusal_;
  Findings odometry_refusal_;
  Findings jump_;  // that the clock was set back, until obstacles of the new time come
  std::size_t ignored_obstacles_ = 0;
  std::size_t ignored_odometry_ = 0;
};

}  // namespace footprint_collision_predictor
