// FCL's continuousCollide by conservative advancement.
#pragma once

#include <fcl/geometry/collision_geometry.h>
#include <fcl/math/motion/motion_base.h>

#include <memory>
#include <vector>

#include "score.hpp"

namespace footprint_collision_predictor::bench {

/// A prism on the footprint against a ball in its middle plane, where the nearest points lie in
/// that plane: the plane's answers. The geometry and the motion of a footprint that stands still
/// are set up once; one that turns does so about the point of the ground about which its twist
/// turns it.
class FclPeer {
 public:
  /// It ends when a step is shorter than 1e-4 of the horizon, so up to that much path too early;
  /// its distances are good to 1e-6 m.
  static constexpr Tolerance kTolerance{1e-5, 1e-3, 1e-3};

  /// Each part is an fcl::Convex, since conservative advancement of meshes misses what does not
  /// touch at once (FCL's issue 120).
  explicit FclPeer(const Scene& scene);

  double firstContact(const Disc& disc) const;

 private:
  std::vector<std::shared_ptr<fcl::CollisionGeometryd>> prisms_;
  Twist twist_;
};

}  // namespace footprint_collision_predictor::bench
