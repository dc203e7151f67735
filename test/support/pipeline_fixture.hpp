// Drives a Pipeline with messages and clocks of the test's own: no master, no threads, no waiting.
#pragma once

#include <gtest/gtest.h>
#include <nav_msgs/Odometry.h>
#include <ros/serialization.h>

#include <string>
#include <vector>

#include "pipeline.hpp"

namespace footprint_collision_predictor {

template <typename Message>
RawMessage serialized(const Message& message) {
  RawMessage raw{ros::message_traits::DataType<Message>::value(),
                 ros::message_traits::MD5Sum<Message>::value(),
                 std::vector<std::uint8_t>(ros::serialization::serializationLength(message))};
  ros::serialization::OStream stream(raw.bytes.data(),
                                     static_cast<std::uint32_t>(raw.bytes.size()));
  ros::serialization::serialize(stream, message);
  return raw;
}

/// A circle on the x axis, coming towards the origin when speed > 0.
inline Obstacle circleAhead(double x, double speed, double radius = 0.5) {
  Obstacle circle;
  circle.id = 7;
  circle.position.x = x;
  circle.velocity.x = -speed;
  circle.radius = radius;
  return circle;
}

inline core::Polygon squareOfOneMetre() {
  return core::Polygon({{0.5, 0.5}, {-0.5, 0.5}, {-0.5, -0.5}, {0.5, -0.5}});  // front: segment 3
}

class PipelineFixture : public testing::Test {
 protected:
  PipelineFixture() {
    parameters.footprint = squareOfOneMetre();
    parameters.ego_motion = EgoMotion::kStatic;
  }

  /// Made at the first use, so that a test can change the parameters before.
  Pipeline& pipeline() {
    if (!pipeline_)
      pipeline_.emplace(parameters, InputNames{"/obstacles", "/footprint", "/odom"}, tf, simulated,
                        [this](const CollisionWarning& warning,
                               const std::optional<CollisionPrediction>& prediction) {
                          warnings.push_back(warning);
                          if (prediction) predictions.push_back(*prediction);
                        });
    return *pipeline_;
  }

  static Moment at(double seconds) { return {ros::Time(seconds), ros::SteadyTime(seconds)}; }

  /// Sends obstacles stamped now, in base_link.
  CollisionWarning send(double now, const std::vector<Obstacle>& obstacles) {
    return send(now, now, obstacles);
  }

  CollisionWarning send(double now, double stamp, const std::vector<Obstacle>& obstacles,
                        const std::string& frame = "base_link") {
    ObstacleArray array;
    array.header.frame_id = frame;
    array.header.stamp = ros::Time(stamp);
    array.obstacles = obstacles;
    pipeline().receiveObstacles(serialized(array), at(now));
    return warnings.empty() ? CollisionWarning() : warnings.back();
  }

  void sendOdometry(double now, double vx, double yaw_rate = 0) {
    sendOdometry(now, now, vx, yaw_rate);
  }

  void sendOdometry(double now, double stamp, double vx, double yaw_rate) {
    nav_msgs::Odometry odometry;
    odometry.header.stamp = ros::Time(stamp);
    odometry.child_frame_id = "base_link";
    odometry.twist.twist.linear.x = vx;
    odometry.twist.twist.angular.z = yaw_rate;
    pipeline().receiveOdometry(serialized(odometry), at(now));
  }

  Parameters parameters;
  bool simulated = false;
  tf2::BufferCore tf;
  std::vector<CollisionWarning> warnings;
  std::vector<CollisionPrediction> predictions;

 private:
  std::optional<Pipeline> pipeline_;
};

}  // namespace footprint_collision_predictor
