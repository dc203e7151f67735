// What is known of the inputs: their newest good values, their ages, and what is wrong with them.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "clock_monitor.hpp"
#include "findings.hpp"
#include "input_record.hpp"
#include "input_report.hpp"
#include "moment.hpp"
#include "motion_source.hpp"
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
  /// \param body whose footprint and motion they are
  Inputs(const Parameters& parameters, const Body& body, const InputNames& names,
         bool simulated_clock);

  /// \param parameters of which only those may differ that can be changed live
  void reconfigure(const Parameters& parameters);

  /// A looped recording or restarted simulator: all that belongs to the old time goes.
  /// \return whether the clock has jumped back since the last call
  bool forgetIfClockJumpedBack(const Moment& now);

  /// For every message that comes, before anything is known of it.
  void receive(InputKind kind, const RawMessage& message, const Moment& now);

  /// Stamp and arrival of a good obstacles message, which ends what was wrong with earlier ones.
  void acceptObstacles(const Moment& stamp_and_arrival);
  void acceptFootprint(const core::Polygon& footprint, const Moment& stamp_and_arrival);
  /// One older than the newest is ignored and counted.
  void acceptOdometry(const OdometrySample& sample);

  /// Until the next good message of that input.
  void refuse(InputKind kind, const Findings& why, const Moment& now);
  /// For a message older than the newest.
  Findings ignoreObstacles() { return obstacles_.ignore(); }

  /// \param publishers_of the nodes that the master knows as publishers of a topic
  using PublishersOf = std::function<std::vector<std::string>(const std::string& topic)>;
  void setRegistered(const PublishersOf& publishers_of);

  /// Stamp and arrival of the newest good obstacles message.
  const std::optional<Moment>& newest() const { return obstacles_.newest(); }
  const std::optional<core::Polygon>& footprint() const { return footprint_; }
  const OdometryHistory& odometry() const { return odometry_; }

  /// What is missing, was refused, or comes from several nodes.
  Findings standing(const Moment& now) const;
  /// What is too old, and what is wrong with the clock: nothing can be told from such inputs.
  /// \param used the motion that the obstacles are evaluated with, if any
  Findings tooOld(const Moment& now, const MotionSource& used) const;
  /// [s] of the oldest input; infinite before the first obstacles message.
  double age(const Moment& now, const MotionSource& used) const;

  /// What one input is like by itself.
  InputReport report(InputKind kind, const Moment& now) const;
  ClockReport clockReport(const Moment& now) const { return clock_.report(now); }

 private:
  const InputRecord& record(InputKind kind) const;
  InputRecord& record(InputKind kind);
  Findings missing(InputKind kind) const;
  Findings standing(InputKind kind, const Moment& now) const;
  double ageOf(const ros::Time& stamp, const ros::SteadyTime& arrived, const Moment& now) const;
  double ageOf(const InputRecord& input, const Moment& now) const;
  double odometryAge(const Moment& now, const std::optional<OdometrySample>& sample) const;
  static double transformsAge(const Moment& now, const MotionSource& used);

  Parameters parameters_;
  const Body& body_;
  ClockMonitor clock_;
  bool clock_started_ = false;
  InputRecord obstacles_;
  InputRecord footprints_;
  InputRecord odometries_;
  std::optional<core::Polygon> footprint_;
  OdometryHistory odometry_;
  Findings out_of_order_;  // that odometry was ignored, until good odometry comes
  Findings jump_;          // that the clock was set back, until obstacles of the new time come
};

}  // namespace footprint_collision_predictor
