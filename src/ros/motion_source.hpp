// Where the motions come from that a prediction assumes.
#pragma once

#include <optional>

#include "odometry_history.hpp"

namespace footprint_collision_predictor {

/// Empty for what stands still.
struct MotionSource {
  std::optional<OdometrySample> odometry;
  std::optional<ros::Time> transforms;  ///< the newest used of the body's frame over fixed_frame
};

}  // namespace footprint_collision_predictor
