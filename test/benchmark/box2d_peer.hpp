// Box2D's b2TimeOfImpact: conservative advancement along separating axes, in float.
#pragma once

#include <box2d/b2_time_of_impact.h>

#include <vector>

#include "score.hpp"

namespace footprint_collision_predictor::bench {

/// The obstacle sweeps in a straight line. The footprint stands still, or turns about the point of
/// the ground about which its twist turns it, for which a sweep is no approximation: angle and
/// centre are linear in time. Inputs that do not change are set up once. A concave footprint is
/// several proxies, as its manual has it for concave bodies.
class Box2dPeer {
 public:
  /// It aims for its target gap to within a quarter of b2_linearSlop; the rest is float.
  static constexpr Tolerance kTolerance{2e-3, 2e-3, 1e-3};

  explicit Box2dPeer(const Scene& scene);
  Box2dPeer(const Box2dPeer&) = delete;  // the proxies point into vertices_
  Box2dPeer& operator=(const Box2dPeer&) = delete;

  double firstContact(const Disc& disc, const std::vector<Vec2>& outline);

 private:
  /// [0, 1] of the sweeps in input_, or kNever.
  double firstContactOfSweep();

  std::vector<std::vector<b2Vec2>> vertices_;
  std::vector<b2DistanceProxy> parts_;
  std::vector<b2Vec2> obstacle_;
  std::vector<b2Sweep> sweeps_;  ///< of the footprint, one piece of the horizon after the other
  double duration_;              ///< [s] of each
  b2TOIInput input_;
};

}  // namespace footprint_collision_predictor::bench
