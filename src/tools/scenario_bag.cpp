#include <footprint_collision_predictor/ObstacleArray.h>
#include <nav_msgs/Odometry.h>
#include <rosbag/bag.h>
#include <rosgraph_msgs/Clock.h>
#include <tf2_msgs/TFMessage.h>

#include <cmath>
#include <memory>

#include "scenario_writer.hpp"

namespace footprint_collision_predictor::tools {
namespace {

constexpr long kOdometryPerObstacles = 5;
// [s] By the recorder's clock: between the two rounds of a loop, and from the first tick of a clock
// to the first message that is stamped by it.
constexpr double kLoopPause = 0.45;
constexpr double kClockLead = 0.3;
// Before the first message of a robot of several bodies, so that their motion is known from there
// on: it is taken from two transforms.
constexpr double kTransformLead = 0.2;  // [s]

/// The i-th of so many per second, as [s] since the start; rounded to a nanosecond as stamps are.
double timeOf(long i, double rate) {
  return static_cast<double>(std::llround(1e9 * static_cast<double>(i) / rate)) / 1e9;
}

long countUntil(double duration, double rate) {
  return std::lround(std::floor(duration * rate + 1e-6)) + 1;
}

bool isSilent(const Scenario& scenario, double t) {
  return scenario.silence && t > scenario.silence->after && t < scenario.silence->before;
}

Point turned(const Point& p, double heading) {
  return {std::cos(heading) * p.x - std::sin(heading) * p.y,
          std::sin(heading) * p.x + std::cos(heading) * p.y};
}

nav_msgs::Odometry odometryAt(const Scenario& scenario, double t) {
  nav_msgs::Odometry odometry;
  odometry.header.stamp = stampAt(t);
  odometry.header.frame_id = "odom";
  odometry.child_frame_id = "base_link";
  const Pose pose = robotPose(scenario, t);
  odometry.pose.pose.position.x = pose.position.x;
  odometry.pose.pose.position.y = pose.position.y;
  odometry.pose.pose.orientation.z = std::sin(pose.heading / 2);
  odometry.pose.pose.orientation.w = std::cos(pose.heading / 2);
  odometry.twist.twist.linear.x = scenario.robot_speed;
  odometry.twist.twist.angular.z = scenario.yaw_rate;
  return odometry;
}

tf2_msgs::TFMessage transformsFrom(const Scenario& scenario, const nav_msgs::Odometry& odometry) {
  geometry_msgs::TransformStamped transform;
  transform.header = odometry.header;
  transform.child_frame_id = odometry.child_frame_id;
  transform.transform.translation.x = odometry.pose.pose.position.x;
  transform.transform.translation.y = odometry.pose.pose.position.y;
  transform.transform.rotation = odometry.pose.pose.orientation;
  tf2_msgs::TFMessage message;
  message.transforms.push_back(transform);
  for (std::size_t i = 1; i < scenario.bodies.size(); ++i) {
    transform.header.frame_id = "base_link";
    transform.child_frame_id = scenario.bodies[i].frame;
    transform.transform.translation.x = scenario.bodies[i].origin.x;
    transform.transform.translation.y = scenario.bodies[i].origin.y;
    transform.transform.rotation = geometry_msgs::Quaternion();
    transform.transform.rotation.w = 1;
    message.transforms.push_back(transform);
  }
  return message;
}

Obstacle obstacleFrom(const Circle& circle, const Pose& robot) {
  Obstacle obstacle;
  const Point offset = turned(circle.position, robot.heading);
  const Point velocity = turned(circle.velocity, robot.heading);
  const Point acceleration = turned(circle.acceleration, robot.heading);
  obstacle.id = circle.id;
  obstacle.position.x = robot.position.x + offset.x;
  obstacle.position.y = robot.position.y + offset.y;
  obstacle.velocity.x = velocity.x;
  obstacle.velocity.y = velocity.y;
  obstacle.acceleration.x = acceleration.x;
  obstacle.acceleration.y = acceleration.y;
  obstacle.radius = circle.radius;
  return obstacle;
}

ObstacleArray obstaclesAt(const Scenario& scenario, const ScenarioOptions& options, double t) {
  ObstacleArray message;
  message.header.stamp = stampAt(t);
  message.header.frame_id = "odom";
  const Pose robot = robotPose(scenario, t);
  for (const Circle& circle : measured(scenario, options, t))
    message.obstacles.push_back(obstacleFrom(circle, robot));
  return message;
}

rosgraph_msgs::Clock clockAt(double t) {
  rosgraph_msgs::Clock clock;
  clock.clock = stampAt(t);
  return clock;
}

void writeTransformsBefore(const Scenario& scenario, double rate, rosbag::Bag& bag) {
  for (long i = std::lround(std::floor(kTransformLead * rate)); i > 0; --i) {
    const double t = -timeOf(i, rate);
    bag.write("/tf", stampAt(t), transformsFrom(scenario, odometryAt(scenario, t)));
  }
}

/// \param shift [s] from stamps to the times of recording
void writeRound(const Scenario& scenario, const ScenarioOptions& options, double shift,
                rosbag::Bag& bag) {
  const double odometry_rate = options.rate * kOdometryPerObstacles;
  if (scenario.looped) bag.write("/clock", stampAt(shift - kClockLead), clockAt(0));
  if (scenario.bodies.size() > 1) writeTransformsBefore(scenario, odometry_rate, bag);
  for (long i = 0; i < countUntil(options.duration, odometry_rate); ++i) {
    const double t = timeOf(i, odometry_rate);
    const ros::Time recorded = stampAt(t + shift);
    const auto odometry = odometryAt(scenario, t);
    if (scenario.looped) bag.write("/clock", recorded, clockAt(t));
    bag.write("/tf", recorded, transformsFrom(scenario, odometry));
    bag.write("odom", recorded, odometry);
    if (i % kOdometryPerObstacles == 0 && !isSilent(scenario, t))
      bag.write("obstacles", recorded, obstaclesAt(scenario, options, t));
  }
}

/// A looped clock is a simulator's, so that the recorder has another: later by a minute.
void writeMessages(const Scenario& scenario, const ScenarioOptions& options, rosbag::Bag& bag) {
  constexpr double kOtherClock = 60;  // [s]
  if (!scenario.looped) return writeRound(scenario, options, 0, bag);
  writeRound(scenario, options, kOtherClock, bag);
  writeRound(scenario, options, kOtherClock + options.duration + kLoopPause, bag);
}

}  // namespace

std::vector<double> obstacleTimes(const Scenario& scenario, const ScenarioOptions& options) {
  const double odometry_rate = options.rate * kOdometryPerObstacles;
  std::vector<double> times;
  for (long i = 0; i < countUntil(options.duration, odometry_rate); i += kOdometryPerObstacles) {
    const double t = timeOf(i, odometry_rate);
    if (!isSilent(scenario, t)) times.push_back(t);
  }
  return times;
}

ros::Time stampAt(double t) {
  return ros::Time(kStartSecond, 0) +
         ros::Duration().fromNSec(static_cast<std::int64_t>(std::llround(1e9 * t)));
}

void writeBag(const Scenario& scenario, const ScenarioOptions& options, const std::string& path) {
  PartialFile file(path);
  auto bag = std::make_unique<rosbag::Bag>();
  try {
    bag->open(file.partialPath(), rosbag::bagmode::Write);
    writeMessages(scenario, options, *bag);
    bag->close();
  } catch (const rosbag::BagException& error) {
    // Its destructor would try to close again, throw, and so end the process without a word.
    static_cast<void>(bag.release());
    throw WriteError("cannot write " + path + ": " + error.what() + " (is the disk full?)");
  }
  file.finish();
}

}  // namespace footprint_collision_predictor::tools
