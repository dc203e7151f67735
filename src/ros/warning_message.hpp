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
                            const Findings& findings, const Parameters& parameters,
                            const Body& body);

/// \param findings about the inputs: with an UNKNOWN reason, segments without a certain contact
/// read
///     as unknown. (REASON_SETTLING is about the level alone, so it is not among them.)
CollisionPrediction predictionMsg(const Evaluated& evaluated, const Findings& findings,
                                  const Parameters& parameters, const Body& body);

/// A warning as it is when it goes out some seconds after the moment for which it was made: its
/// data are older by then, and too old data make it UNKNOWN.
CollisionWarning olderBy(double seconds, CollisionWarning warning, const Parameters& parameters);

/// The same for an evaluation that took so long: beyond a period of the heartbeat it is UNKNOWN.
CollisionWarning finishedAfter(double seconds, CollisionWarning warning,
                               const Parameters& parameters);

}  // namespace footprint_collision_predictor
