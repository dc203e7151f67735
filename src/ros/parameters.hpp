// The node's private parameters: one struct with the defaults in place, validated together.
#pragma once

#include <xmlrpcpp/XmlRpcValue.h>

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>

#include "footprint_collision_predictor/polygon.hpp"
#include "footprint_collision_predictor/warning.hpp"

namespace footprint_collision_predictor {

enum class EgoMotion { kOdom, kStatic };
enum class ObstacleVelocity { kOverGround, kRelative };
enum class ObstacleDetectorRadius { kTrueRadius, kRadius };

struct Parameters {
  std::optional<core::Polygon> footprint;  ///< in base_frame [m]; nothing: taken from the topic
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

}  // namespace footprint_collision_predictor
