// The rim: topics, threads and clocks round the pipeline.
#pragma once

#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <tf2/buffer_core.h>
#include <tf2_msgs/TFMessage.h>

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <list>
#include <mutex>
#include <string>
#include <thread>

#include "diagnostics.hpp"
#include "pipeline.hpp"
#include "warning_publisher.hpp"

namespace footprint_collision_predictor {

/// A worker thread takes in every message and does every evaluation, also the repeats. A heartbeat
/// thread evaluates nothing: it keeps the warnings coming when the worker does not.
class Node {
 public:
  /// \param node its callbacks go to a queue of the worker's
  /// \throws ParameterError
  Node(const ros::NodeHandle& node, const ros::NodeHandle& private_node);
  ~Node();
  Node(const Node&) = delete;
  Node& operator=(const Node&) = delete;

 private:
  using Receive = void (Pipeline::*)(const RawMessage&, const Moment&);

  struct Input {
    std::string topic;
    Receive receive;
    ros::Subscriber subscriber;
    bool connected = false;  // since it was last looked at
  };

  void addInput(const std::string& topic, Receive receive);
  void subscribe(Input& input);
  void renewAbandonedInputs();
  void subscribeTransforms(const std::string& topic, bool fixed);
  void takeTransforms(const tf2_msgs::TFMessage& message, bool fixed);
  void publish(const Answer& answer);
  void work();
  void beat();
  void guarded(const std::function<void()>& step);

  const Parameters parameters_;
  ros::NodeHandle node_;
  ros::NodeHandle private_node_;
  ros::CallbackQueue queue_;
  ros::Publisher predictions_;
  ros::Publisher markers_;
  WarningPublisher warnings_;
  tf2::BufferCore tf_;

  Pipeline pipeline_;
  Diagnostics diagnostics_;
  std::list<Input> inputs_;  // whose addresses stay
  std::vector<ros::Subscriber> transform_subscribers_;

  std::mutex stop_mutex_;
  std::condition_variable stop_;
  std::atomic<bool> running_{true};
  std::atomic<std::uint64_t> progress_{
      ros::SteadyTime::now().toNSec()};  // steady time [ns] at which the worker last came round
  std::thread worker_;
  std::thread heartbeat_;
};

}  // namespace footprint_collision_predictor
