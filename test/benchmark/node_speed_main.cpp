// Sends obstacles messages, 100 a second each (with odometry 20), in turn to a bare relay
// (relay/obstacles, which comes back on relay/answer) and to the predictor (predictor/obstacles,
// predictor/answer), and prints how long each answer took, as JSON; before that "begin", when all
// is connected and warm.
#include <nav_msgs/Odometry.h>
#include <nodelet/loader.h>
#include <ros/init.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <optional>
#include <thread>

#include "crowd.hpp"
#include "path.hpp"
#include "relay_nodelet.hpp"

namespace footprint_collision_predictor::bench {
namespace {

constexpr int kWarmUp = 100;  // messages
constexpr std::chrono::milliseconds kHalfPeriod(5);
constexpr std::chrono::milliseconds kLongHalfPeriod(25);  // longer than odometry is waited for
constexpr double kOdometryPeriod = 0.0193;  // [s] in every phase to the messages in turn

struct Options {
  std::size_t obstacles = 1000;
  int messages = 500;
  bool nodelets = false;
  bool odometry = false;
};

/// Relay and predictor in this process; the predictor's parameters are on the server already.
class Nodelets {
 public:
  Nodelets()
      : relays_(Create([](const std::string&) { return boost::make_shared<RelayNodelet>(); })),
        predictors_(false) {
    relays_.load("/relay", "", {}, {});
    const nodelet::M_string topics = {{"/obstacles", "/predictor/obstacles"},
                                      {"/collision_warning", "/predictor/answer"}};
    if (!predictors_.load("/predictor_nodelet", "footprint_collision_predictor/Predictor", topics,
                          {}))
      throw std::runtime_error("the predictor's nodelet cannot be loaded");
  }

 private:
  using Create = boost::function<boost::shared_ptr<nodelet::Nodelet>(const std::string&)>;

  nodelet::Loader relays_, predictors_;
};

/// At about 50 Hz, as a robot's base sends it, without regard to when obstacles come.
class OdometryFeed {
 public:
  OdometryFeed()
      : publisher_(ros::NodeHandle().advertise<nav_msgs::Odometry>("predictor/odom", 10)),
        timer_(ros::NodeHandle().createWallTimer(ros::WallDuration(kOdometryPeriod),
                                                 [this](const ros::WallTimerEvent&) { send(); })) {}

 private:
  void send() const {
    nav_msgs::Odometry odometry;
    odometry.header.stamp = ros::Time::now();
    odometry.header.frame_id = "odom";
    odometry.child_frame_id = "base_link";
    odometry.twist.twist.linear.x = 0.5;
    odometry.twist.twist.angular.z = 0.2;
    publisher_.publish(odometry);
  }

  ros::Publisher publisher_;
  ros::WallTimer timer_;
};

nlohmann::json measured(const Options& options) {
  Path relay("relay", options.nodelets), predictor("predictor", options.nodelets);
  ObstacleArray message = crowd(options.obstacles);
  for (Path* path : {&relay, &predictor}) path->waitConnected(message);
  nlohmann::json result = {{"relay", nlohmann::json::array()},
                           {"predictor", nlohmann::json::array()}};
  const auto half_period = options.odometry ? kLongHalfPeriod : kHalfPeriod;
  auto next = std::chrono::steady_clock::now();
  for (int i = -kWarmUp; i < options.messages; ++i) {
    if (i == 0) {
      std::puts("begin");
      std::fflush(stdout);
    }
    for (Path* path : {&relay, &predictor}) {
      std::this_thread::sleep_until(next += half_period);
      const double seconds = path->measure(message);
      if (i >= 0) result[path->name()].push_back(seconds);
    }
  }
  return result;
}

}  // namespace
}  // namespace footprint_collision_predictor::bench

int main(int argc, char** argv) try {
  using namespace footprint_collision_predictor::bench;
  ros::init(argc, argv, "node_speed_test", ros::init_options::AnonymousName);
  Options options;
  CLI::App app("Measures the time from an obstacles message to the warning, beside a bare relay.");
  app.add_option("--obstacles", options.obstacles, "in each message");
  app.add_option("--messages", options.messages, "to each of the two");
  app.add_flag("--nodelets", options.nodelets, "load relay and predictor into this process");
  app.add_flag("--odometry", options.odometry, "publish predictor/odom at 50 Hz");
  CLI11_PARSE(app, argc, argv);
  ros::AsyncSpinner spinner(1);
  spinner.start();
  std::optional<Nodelets> nodelets;
  if (options.nodelets) nodelets.emplace();
  std::optional<OdometryFeed> odometry;
  if (options.odometry) odometry.emplace();
  std::puts(measured(options).dump().c_str());
} catch (const std::exception& error) {
  std::fprintf(stderr, "node_speed_test: %s\n", error.what());
  return 1;
}
