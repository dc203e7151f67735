// FCL's continuousCollide by conservative advancement.
#pragma once

#include <fcl/geometry/collision_geometry.h>
#include <fcl/math/motion/translation_motion.h>

#include <memory>

#include "score.hpp"

namespace footprint_collision_predictor::bench {

/// A prism on the footprint against a ball in its middle plane, where the nearest points lie in
/// that plane: the plane's answers. The geometry and the motion of the footprint are set up once.
class FclPeer {
 public:
  /// It ends when a step is shorter than 1e-4 of the horizon, so up to that much path too early;
  /// libccd's distances are good to 1e-6 m.
  static constexpr Tolerance kTolerance{1e-5, 1e-3, 1e-3};

  /// A convex footprint is fcl::Convex, its fastest; a concave one a mesh of its walls.
  FclPeer(const Polygon& footprint, bool convex);

  double firstContact(const Motion& circle, double radius) const;

 private:
  std::shared_ptr<fcl::CollisionGeometryd> prism_;
  fcl::TranslationMotiond still_;
};

}  // namespace footprint_collision_predictor::bench
