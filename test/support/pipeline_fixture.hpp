// Drives a Pipeline with messages and clocks of the test's own: no master, no threads, no waiting.
#pragma once

#include <gtest/gtest.h>
#include <nav_msgs/Odometry.h>
#include <ros/serialization.h>

#include <cmath>
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
      pipeline_.emplace(parameters, bodiesOf(parameters).front(),
                        InputNames{"/obstacles", "/footprint", "/odom"}, tf, simulated,
                        [this](const Answer& answer) {
                          warnings.push_back(answer.warning);
                          if (answer.prediction) predictions.push_back(*answer.prediction);
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

  /// A square of the given half side, about the origin of the frame.
  void sendFootprint(double now, double stamp, float half, const std::string& frame = "base_link") {
    geometry_msgs::PolygonStamped footprint;
    footprint.header.stamp = ros::Time(stamp);
    footprint.header.frame_id = frame;
    for (const auto& [x, y] :
         {std::pair{half, half}, {-half, half}, {-half, -half}, {half, -half}}) {
      geometry_msgs::Point32 vertex;
      vertex.x = x;
      vertex.y = y;
      footprint.polygon.points.push_back(vertex);
    }
    pipeline().receiveFootprint(serialized(footprint), at(now));
  }

  void setTransform(const std::string& parent, const std::string& child, double stamp, double x,
                    double y, double yaw, bool fixed = false) {
    geometry_msgs::TransformStamped t;
    t.header.frame_id = parent;
    t.header.stamp = ros::Time(stamp);
    t.child_frame_id = child;
    t.transform.translation.x = x;
    t.transform.translation.y = y;
    t.transform.rotation.z = std::sin(yaw / 2);
    t.transform.rotation.w = std::cos(yaw / 2);
    tf.setTransform(t, "test", fixed);
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
