// Messages that wait, in order, until their transforms and odometry can have come.
#pragma once

#include <geometry_msgs/PolygonStamped.h>
#include <tf2/buffer_core.h>

#include <deque>
#include <optional>
#include <string>
#include <variant>

#include "findings.hpp"
#include "footprint_collision_predictor/ObstacleArray.h"
#include "input_record.hpp"
#include "moment.hpp"
#include "odometry_history.hpp"
#include "parameters.hpp"

namespace footprint_collision_predictor {

/// A message that cannot be read. It waits its turn like the others, so that no earlier one undoes
/// it.
struct Refusal {
  Findings why;
  InputKind of;
};

struct Waiting {
  Moment arrived;
  std::variant<ObstacleArray, geometry_msgs::PolygonStamped, Refusal> message;
};

/// Bounded: when full, the oldest is handed out at once, with what is known by then.
class WaitingQueue {
 public:
  /// \param body whose frame and motion are waited for
  WaitingQueue(const Parameters& parameters, const Body& body, const tf2::BufferCore& tf,
               const OdometryHistory& odometry);

  void push(Waiting waiting) { queue_.push_back(std::move(waiting)); }
  /// The first message, when all it needs has come, or transform_tolerance has passed by the steady
  /// clock since it arrived.
  std::optional<Waiting> pop(const Moment& now);
  bool empty() const { return queue_.empty(); }
  void clear() { queue_.clear(); }

 private:
  bool isReady(const Waiting& waiting, const Moment& now) const;
  bool isPlaced(const std_msgs::Header& header, const Moment& now) const;
  bool hasMotion(const ros::Time& stamp) const;

  const Parameters& parameters_;
  const Body& body_;
  const tf2::BufferCore& tf_;
  const OdometryHistory& odometry_;
  std::deque<Waiting> queue_;
};

}  // namespace footprint_collision_predictor
