// From messages to warnings: everything the node knows, without the node. It is driven by whoever
// has messages and clocks (a live node, or a recording), one call at a time.
#pragma once

#include <tf2/buffer_core.h>

#include <functional>
#include <optional>
#include <string>

#include "clock_monitor.hpp"
#include "message_decoding.hpp"
#include "moment.hpp"
#include "odometry_history.hpp"
#include "parameters.hpp"
#include "scene.hpp"
#include "waiting_queue.hpp"
#include "warning_message.hpp"

namespace footprint_collision_predictor {

/// Topic names as texts to people give them.
struct InputNames {
  std::string obstacles;
  std::string footprint;
  std::string odom;
};

/// Not thread-safe. `sequence` and `session` of the warnings are left to the publisher.
class Pipeline {
 public:
  /// What one obstacles message gives: always a warning, and a prediction when it could be
  /// evaluated.
  using Publish =
      std::function<void(const CollisionWarning&, const std::optional<CollisionPrediction>&)>;

  Pipeline(const Parameters& parameters, const InputNames& names, tf2::BufferCore& tf,
           bool simulated_clock, Publish publish);

  void receiveObstacles(const RawMessage& message, const Moment& now);
  void receiveFootprint(const RawMessage& message, const Moment& now);
  void receiveOdometry(const RawMessage& message, const Moment& now);

  /// Evaluates what has waited long enough, in order.
  void process(const Moment& now);
  bool isWaiting() const { return !queue_.empty(); }

  /// The warning as of now, between messages: robot and obstacles are carried on from their stamp.
  CollisionWarning repeat(const Moment& now);

 private:
  void watchClock(const Moment& now);
  void evaluate(const ObstacleArray& message, const Moment& arrived, const Moment& now);
  void adopt(const geometry_msgs::PolygonStamped& message);
  void refuse(const Findings& why, const Moment& now);

  CollisionWarning warningNow(const Moment& now, bool counts, Findings findings = {});
  CollisionWarning warning(const Evaluated* evaluated, const ros::Time& stamp, Findings& findings,
                           const Moment& now, bool counts);

  Findings stampFindings(const ros::Time& stamp, const Moment& arrived, const Moment& now) const;
  Findings standingFindings(const Moment& now) const;
  Findings staleness(const Moment& now) const;
  double ageOf(const ros::Time& stamp, const ros::SteadyTime& arrived, const Moment& now) const;
  double obstaclesAge(const Moment& now) const;
  double odometryAge(const Moment& now) const;

  const Parameters parameters_;
  const InputNames names_;
  tf2::BufferCore& tf_;
  const Publish publish_;

  ClockMonitor clock_;
  core::LevelHold hold_;
  OdometryHistory odometry_;
  WaitingQueue queue_;
  std::optional<core::Polygon> footprint_;
  std::optional<Scene> scene_;    // of the last good obstacles message
  std::optional<Moment> newest_;  // stamp and arrival of that message
  Findings obstacles_refusal_;    // why the newest message of a kind was refused, until a good one
  Findings footprint_refusal_;    // comes
  Findings odometry_refusal_;
  Findings jump_;  // that the clock jumped back, until a good obstacles message of the new time
  std::size_t ignored_obstacles_ = 0;  // messages older than the newest
  std::size_t ignored_odometry_ = 0;
};

}  // namespace footprint_collision_predictor
