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
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "diagnostics.hpp"
#include "evaluation_times.hpp"
#include "live_parameters.hpp"
#include "master_watch.hpp"
#include "pipeline.hpp"
#include "reconfiguration.hpp"
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
  Node(const ros::NodeHandle& node, const ros::NodeHandle& private_node,
       const XmlRpc::XmlRpcValue& values);

  /// For one body of the robot.
  struct Predictor {
    Predictor(Node& node, const Body& body);

    Pipeline pipeline;
    WarningPublisher warnings;
  };

  using Receive = void (Pipeline::*)(const RawMessage&, const Moment&);

  struct Input {
    std::string topic;
    Receive receive;
    std::vector<const Predictor*> takers;
    ros::Subscriber subscriber;
    bool connected = false;  // since it was last looked at
  };

  static Moment now() { return {ros::Time::now(), ros::SteadyTime::now()}; }

  std::list<Predictor> makePredictors();
  void addInputs(const Predictor& predictor);
  void addInput(const std::string& topic, Receive receive, const Predictor& taker);
  void subscribe(Input& input);
  void take(const Input& input, const RawMessage& message, const Moment& now);
  void renewAbandonedInputs();
  void subscribeTransforms(const std::string& topic, bool fixed);
  void takeTransforms(const tf2_msgs::TFMessage& message, bool fixed);
  void takeNewParameters();
  void publish(const Answer& answer, WarningPublisher& warnings);
  Report report(const Moment& now) const;
  bool isWaiting() const;
  void work();
  void goRound(const Moment& now);
  void repeat(const Moment& now);
  void tellOfClock(const ClockReport& clock);
  void beat();
  void beat(const Parameters& parameters, WarningPublisher& warnings, const Body& body);
  void forEach(const std::function<void(Predictor&)>& step);
  void guarded(const std::function<void()>& step);
  void sayFailed(const std::exception& error, Predictor& predictor);

  LiveParameters parameters_;
  std::shared_ptr<const Parameters> used_;  // by the pipeline
  ros::NodeHandle node_;
  ros::NodeHandle private_node_;
  ros::CallbackQueue queue_;
  ros::Publisher predictions_;
  ros::Publisher markers_;
  tf2::BufferCore tf_;

  const std::uint32_t session_;
  std::list<Predictor> predictors_;  // whose addresses stay
  EvaluationTimes times_;
  MasterWatch master_;
  Reconfiguration reconfiguration_;
  Diagnostics diagnostics_;
  ros::SteadyTime last_report_;
  std::uint64_t jumps_told_ = 0;  // of the clock
  std::list<Input> inputs_;       // whose addresses stay
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
