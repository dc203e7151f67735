#include "replay.hpp"

#include <ros/serialization.h>
#include <rosgraph_msgs/Clock.h>
#include <tf2/exceptions.h>
#include <tf2_msgs/TFMessage.h>

#include <algorithm>
#include <cmath>

namespace footprint_collision_predictor::tools {
namespace {

// [s] A recorder that has the simulator's time is never as far from it as this.
constexpr double kOtherClock = 1;

const ros::Duration kNanosecond(0, 1);

ros::SteadyTime steadyAt(const ros::Time& time) { return {time.sec, time.nsec}; }
ros::Time timeAt(const ros::SteadyTime& time) { return {time.sec, time.nsec}; }

/// Empty when the bytes are not such a message.
template <typename Message>
Message deserialized(const RawMessage& raw) try {
  Message message;
  // The stream does not write, but its type does not say so.
  auto* bytes = const_cast<std::uint8_t*>(raw.bytes.data());
  ros::serialization::IStream stream(bytes, static_cast<std::uint32_t>(raw.bytes.size()));
  ros::serialization::deserialize(stream, message);
  return message;
} catch (const std::exception&) {
  return {};
}

/// tf2 refuses by its result, and stamps that it cannot compute with by an exception.
bool accepts(tf2::BufferCore& tf, const geometry_msgs::TransformStamped& transform,
             bool fixed) try {
  return tf.setTransform(transform, "bag", fixed);
} catch (const std::exception&) {
  return false;
}

}  // namespace

std::int32_t obstacleIndexOf(const Answer& answer) {
  if (!answer.prediction || answer.warning.segment < 0) return -1;
  const auto segment = static_cast<std::size_t>(answer.warning.segment);
  return answer.prediction->segments.at(segment).obstacle_index;
}

Replay::Replay(const Parameters& parameters, const Body& body, const InputNames& names,
               const Window& window, Take take)
    : window_(window),
      patience_(ros::Duration(parameters.transform_tolerance) + kNanosecond),
      silence_(ros::Duration(parameters.max_data_age) + kNanosecond),
      take_(std::move(take)),
      pipeline_(parameters, body, names, tf_, true,
                [this](const Answer& answer) { publish(answer, false); }),
      silent_at_(window.begin + silence_) {}

void Replay::take(const RecordedMessage& message) {
  catchUp(message.recorded);
  switch (message.input) {
    case Input::kObstacles:
      if (message.recorded < window_.begin) return;
      return receive(&Pipeline::receiveObstacles, message);
    case Input::kFootprint:
      return receive(&Pipeline::receiveFootprint, message);
    case Input::kOdometry:
      return receive(&Pipeline::receiveOdometry, message);
    case Input::kTransforms:
      return takeTransforms(message, false);
    case Input::kFixedTransforms:
      return takeTransforms(message, true);
    case Input::kClock:
      return takeClock(message);
  }
}

void Replay::finish(const ros::Time& end) {
  catchUp(end);
  // Nothing can come any more for what still waits.
  while (!due_.empty()) {
    pipeline_.process(momentAt(due_.front()));
    due_.pop_front();
  }
}

/// Both clocks are the recording's. Only where a simulator's time was recorded by another clock is
/// that the one of the stamps.
Moment Replay::momentAt(const ros::Time& recorded) const {
  return {clock_differs_.value_or(false) ? clock_ : recorded, steadyAt(recorded)};
}

/// What the live node would have done by itself since the message before.
void Replay::catchUp(const ros::Time& until) {
  for (;;) {
    const bool due = !due_.empty() && due_.front() < until;
    const bool silent = silent_at_ && *silent_at_ < until;
    if (due && !(silent && *silent_at_ < due_.front())) {
      const ros::Time when = due_.front();
      due_.pop_front();
      pipeline_.process(momentAt(when));
    } else if (silent) {
      sayNothingCame(*silent_at_);
    } else {
      return;
    }
  }
}

void Replay::sayNothingCame(const ros::Time& when) {
  const Moment now = momentAt(when);
  publish({pipeline_.repeat(now), {}, now}, true);
  silent_at_.reset();
}

void Replay::publish(const Answer& answer, bool silence) {
  const ros::Time when = timeAt(answer.now.steady);
  const auto& scene = pipeline_.scene();
  take_({(when - window_.begin).toSec(), silence, answer,
         answer.prediction && scene ? &*scene : nullptr});
  silent_at_ = when + silence_;
}

void Replay::receive(void (Pipeline::*input)(const RawMessage&, const Moment&),
                     const RecordedMessage& message) {
  (pipeline_.*input)(message.raw, momentAt(message.recorded));
  if (!pipeline_.isWaiting())
    due_.clear();
  else if (message.input != Input::kOdometry)
    due_.push_back(message.recorded + patience_);
}

void Replay::takeTransforms(const RecordedMessage& message, bool fixed) {
  for (const auto& transform : deserialized<tf2_msgs::TFMessage>(message.raw).transforms)
    if (!accepts(tf_, transform, fixed)) ++refused_transforms_;
  if (pipeline_.isWaiting()) pipeline_.process(momentAt(message.recorded));
}

void Replay::takeClock(const RecordedMessage& message) {
  clock_ = deserialized<rosgraph_msgs::Clock>(message.raw).clock;
  if (!clock_differs_)
    clock_differs_ = std::abs(secondsBetween(clock_, message.recorded)) > kOtherClock;
  if (*clock_differs_) pipeline_.process(momentAt(message.recorded));
}

}  // namespace footprint_collision_predictor::tools
