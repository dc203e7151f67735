// From messages to warnings: everything the node knows, without the node. It is driven by whoever
// has messages and clocks (a live node, or a recording), one call at a time. A robot of several
// bodies has one for each: so none waits for, or is held up by, what another lacks.
#pragma once

#include <tf2/buffer_core.h>
#include <visualization_msgs/MarkerArray.h>

#include <functional>
#include <optional>

#include "inputs.hpp"
#include "level_state.hpp"
#include "message_decoding.hpp"
#include "moment.hpp"
#include "parameters.hpp"
#include "report.hpp"
#include "scene.hpp"
#include "waiting_queue.hpp"
#include "warning_message.hpp"

namespace footprint_collision_predictor {

/// What one obstacles message gives: always a warning, and a prediction when it could be evaluated.
struct Answer {
  CollisionWarning warning;
  std::optional<CollisionPrediction> prediction;
  Moment now;  ///< that the answer speaks of; the evaluation took place after it
};

/// Not thread-safe. `sequence` and `session` of the warnings are left to the publisher.
class Pipeline {
 public:
  using Publish = std::function<void(const Answer&)>;

  Pipeline(const Parameters& parameters, const Body& body, const InputNames& names,
           tf2::BufferCore& tf, bool simulated_clock, Publish publish);
  Pipeline(const Pipeline&) = delete;  // its parts know each other
  Pipeline& operator=(const Pipeline&) = delete;

  const Body& body() const { return body_; }

  /// Takes effect with the next obstacles message, so that no evaluation mixes old and new; at once
  /// when nothing is being predicted.
  /// \param parameters of which only those may differ that can be changed live
  void reconfigure(const Parameters& parameters) { pending_ = parameters; }

  void receiveObstacles(const RawMessage& message, const Moment& now);
  void receiveFootprint(const RawMessage& message, const Moment& now);
  void receiveOdometry(const RawMessage& message, const Moment& now);

  /// Evaluates what has waited long enough, in order.
  void process(const Moment& now);
  bool isWaiting() const { return !queue_.empty(); }

  /// Of the last good obstacles message: within Publish, what its prediction was made of.
  const std::optional<Scene>& scene() const { return scene_; }

  /// The warning as of now, between messages: robot and obstacles are carried on from their stamp.
  CollisionWarning repeat(const Moment& now);

  /// \param publishers_of the nodes that the master knows as publishers of a topic
  void setRegistered(const Inputs::PublishersOf& publishers_of) {
    inputs_.setRegistered(publishers_of);
  }
  Report report(const Moment& now) const;
  /// What RViz shows of that warning. It is predicted once more for it.
  visualization_msgs::MarkerArray picture(const CollisionWarning& repeated,
                                          const Moment& now) const;

 private:
  void adoptPending();
  void watchClock(const Moment& now);
  void take(const Waiting& waiting, const Moment& now);
  void evaluate(const ObstacleArray& message, const Moment& arrived, const Moment& now);
  void adopt(const geometry_msgs::PolygonStamped& message, const Moment& arrived,
             const Moment& now);
  void refuse(const Findings& why, const Moment& now);
  TransformReport transformReport(const Moment& now) const;

  MotionSource motion() const { return scene_ ? scene_->motion : MotionSource(); }
  CollisionWarning warningNow(const Moment& now, Counts counts, Findings findings = {});
  CollisionWarning warning(const Evaluated* evaluated, const ros::Time& stamp, Findings& findings,
                           const Moment& now, Counts counts);

  Parameters parameters_;
  std::optional<Parameters> pending_;
  const Body body_;
  const InputNames names_;
  tf2::BufferCore& tf_;
  const Publish publish_;

  const bool simulated_clock_;
  Inputs inputs_;
  LevelState level_;
  WaitingQueue queue_;
  std::optional<Scene> scene_;   // of the last good obstacles message
  std::string obstacles_frame_;  // of the last one, good or not
  double waited_ = 0;            // [s] that it waited for its transform and odometry
};

}  // namespace footprint_collision_predictor
