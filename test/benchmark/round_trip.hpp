// How long it takes until a message that is sent has its answer.
#pragma once

#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <ros/spinner.h>

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <string>

namespace footprint_collision_predictor::bench {

/// All that is read of an answer, of whatever type: it begins with a header.
struct Stamped {
  ros::Time stamp;
};

class RoundTrip {
 public:
  using Clock = std::chrono::steady_clock;

  /// \param answers a topic whose messages begin with a header
  explicit RoundTrip(const std::string& answers);

  /// \param send hands a message with this stamp on; it must be connected
  /// \return time from there until the first answer with this stamp comes [s]
  /// \throws std::runtime_error when none comes within 5 s
  double measure(const ros::Time& stamp, const std::function<void()>& send);

  bool isConnected() const { return subscriber_.getNumPublishers() > 0; }

 private:
  void take(const Stamped& answer);

  ros::CallbackQueue queue_;
  ros::AsyncSpinner spinner_;
  ros::NodeHandle node_;
  ros::Subscriber subscriber_;
  std::mutex mutex_;
  std::condition_variable arrived_;
  ros::Time awaited_;
  Clock::time_point arrival_;
};

}  // namespace footprint_collision_predictor::bench

namespace ros::message_traits {

template <>
struct MD5Sum<footprint_collision_predictor::bench::Stamped> {
  static const char* value() { return "*"; }
  static const char* value(const footprint_collision_predictor::bench::Stamped&) { return "*"; }
};

template <>
struct DataType<footprint_collision_predictor::bench::Stamped> {
  static const char* value() { return "*"; }
  static const char* value(const footprint_collision_predictor::bench::Stamped&) { return "*"; }
};

template <>
struct Definition<footprint_collision_predictor::bench::Stamped> {
  static const char* value() { return ""; }
};

}  // namespace ros::message_traits

namespace ros::serialization {

template <>
struct Serializer<footprint_collision_predictor::bench::Stamped> {
  template <typename Stream>
  static void read(Stream& stream, footprint_collision_predictor::bench::Stamped& message) {
    std::uint32_t sequence;
    stream.next(sequence);
    stream.next(message.stamp);
  }
};

}  // namespace ros::serialization
