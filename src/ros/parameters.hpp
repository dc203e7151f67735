// The node's private parameters: one struct with the defaults in place, validated together.
#pragma once

#include <xmlrpcpp/XmlRpcValue.h>

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "footprint_collision_predictor/polygon.hpp"
#include "footprint_collision_predictor/warning.hpp"

namespace footprint_collision_predictor {

enum class EgoMotion { kOdom, kStatic };
/// Where the motion of a body comes from. Odometry is carried over rigidly to the body's frame;
/// from tf it is that of the body's frame over fixed_frame.
enum class BodyMotion { kOdom, kTf, kStatic };
enum class ObstacleVelocity { kOverGround, kRelative };
enum class ObstacleDetectorRadius { kTrueRadius, kRadius };

/// A rigid part of the robot with a footprint of its own.
struct Body {
  std::string name;
  std::string frame;
  std::optional<core::Polygon> footprint;  ///< in its frame [m]; nothing: taken from the topic
  std::string topic;                       ///< of the footprint
  BodyMotion motion;
};

struct Parameters {
  std::optional<core::Polygon> footprint;  ///< in base_frame [m]; nothing: taken from the topic
  std::vector<Body> footprints;  ///< of a robot of several bodies; empty: footprint counts
  std::string base_frame = "base_link";
  std::string fixed_frame = "odom";
  double horizon = 5;  ///< [s]
  core::Thresholds thresholds{3, 1.5};
  double max_data_age = 0.5;         ///< [s]
  double transform_tolerance = 0.1;  ///< [s]
  double heartbeat_rate = 20;        ///< [Hz]
  std::size_t clear_after = 3;       ///< messages
  EgoMotion ego_motion = EgoMotion::kOdom;
  ObstacleVelocity obstacle_velocity = ObstacleVelocity::kOverGround;
  ObstacleDetectorRadius obstacle_detector_radius = ObstacleDetectorRadius::kTrueRadius;
  std::size_t max_obstacles = 10000;
  std::size_t max_vertices = 1000;
};

/// what() names every wrong parameter, its value, and what is allowed.
class ParameterError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// \param values the struct of all direct children of "~"; invalid (unset) when there are none
/// \throws ParameterError when any is wrong, unknown, or contradicts another; nothing falls back to
/// a
///     default because it was wrong
Parameters parametersFrom(const XmlRpc::XmlRpcValue& values);

/// At least one: those of footprints, else the base alone, named "footprint".
std::vector<Body> bodiesOf(const Parameters& parameters);

/// Whether what the body may touch cannot be told without odometry: for its own motion, or for that
/// of the base, from which relative velocities are seen.
bool needsOdometry(const Parameters& parameters, const Body& body);

}  // namespace footprint_collision_predictor
