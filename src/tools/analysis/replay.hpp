// Feeds a recording to the pipeline of the live node, with the time of the recording as its clocks.
#pragma once

#include <tf2/buffer_core.h>

#include <deque>
#include <functional>
#include <optional>
#include <string>

#include "pipeline.hpp"
#include "recording.hpp"

namespace footprint_collision_predictor::tools {

/// What the live node would have said, and when.
struct Evaluation {
  double elapsed;  ///< [s] since the window's begin, by the time of recording
  bool silence;    ///< not for an obstacles message: that none came is what it is about
  Answer answer;
  const Scene* scene = nullptr;  ///< what the answer's prediction was made of; null without one
};

/// Place of the obstacle that is touched first in its message; -1: none, or not known.
std::int32_t obstacleIndexOf(const Answer& answer);

class Replay {
 public:
  using Take = std::function<void(const Evaluation&)>;

  Replay(const Parameters& parameters, const Body& body, const InputNames& names,
         const Window& window, Take take);

  /// In the order of recording. Obstacles before the window are passed over.
  void take(const RecordedMessage& message);
  /// Nothing more comes until then.
  void finish(const ros::Time& end);

  /// Transforms that tf2 refused, such as those older than what it keeps.
  std::size_t refusedTransforms() const { return refused_transforms_; }

 private:
  Moment momentAt(const ros::Time& recorded) const;
  void catchUp(const ros::Time& until);
  void sayNothingCame(const ros::Time& when);
  void publish(const Answer& answer, bool silence);
  void receive(void (Pipeline::*input)(const RawMessage&, const Moment&),
               const RecordedMessage& message);
  void takeTransforms(const RecordedMessage& message, bool fixed);
  void takeClock(const RecordedMessage& message);

  const Window window_;
  const ros::Duration patience_;  // of a waiting message
  const ros::Duration silence_;   // after which it is said
  const Take take_;
  tf2::BufferCore tf_;
  Pipeline pipeline_;
  std::deque<ros::Time> due_;  // when waiting messages will have waited long enough
  std::optional<ros::Time> silent_at_;
  std::optional<bool> clock_differs_;
  ros::Time clock_;
  std::size_t refused_transforms_ = 0;
};

}  // namespace footprint_collision_predictor::tools
