#include "node.hpp"

#include <ros/console.h>
#include <topic_tools/shape_shifter.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

namespace footprint_collision_predictor {
namespace {

constexpr std::uint32_t kQueueSize = 100;

// [s] How often the worker looks whether the transform or odometry that a message waits for has
// come.
constexpr double kPollPeriod = 1e-3;

constexpr double kReportPeriod = 0.1;  // [s] of what the diagnostics are made of

XmlRpc::XmlRpcValue valuesOf(const ros::NodeHandle& private_node) {
  XmlRpc::XmlRpcValue values;
  private_node.getParam(private_node.getNamespace(), values);
  return values;
}

Moment now() { return {ros::Time::now(), ros::SteadyTime::now()}; }

using Event = ros::MessageEvent<topic_tools::ShapeShifter const>;

RawMessage rawOf(const Event& event) {
  const topic_tools::ShapeShifter& shape_shifter = *event.getConstMessage();
  RawMessage raw{shape_shifter.getDataType(), shape_shifter.getMD5Sum(),
                 std::vector<std::uint8_t>(shape_shifter.size()), event.getPublisherName()};
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
    : Node(node, private_node, valuesOf(private_node)) {}

Node::Node(const ros::NodeHandle& node, const ros::NodeHandle& private_node,
           const XmlRpc::XmlRpcValue& values)
    : parameters_(parametersFrom(values)),
      used_(parameters_.get()),
      node_(node),
      private_node_(private_node),
      predictions_(node_.advertise<CollisionPrediction>("collision_prediction", kQueueSize)),
      markers_(private_node_.advertise<visualization_msgs::MarkerArray>("markers", 1)),
      warnings_(node_),
      pipeline_(*used_,
                {node_.resolveName("obstacles"), node_.resolveName("footprint"),
                 node_.resolveName("odom")},
                tf_, ros::Time::isSimTime(), [this](const Answer& answer) { publish(answer); }),
      reconfiguration_(private_node_, values, [this](const Parameters& p) { parameters_.set(p); }),
      diagnostics_(node_, private_node_, {warnings_, master_, reconfiguration_}, report(now())) {
  node_.setCallbackQueue(&queue_);
  addInput("obstacles", &Pipeline::receiveObstacles);
  if (!used_->footprint) addInput("footprint", &Pipeline::receiveFootprint);
  if (used_->ego_motion == EgoMotion::kOdom) addInput("odom", &Pipeline::receiveOdometry);
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

void Node::takeNewParameters() {
  const auto newest = parameters_.get();
  if (newest == used_) return;
  used_ = newest;
  pipeline_.reconfigure(*used_);
}

void Node::publish(const Answer& answer) {
  if (answer.prediction) predictions_.publish(*answer.prediction);
  const ros::SteadyTime finished = ros::SteadyTime::now();
  const double elapsed = secondsBetween(answer.now.steady, finished);
  const bool evaluated = !std::isnan(answer.warning.clearance);
  if (evaluated) times_.add(elapsed, 1 / used_->heartbeat_rate, finished);
  warnings_.publish(finishedAfter(elapsed, answer.warning, *used_));
}

/// Raw, so that the node sees every type and every malformed message itself.
void Node::subscribe(Input& input) {
  const boost::function<void(const Event&)> callback = [this, &input](const Event& event) {
    input.connected = true;
    guarded([&] { (pipeline_.*input.receive)(rawOf(event), now()); });
  };
  input.subscriber = node_.subscribe<topic_tools::ShapeShifter, const Event&>(
      input.topic, kQueueSize, callback, ros::VoidConstPtr(), ros::TransportHints().tcpNoDelay());
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
  ros::SteadyTime next = ros::SteadyTime::now();
  while (running_) {
    progress_ = ros::SteadyTime::now().toNSec();
    takeNewParameters();
    const ros::WallDuration period(1 / used_->heartbeat_rate);
    const double left = secondsBetween(ros::SteadyTime::now(), next);
    const double wait = pipeline_.isWaiting() ? std::min(left, kPollPeriod) : left;
    queue_.callAvailable(ros::WallDuration(std::max(0.0, wait)));
    guarded([&] {
      pipeline_.process(now());
      if (ros::SteadyTime::now() < next) return;
      next = std::max(next + period, ros::SteadyTime::now());
      goRound(now());
    });
  }
}

/// What is done once in a period of the heartbeat, besides taking in messages.
void Node::goRound(const Moment& now) {
  const CollisionWarning repeated = pipeline_.repeat(now);
  publish({repeated, {}, now});
  if (markers_.getNumSubscribers() > 0) markers_.publish(pipeline_.picture(repeated, now));
  renewAbandonedInputs();
  if (secondsBetween(last_report_, now.steady) < kReportPeriod) return;
  last_report_ = now.steady;
  const MasterView master = master_.view();
  pipeline_.setRegistered([&](const std::string& topic) {
    const auto found = master.publishers.find(topic);
    return found == master.publishers.end() ? std::vector<std::string>() : found->second;
  });
  diagnostics_.update(report(now));
}

Report Node::report(const Moment& now) const {
  Report report = pipeline_.report(now);
  report.computation = times_.report(1 / used_->heartbeat_rate, now.steady);
  return report;
}

/// Steps in when the worker has been silent: with its newest result while it may just be late, and
/// with UNKNOWN when it has not come round for so long that it must be taken to hang.
void Node::beat() {
  auto parameters = parameters_.get();
  const auto stopped = [this] { return !running_; };
  std::unique_lock<std::mutex> lock(stop_mutex_);
  while (!stop_.wait_for(lock, std::chrono::duration<double>(1 / parameters->heartbeat_rate),
                         stopped)) {
    parameters = parameters_.get();
    const double period = 1 / parameters->heartbeat_rate;
    const double patience = std::max(2 * period, 0.1);
    warnings_.publishIfSilent(1.5 * period, [&](const CollisionWarning& last, double silence) {
      const std::uint64_t progress = progress_;  // first, so that the difference is not negative
      const double hang = 1e-9 * static_cast<double>(ros::SteadyTime::now().toNSec() - progress);
      if (hang <= patience) return olderBy(silence, last, *parameters);
      return unknown(*parameters, "no evaluation has finished for " + std::to_string(hang) +
                                      " s: too many obstacles, or an overloaded machine");
    });
  }
}

void Node::guarded(const std::function<void()>& step) try {
  step();
} catch (const std::exception& error) {
  ROS_ERROR_STREAM_THROTTLE(1, "an evaluation failed: " << error.what());
  warnings_.publish(unknown(*used_, std::string("an evaluation failed: ") + error.what()));
}

}  // namespace footprint_collision_predictor
