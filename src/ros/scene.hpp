// One moment's inputs, brought to one time and one frame; ready to be predicted, then and a little
// later.
#pragma once

#include <tf2/buffer_core.h>

#include <optional>
#include <vector>

#include "conversions.hpp"
#include "moment.hpp"
#include "motion_source.hpp"
#include "odometry_history.hpp"
#include "parameters.hpp"

namespace footprint_collision_predictor {

struct Scene {
  ros::Time stamp;
  ros::SteadyTime arrived;
  core::Polygon footprint;
  core::Twist twist;
  /// How far ahead the motions hold [s]: 0 when the footprint's motion is not known, since only
  /// what touches now is certain then.
  double horizon;
  MotionSource motion;
  SceneObstacles obstacles;
  std::uint32_t obstacle_count;
  Findings findings;
};

/// \param arrived when the message arrived
/// \param footprint of the body
/// \throws TransformError when the obstacles cannot be brought into the body's frame
Scene makeScene(const ObstacleArray& message, const ros::SteadyTime& arrived,
                const core::Polygon& footprint, const OdometryHistory& odometry,
                const tf2::BufferCore& tf, const Parameters& parameters, const Body& body);

/// The obstacles as they are `dt` [s] after the scene's stamp, in the footprint's frame of then.
std::vector<core::Obstacle> carriedOn(const Scene& scene, double dt);

}  // namespace footprint_collision_predictor
