// What RViz shows of a warning: who touches what, when and where.
#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <vector>

#include "footprint_collision_predictor/CollisionWarning.h"
#include "footprint_collision_predictor/predictor.hpp"
#include "footprint_collision_predictor/warning.hpp"
#include "scene.hpp"

namespace footprint_collision_predictor {

/// How long [s] RViz shows a picture that is not renewed, so that a dead node leaves none.
constexpr double kMarkerLifetime = 1.0;

/// Obstacles drawn at most: those that matter, then the nearest.
constexpr std::size_t kMostObstaclesDrawn = 200;

/// All at the moment of the warning's stamp, in the footprint's frame.
struct Picture {
  const CollisionWarning& warning;
  const core::Thresholds& thresholds;
  const core::Polygon* footprint;  ///< null: not known
  core::Twist twist;
  std::vector<core::Obstacle> obstacles;
  core::Prediction prediction;  ///< without segments: nothing could be evaluated
};

/// The picture as markers. Always the same namespaces and ids, updated in place, with DELETE for
/// what is not there: so nothing flickers and nothing is left over. Every number is finite.
///
/// The stamp is 0, "as new as tf has it": a stamp of now would have RViz wait for transforms.
visualization_msgs::MarkerArray markers(const Picture& picture);

/// The same, with the scene carried on to the warning's stamp and predicted from there.
/// \param scene null when nothing can be evaluated
/// \param footprint null when not known
visualization_msgs::MarkerArray markers(const CollisionWarning& warning, const Scene* scene,
                                        const core::Polygon* footprint,
                                        const core::Thresholds& thresholds);

}  // namespace footprint_collision_predictor
