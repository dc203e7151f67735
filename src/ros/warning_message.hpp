// Fills the two messages that go out.
#pragma once

#include "findings.hpp"
#include "footprint_collision_predictor/CollisionPrediction.h"
#include "footprint_collision_predictor/CollisionWarning.h"
#include "footprint_collision_predictor/warning.hpp"
#include "parameters.hpp"
#include "scene.hpp"

namespace footprint_collision_predictor {

/// A scene and what was predicted from it.
struct Evaluated {
  const Scene& scene;
  core::Prediction prediction;
};

/// \param evaluated null when nothing could be evaluated
/// \param findings all that is known to be wrong
CollisionWarning warningMsg(const Evaluated* evaluated, const ros::Time& stamp, core::Level level,
                            const Findings& findings, const Parameters& parameters);

/// \param findings as for the warning: with an UNKNOWN reason, segments without a certain contact
/// read
///     as unknown
CollisionPrediction predictionMsg(const Evaluated& evaluated, const Findings& findings,
                                  const Parameters& parameters);

}  // namespace footprint_collision_predictor
