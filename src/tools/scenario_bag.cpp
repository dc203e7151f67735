#include <footprint_collision_predictor/ObstacleArray.h>
#include <nav_msgs/Odometry.h>
#include <rosbag/bag.h>
#include <tf2_msgs/TFMessage.h>

#include <cmath>
#include <memory>

#include "scenario_writer.hpp"

namespace footprint_collision_predictor::tools {
namespace {

constexpr long kOdometryRate = 50;         // [Hz]
constexpr long kOdometryPerObstacles = 5;  // so 10 Hz
constexpr long kNanoseconds = 1'000'000'000;

ros::Time stampOf(long odometry_index) {
  const long ns = odometry_index * (kNanoseconds / kOdometryRate);
  return {kStartSecond + static_cast<unsigned>(ns / kNanoseconds),
          static_cast<unsigned>(ns % kNanoseconds)};
}

geometry_msgs::Quaternion headingQuaternion() {
  geometry_msgs::Quaternion q;
  q.z = std::sqrt((1 - kHeading.x) / 2);  // half angle; the heading is in the first quadrant
  q.w = std::sqrt((1 + kHeading.x) / 2);
  return q;
}

nav_msgs::Odometry odometryAt(const Scenario& scenario, double t, const ros::Time& stamp) {
  nav_msgs::Odometry odometry;
  odometry.header.stamp = stamp;
  odometry.header.frame_id = "odom";
  odometry.child_frame_id = "base_link";
  const Point position = robotPosition(scenario, t);
  odometry.pose.pose.position.x = position.x;
  odometry.pose.pose.position.y = position.y;
  odometry.pose.pose.orientation = headingQuaternion();
  odometry.twist.twist.linear.x = scenario.robot_speed;
  return odometry;
}

tf2_msgs::TFMessage transformFrom(const nav_msgs::Odometry& odometry) {
  geometry_msgs::TransformStamped transform;
  transform.header = odometry.header;
  transform.child_frame_id = odometry.child_frame_id;
  transform.transform.translation.x = odometry.pose.pose.position.x;
  transform.transform.translation.y = odometry.pose.pose.position.y;
  transform.transform.rotation = odometry.pose.pose.orientation;
  tf2_msgs::TFMessage message;
  message.transforms.push_back(transform);
  return message;
}

ObstacleArray obstaclesAt(const Scenario& scenario, double t, const ros::Time& stamp) {
  ObstacleArray message;
  message.header.stamp = stamp;
  message.header.frame_id = "odom";
  for (const auto& from : scenario.obstacles) {
    Obstacle obstacle;
    const Point position = obstaclePosition(scenario, from, t);
    const Point velocity = obstacleVelocity(scenario, from);
    obstacle.id = from.id;
    obstacle.position.x = position.x;
    obstacle.position.y = position.y;
    obstacle.velocity.x = velocity.x;
    obstacle.velocity.y = velocity.y;
    obstacle.radius = from.radius;
    message.obstacles.push_back(obstacle);
  }
  return message;
}

void writeMessages(const Scenario& scenario, double duration, rosbag::Bag& bag) {
  const long last = std::lround(std::floor(duration * kOdometryRate + 1e-6));
  for (long i = 0; i <= last; ++i) {
    const ros::Time stamp = stampOf(i);
    const double t = static_cast<double>(i) / kOdometryRate;
    const auto odometry = odometryAt(scenario, t, stamp);
    bag.write("/tf", stamp, transformFrom(odometry));
    bag.write("odom", stamp, odometry);
    if (i % kOdometryPerObstacles == 0)
      bag.write("obstacles", stamp, obstaclesAt(scenario, t, stamp));
  }
}

}  // namespace

void writeBag(const Scenario& scenario, double duration, const std::string& path) {
  PartialFile file(path);
  auto bag = std::make_unique<rosbag::Bag>();
  try {
    bag->open(file.partialPath(), rosbag::bagmode::Write);
    writeMessages(scenario, duration, *bag);
    bag->close();
  } catch (const rosbag::BagException& error) {
    // Its destructor would try to close again, throw, and so end the process without a word.
    static_cast<void>(bag.release());
    throw WriteError("cannot write " + path + ": " + error.what() + " (is the disk full?)");
  }
  file.finish();
}

}  // namespace footprint_collision_predictor::tools
