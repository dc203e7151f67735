#include "topic_choice.hpp"

#include <geometry_msgs/PolygonStamped.h>
#include <nav_msgs/Odometry.h>
#include <rosgraph_msgs/Clock.h>
#include <tf2_msgs/TFMessage.h>

#include <algorithm>

#include "../exit_status.hpp"
#include "analysis_status.hpp"
#include "bag_problem.hpp"
#include "message_decoding.hpp"
#include "suggestion.hpp"

namespace footprint_collision_predictor::tools {
namespace {

/// What is looked for.
struct Role {
  std::string what;    ///< "obstacles"
  std::string option;  ///< "--obstacles"
  std::vector<MessageType> types;
  std::string otherwise;  ///< what to do when the bag has none
};

template <typename Message>
MessageType typeOf() {
  return {ros::message_traits::DataType<Message>::value(),
          ros::message_traits::MD5Sum<Message>::value()};
}

Role obstaclesRole() {
  return {"obstacles", "--obstacles", obstacleTypes(),
          "Record the tracker's output, or run the tracker on this bag and record what it says"};
}

Role odometryRole() {
  return {"odometry",
          "--odom",
          {typeOf<nav_msgs::Odometry>()},
          "For a robot or sensor that stands still: --ego-motion static"};
}

Role footprintRole() {
  return {"footprint",
          "--footprint",
          {typeOf<geometry_msgs::PolygonStamped>()},
          "Give it by --footprint-polygon \"[[x, y], ...]\", or in a file by --params"};
}

bool knows(const Role& role, const RecordedTopic& topic) {
  return std::any_of(role.types.begin(), role.types.end(),
                     [&](const MessageType& type) { return type.md5 == topic.md5; });
}

std::string listed(const std::vector<RecordedTopic>& topics, const std::string& before = "") {
  std::string text;
  for (const RecordedTopic& topic : topics)
    text += "\n  " + before + topic.name + "   " + topic.type;
  return text;
}

std::string namesOf(const std::vector<MessageType>& types) {
  std::string text;
  for (const MessageType& type : types) text += (text.empty() ? "" : " or ") + type.name;
  return text;
}

/// A topic of the right name of type and another sum was recorded with another version.
void refuseOtherVersion(const std::string& bag, const Role& role, const RecordedTopic& topic) {
  for (const MessageType& type : role.types) {
    if (type.name != topic.type || type.md5 == topic.md5) continue;
    throw BagProblem(kBagUnreadable, bag + ": " + topic.name + " carries another version of " +
                                         type.name + ": its md5 sum is " + topic.md5 + ", and " +
                                         type.md5 +
                                         " is understood. Convert the bag with: rosbag fix");
  }
}

[[noreturn]] void refuseNone(const std::string& bag, const Role& role,
                             const std::vector<RecordedTopic>& topics) {
  for (const RecordedTopic& topic : topics) refuseOtherVersion(bag, role, topic);
  throw BagProblem(kUsage, bag + ": no topic of it carries " + role.what + " (" +
                               namesOf(role.types) + "). " + role.otherwise +
                               ". The topics of it:" + listed(topics));
}

RecordedTopic byType(const std::string& bag, const Role& role,
                     const std::vector<RecordedTopic>& topics) {
  std::vector<RecordedTopic> fitting;
  for (const RecordedTopic& topic : topics)
    if (knows(role, topic)) fitting.push_back(topic);
  if (fitting.size() == 1) return fitting.front();
  if (fitting.empty()) refuseNone(bag, role, topics);
  throw BagProblem(kUsage, bag + ": several topics of it carry " + role.what +
                               "; choose one:" + listed(fitting, role.option + " "));
}

std::string withoutSlash(const std::string& name) {
  return !name.empty() && name.front() == '/' ? name.substr(1) : name;
}

RecordedTopic byName(const std::string& bag, const Role& role, const std::string& name,
                     const std::vector<RecordedTopic>& topics) {
  std::vector<std::string> names;
  std::optional<RecordedTopic> other;
  for (const RecordedTopic& topic : topics) {
    names.push_back(topic.name);
    if (withoutSlash(topic.name) != withoutSlash(name)) continue;
    if (knows(role, topic)) return topic;
    other = topic;
  }
  if (other) {
    refuseOtherVersion(bag, role, *other);
    throw BagProblem(kUsage, bag + ": " + other->name + " carries " + other->type + "; " +
                                 role.option + " takes " + namesOf(role.types));
  }
  const std::string meant = nearestName(name, names);
  throw BagProblem(kUsage, bag + ": it has no topic " + name +
                               (meant.empty() ? "." : "; did you mean " + meant + "?") +
                               " The topics of it:" + listed(topics));
}

RecordedTopic choose(const std::string& bag, const Role& role, const std::string& name,
                     const std::vector<RecordedTopic>& topics) {
  return name.empty() ? byType(bag, role, topics) : byName(bag, role, name, topics);
}

/// tf and clock have names that are always the same.
void addFixedTopics(const std::vector<RecordedTopic>& topics,
                    std::map<std::string, Input>& inputs) {
  const MessageType tf = typeOf<tf2_msgs::TFMessage>();
  const MessageType clock = typeOf<rosgraph_msgs::Clock>();
  for (const RecordedTopic& topic : topics) {
    const std::string name = withoutSlash(topic.name);
    if (name == "tf" && topic.md5 == tf.md5) inputs[topic.name] = Input::kTransforms;
    if (name == "tf_static" && topic.md5 == tf.md5) inputs[topic.name] = Input::kFixedTransforms;
    if (name == "clock" && topic.md5 == clock.md5) inputs[topic.name] = Input::kClock;
  }
}

}  // namespace

TopicChoice chooseTopics(const std::string& bag, const std::vector<RecordedTopic>& topics,
                         const Options& options, const Parameters& parameters, const Body& body) {
  TopicChoice choice;
  addFixedTopics(topics, choice.inputs);
  const auto take = [&](const Role& role, const std::string& name, Input input) {
    const RecordedTopic topic = choose(bag, role, name, topics);
    choice.inputs[topic.name] = input;
    return topic;
  };
  const RecordedTopic obstacles = take(obstaclesRole(), options.obstacles, Input::kObstacles);
  choice.names.obstacles = obstacles.name;
  choice.obstacles_type = obstacles.type;
  if (needsOdometry(parameters, body))
    choice.names.odom = take(odometryRole(), options.odom, Input::kOdometry).name;
  if (!body.footprint) {
    const std::string& name = parameters.footprints.empty() ? options.footprint : body.topic;
    choice.names.footprint = take(footprintRole(), name, Input::kFootprint).name;
  }
  return choice;
}

}  // namespace footprint_collision_predictor::tools
