// Box2D's b2TimeOfImpact: conservative advancement along separating axes, in float.
#pragma once

#include <box2d/b2_time_of_impact.h>

#include <vector>

#include "score.hpp"

namespace footprint_collision_predictor::bench {

/// The footprint stands still, the disc sweeps in a straight line. Inputs that do not change are
/// set up once. A concave footprint is several proxies, as its manual has it for concave bodies.
class Box2dPeer {
 public:
  /// It aims for its target gap to within a quarter of b2_linearSlop; the rest is float.
  static constexpr Tolerance kTolerance{2e-3, 2e-3, 1e-3};

  explicit Box2dPeer(const std::vector<Polygon>& convex_parts);
  Box2dPeer(const Box2dPeer&) = delete;  // the proxies point into vertices_
  Box2dPeer& operator=(const Box2dPeer&) = delete;

  double firstContact(const Motion& circle, double radius);

 private:
  std::vector<std::vector<b2Vec2>> vertices_;
  std::vector<b2DistanceProxy> parts_;
  b2Vec2 centre_;
  b2TOIInput input_;
};

}  // namespace footprint_collision_predictor::bench
