// The part of the node that subscribes, and takes in what comes.
#include <ros/console.h>

#include <algorithm>

#include "node.hpp"

namespace footprint_collision_predictor {
namespace {

constexpr std::uint32_t kQueueSize = 100;

}  // namespace

void Node::addInputs(const Predictor& predictor) {
  const Body& body = predictor.pipeline.body();
  addInput("obstacles", &Pipeline::receiveObstacles, predictor);
  if (!body.footprint) addInput(body.topic, &Pipeline::receiveFootprint, predictor);
  if (needsOdometry(*used_, body)) addInput("odom", &Pipeline::receiveOdometry, predictor);
}

void Node::addInput(const std::string& topic, Receive receive, const Predictor& taker) {
  const auto known = std::find_if(inputs_.begin(), inputs_.end(), [&](const Input& input) {
    return input.topic == topic && input.receive == receive;
  });
  if (known == inputs_.end())
    inputs_.push_back({topic, receive, {&taker}, {}, false});
  else
    known->takers.push_back(&taker);
}

/// Raw, so that the node sees every type and every malformed message itself.
void Node::subscribe(Input& input) {
  using Message = boost::shared_ptr<const RawMessage>;
  const boost::function<void(const Message&)> callback = [this, &input](const Message& message) {
    input.connected = true;
    takeNewParameters();  // they may have changed while the worker waited for this message
    guarded([&] { take(input, *message, now()); });
  };
  input.subscriber = node_.subscribe<RawMessage>(
      input.topic, kQueueSize, callback, ros::VoidConstPtr(), ros::TransportHints().tcpNoDelay());
}

/// The other bodies look at the clock, so that all notice a jump before anything comes after it.
void Node::take(const Input& input, const RawMessage& message, const Moment& now) {
  forEach([&](Predictor& predictor) {
    const auto& takers = input.takers;
    if (std::find(takers.begin(), takers.end(), &predictor) != takers.end())
      (predictor.pipeline.*input.receive)(message, now);
    else
      predictor.pipeline.process(now);
  });
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

}  // namespace footprint_collision_predictor
