// FCL's continuousCollide by conservative advancement.
#pragma once

#include <fcl/geometry/collision_geometry.h>
#include <fcl/math/motion/translation_motion.h>

#include <memory>
#include <vector>

#include "score.hpp"

namespace footprint_collision_predictor::bench {

/// A prism on the footprint against a ball in its middle plane, where the nearest points lie in
/// that plane: the plane's answers. The geometry and the motion of the footprint are set up once.
class FclPeer {
 public:
  /// It ends when a step is shorter than 1e-4 of the horizon, so up to that much path too early;
  /// its distances are good to 1e-6 m.
  static constexpr Tolerance kTolerance{1e-5, 1e-3, 1e-3};

  /// Each part is an fcl::Convex, since conservative advancement of meshes misses what does not
  /// touch at once (FCL's issue 120).
  explicit FclPeer(const std::vector<Polygon>& convex_parts);

  double firstContact(const Motion& circle, double radius) const;

 private:
  std::vector<std::shared_ptr<fcl::CollisionGeometryd>> prisms_;
  fcl::TranslationMotiond still_;
};

}  // namespace footprint_collision_predictor::bench
