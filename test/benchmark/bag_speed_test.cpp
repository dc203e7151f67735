// An hour of a robot among people as a bag, and what merely reading such a bag takes.
#include <footprint_collision_predictor/ObstacleArray.h>
#include <nav_msgs/Odometry.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <tf2_msgs/TFMessage.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

#include "random_numbers.hpp"

namespace {

using namespace footprint_collision_predictor;

constexpr int kObstaclesRate = 10;  // [Hz]
constexpr int kOdometryRate = 50;   // [Hz] of odometry and tf, as a robot's base has
constexpr std::size_t kPeople = 20;
constexpr double kHall = 10;    // [m] people stay within so much of the robot
constexpr double kSpeed = 0.5;  // [m/s] of the robot

/// Someone who walks to and fro in one coordinate, as seen from the robot.
struct Pacing {
  double phase;  // [m] of the way
  double speed;  // [m/s]

  double way(double t) const {
    return std::fmod(phase + speed * t, 4 * kHall);  // there and back
  }
  double place(double t) const {
    const double w = way(t);
    return w < 2 * kHall ? w - kHall : 3 * kHall - w;
  }
  double velocity(double t) const { return way(t) < 2 * kHall ? speed : -speed; }
};

struct Person {
  Pacing x;
  Pacing y;
};

std::vector<Person> people() {
  tools::RandomNumbers random(1);
  std::vector<Person> all;
  const auto pacing = [&] {
    return Pacing{random.uniform(0, 4 * kHall), random.uniform(0.1, 1.2)};
  };
  for (std::size_t i = 0; i < kPeople; ++i) all.push_back({pacing(), pacing()});
  return all;
}

ros::Time stampOf(long i) {
  return {1600000000u + static_cast<unsigned>(i / kOdometryRate),
          static_cast<unsigned>(i % kOdometryRate) * (1000000000u / kOdometryRate)};
}

nav_msgs::Odometry odometryAt(long i) {
  nav_msgs::Odometry odometry;
  odometry.header.stamp = stampOf(i);
  odometry.header.frame_id = "odom";
  odometry.child_frame_id = "base_link";
  odometry.pose.pose.position.x = kSpeed * static_cast<double>(i) / kOdometryRate;
  odometry.pose.pose.orientation.w = 1;
  odometry.twist.twist.linear.x = kSpeed;
  return odometry;
}

tf2_msgs::TFMessage transformFrom(const nav_msgs::Odometry& odometry) {
  tf2_msgs::TFMessage message;
  message.transforms.resize(1);
  message.transforms[0].header = odometry.header;
  message.transforms[0].child_frame_id = odometry.child_frame_id;
  message.transforms[0].transform.translation.x = odometry.pose.pose.position.x;
  message.transforms[0].transform.rotation.w = 1;
  return message;
}

ObstacleArray obstaclesAt(long i, const std::vector<Person>& all) {
  const double t = static_cast<double>(i) / kOdometryRate;
  ObstacleArray message;
  message.header.stamp = stampOf(i);
  message.header.frame_id = "odom";
  for (const Person& person : all) {
    Obstacle obstacle;
    obstacle.id = static_cast<std::int64_t>(message.obstacles.size());
    obstacle.position.x = kSpeed * t + person.x.place(t);
    obstacle.position.y = person.y.place(t);
    obstacle.velocity.x = kSpeed + person.x.velocity(t);
    obstacle.velocity.y = person.y.velocity(t);
    obstacle.radius = 0.3;
    message.obstacles.push_back(obstacle);
  }
  return message;
}

void write(const std::string& path, long messages) {
  const auto all = people();
  rosbag::Bag bag(path, rosbag::bagmode::Write);
  for (long i = 0; i < messages * kOdometryRate / kObstaclesRate; ++i) {
    const auto odometry = odometryAt(i);
    bag.write("/tf", odometry.header.stamp, transformFrom(odometry));
    bag.write("/odom", odometry.header.stamp, odometry);
    if (i % (kOdometryRate / kObstaclesRate) == 0)
      bag.write("/obstacles", odometry.header.stamp, obstaclesAt(i, all));
  }
}

template <typename Message>
bool deserializes(const rosbag::MessageInstance& message, std::size_t& count) {
  if (!message.instantiate<Message>()) return false;
  ++count;
  return true;
}

/// Every message once, as any program would that uses the bag library.
void read(const std::string& path) {
  const auto begin = std::chrono::steady_clock::now();
  std::size_t count = 0;
  rosbag::Bag bag(path, rosbag::bagmode::Read);
  rosbag::View view(bag);
  for (const rosbag::MessageInstance& message : view)
    deserializes<ObstacleArray>(message, count) ||
        deserializes<nav_msgs::Odometry>(message, count) ||
        deserializes<tf2_msgs::TFMessage>(message, count);
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
  std::printf("%zu messages in %.3f s\n", count, taken.count());
}

}  // namespace

int main(int argc, char** argv) {
  if (argc == 4 && std::strcmp(argv[1], "write") == 0)
    write(argv[2], std::atol(argv[3]));
  else if (argc == 3 && std::strcmp(argv[1], "read") == 0)
    read(argv[2]);
  else
    return std::fprintf(stderr, "usage: bag_speed_test write FILE MESSAGES | read FILE\n"), 2;
  return 0;
}
