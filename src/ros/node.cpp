#include "node.hpp"

#include <ros/console.h>
#include <topic_tools/shape_shifter.h>

#include <algorithm>
#include <chrono>
#include <limits>

namespace footprint_collision_predictor {
namespace {

constexpr std::uint32_t kQueueSize = 100;

// [s] How often the worker looks whether the transform or odometry that a message waits for has
// come.
constexpr double kPollPeriod = 1e-3;

Parameters parametersOf(const ros::NodeHandle& private_node) {
  XmlRpc::XmlRpcValue values;
  private_node.getParam(private_node.getNamespace(), values);
  return parametersFrom(values);
}

Moment now() { return {ros::Time::now(), ros::SteadyTime::now()}; }

RawMessage rawOf(const topic_tools::ShapeShifter& shape_shifter) {
  RawMessage raw{shape_shifter.getDataType(), shape_shifter.getMD5Sum(),
                 std::vector<std::uint8_t>(shape_shifter.size())};
  ros::serialization::OStream stream(raw.bytes.data(), shape_shifter.size());
  shape_shifter.write(stream);
  return raw;
}

/// For when nothing could be evaluated: not one number is known.
CollisionWarning unknown(const Parameters& parameters, const std::string& why) {
  Findings findings;
  findings.add(CollisionWarning::REASON_DEADLINE, why);
  CollisionWarning msg =
      warningMsg(nullptr, ros::Time::now(), core::Level::kUnknown, findings, parameters);
  msg.data_age = std::numeric_limits<double>::infinity();
  return msg;
}

}  // namespace

Node::Node(const ros::NodeHandle& node, const ros::NodeHandle& private_node)
    : parameters_(parametersOf(private_node)),
      node_(node),
      private_node_(private_node),
      predictions_(node_.advertise<CollisionPrediction>("collision_prediction", kQueueSize)),
      markers_(private_node_.advertise<visualization_msgs::MarkerArray>("markers", 1)),
      warnings_(node_),
      pipeline_(parameters_,
                {node_.resolveName("obstacles"), node_.resolveName("footprint"),
                 node_.resolveName("odom")},
                tf_, ros::Time::isSimTime(), [this](const Answer& answer) { publish(answer); }),
      diagnostics_(node_, private_node_, warnings_) {
  node_.setCallbackQueue(&queue_);
  addInput("obstacles", &Pipeline::receiveObstacles);
  if (!parameters_.footprint) addInput("footprint", &Pipeline::receiveFootprint);
  if (parameters_.ego_motion == EgoMotion::kOdom) addInput("odom", &Pipeline::receiveOdometry);
  subscribeTransforms("/tf", false);
  subscribeTransforms("/tf_static", true);
  worker_ = std::thread(&Node::work, this);
  heartbeat_ = std::thread(&Node::beat, this);
}

Node::~Node() {
  {
    const std::lock_guard<std::mutex> lock(stop_mutex_);
    running_ = false;
  }
  stop_.notify_all();
  worker_.join();
  heartbeat_.join();
}

void Node::addInput(const std::string& topic, Receive receive) {
  inputs_.push_back({topic, receive, {}, false});
  subscribe(inputs_.back());
}

/// tf2_ros's own listener lets a stamp that tf2 cannot compute with end the process.
void Node::takeTransforms(const tf2_msgs::TFMessage& message, bool fixed) {
  for (const auto& transform : message.transforms) {
    try {
      tf_.setTransform(transform, "tf", fixed);
    } catch (const std::exception& error) {
      ROS_ERROR_STREAM_THROTTLE(1, "the transform from " << transform.header.frame_id << " to "
                                                         << transform.child_frame_id << " stamped "
                                                         << transform.header.stamp
                                                         << " is ignored: " << error.what());
    }
  }
}

void Node::subscribeTransforms(const std::string& topic, bool fixed) {
  const boost::function<void(const tf2_msgs::TFMessage::ConstPtr&)> callback =
      [this, fixed](const tf2_msgs::TFMessage::ConstPtr& message) {
        takeTransforms(*message, fixed);
      };
  transform_subscribers_.push_back(
      node_.subscribe<tf2_msgs::TFMessage>(topic, kQueueSize, callback));
}

void Node::publish(const Answer& answer) {
  if (answer.prediction) predictions_.publish(*answer.prediction);
  const double elapsed = secondsBetween(answer.now.steady, ros::SteadyTime::now());
  warnings_.publish(finishedAfter(elapsed, answer.warning, parameters_));
}

/// Raw, so that the node sees every type and every malformed message itself.
void Node::subscribe(Input& input) {
  const boost::function<void(const topic_tools::ShapeShifter::ConstPtr&)> callback =
      [this, &input](const topic_tools::ShapeShifter::ConstPtr& message) {
        input.connected = true;
        guarded([&] { (pipeline_.*input.receive)(rawOf(*message), now()); });
      };
  input.subscriber = node_.subscribe<topic_tools::ShapeShifter>(
      input.topic, kQueueSize, callback, {}, ros::TransportHints().tcpNoDelay());
}

/// roscpp keeps even a raw subscription to the type of the first publisher it met: publishers of
/// another type cannot connect, and nobody hears of it. So it is renewed when its publishers are
/// gone.
void Node::renewAbandonedInputs() {
  for (Input& input : inputs_) {
    const bool connected = input.subscriber.getNumPublishers() > 0;
    if (input.connected && !connected) {
      queue_.callAvailable();  // what they sent last
      input.subscriber.shutdown();
      subscribe(input);
    }
    input.connected = connected;
  }
}

void Node::work() {
  const ros::WallDuration period(1 / parameters_.heartbeat_rate);
  ros::SteadyTime next = ros::SteadyTime::now();
  while (running_) {
    progress_ = ros::SteadyTime::now().toNSec();
    const double left = secondsBetween(ros::SteadyTime::now(), next);
    const double wait = pipeline_.isWaiting() ? std::min(left, kPollPeriod) : left;
    queue_.callAvailable(ros::WallDuration(std::max(0.0, wait)));
    guarded([&] {
      pipeline_.process(now());
      if (ros::SteadyTime::now() < next) return;
      next = std::max(next + period, ros::SteadyTime::now());
      const Moment then = now();
      const CollisionWarning repeated = pipeline_.repeat(then);
      publish({repeated, {}, then});
      if (markers_.getNumSubscribers() > 0) markers_.publish(pipeline_.picture(repeated, then));
      renewAbandonedInputs();
    });
  }
}

/// Steps in when the worker has been silent: with its newest result while it may just be late, and
/// with UNKNOWN when it has not come round for so long that it must be taken to hang.
void Node::beat() {
  const double period = 1 / parameters_.heartbeat_rate;
  const double patience = std::max(2 * period, 0.1);
  const auto stopped = [this] { return !running_; };
  std::unique_lock<std::mutex> lock(stop_mutex_);
  while (!stop_.wait_for(lock, std::chrono::duration<double>(period), stopped)) {
    warnings_.publishIfSilent(1.5 * period, [&](const CollisionWarning& last, double silence) {
      const std::uint64_t progress = progress_;  // first, so that the difference is not negative
      const double hang = 1e-9 * static_cast<double>(ros::SteadyTime::now().toNSec() - progress);
      if (hang <= patience) return olderBy(silence, last, parameters_);
      return unknown(parameters_, "no evaluation has finished for " + std::to_string(hang) +
                                      " s: too many obstacles, or an overloaded machine");
    });
  }
}

void Node::guarded(const std::function<void()>& step) try {
  step();
} catch (const std::exception& error) {
  ROS_ERROR_STREAM_THROTTLE(1, "an evaluation failed: " << error.what());
  warnings_.publish(unknown(parameters_, std::string("an evaluation failed: ") + error.what()));
}

}  // namespace footprint_collision_predictor
