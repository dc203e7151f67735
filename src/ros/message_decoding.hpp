// The messages the node takes in, decoded from raw bytes. Every obstacle source becomes an
// ObstacleArray.
#pragma once

#include <geometry_msgs/PolygonStamped.h>
#include <nav_msgs/Odometry.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "footprint_collision_predictor/ObstacleArray.h"
#include "parameters.hpp"
#include "raw_message.hpp"
#include "wire_reader.hpp"

namespace footprint_collision_predictor {

/// Thrown for a type that the topic is not meant to carry; what() names it and those that fit.
class UnknownType : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Thrown for more obstacles or vertices than allowed.
class LimitExceeded : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A type by its name and the md5 sum of the version that is understood.
struct MessageType {
  std::string name;
  std::string md5;
};

/// Those that decodeObstacles takes.
std::vector<MessageType> obstacleTypes();

/// Takes footprint_collision_predictor/ObstacleArray, obstacle_detector/Obstacles (circles first,
/// then line segments as outlines) and costmap_converter/ObstacleArrayMsg (one vertex: a circle;
/// more: an outline). The values are not validated. \throws UnknownType, MalformedMessage,
/// LimitExceeded
ObstacleArray decodeObstacles(const RawMessage& message, const Parameters& parameters);

/// \throws UnknownType, MalformedMessage, LimitExceeded
geometry_msgs::PolygonStamped decodeFootprint(const RawMessage& message, std::size_t max_vertices);

/// Without its covariances, which are left 0.
/// \throws UnknownType, MalformedMessage
nav_msgs::Odometry decodeOdometry(const RawMessage& message);

}  // namespace footprint_collision_predictor
