#include "fcl_peer.hpp"

#include <fcl/geometry/shape/convex.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/narrowphase/continuous_collision.h>

#include <algorithm>
#include <vector>

namespace footprint_collision_predictor::bench {
namespace {

using fcl::Vector3d;

constexpr double kHalfHeight = 2;  // more than any radius: only walls are near the middle plane

/// Vertex i below is 2 i, above it 2 i + 1.
std::vector<Vector3d> corners(const Polygon& footprint) {
  std::vector<Vector3d> result;
  for (const Vec2& v : footprint.vertices())
    for (const double z : {-kHalfHeight, kHalfHeight}) result.emplace_back(v.x(), v.y(), z);
  return result;
}

std::shared_ptr<fcl::CollisionGeometryd> prism(const Polygon& footprint) {
  const int n = static_cast<int>(footprint.size());
  std::vector<int> bottom{n}, top{n}, faces;
  for (int i = 0; i < n; ++i) {
    const int next = (i + 1) % n;
    faces.insert(faces.end(), {4, 2 * i, 2 * next, 2 * next + 1, 2 * i + 1});
    bottom.push_back(2 * (n - 1 - i));
    top.push_back(2 * i + 1);
  }
  faces.insert(faces.end(), bottom.begin(), bottom.end());
  faces.insert(faces.end(), top.begin(), top.end());
  return std::make_shared<fcl::Convexd>(
      std::make_shared<const std::vector<Vector3d>>(corners(footprint)), n + 2,
      std::make_shared<const std::vector<int>>(faces), true);
}

fcl::TranslationMotiond motion(const Vec2& from, const Vec2& to) {
  return {fcl::Matrix3d::Identity(), Vector3d(from.x(), from.y(), 0), Vector3d(to.x(), to.y(), 0)};
}

// The default is ten naive steps; conservative advancement is what it has for exact times. Of its
// two solvers of distances this one is as fast here and the more accurate.
const fcl::ContinuousCollisionRequestd kRequest(10, 1e-4, fcl::CCDM_TRANS, fcl::GST_INDEP,
                                                fcl::CCDC_CONSERVATIVE_ADVANCEMENT);

}  // namespace

FclPeer::FclPeer(const std::vector<Polygon>& convex_parts) : still_(motion({0, 0}, {0, 0})) {
  for (const Polygon& part : convex_parts) prisms_.push_back(prism(part));
}

double FclPeer::firstContact(const Motion& circle, double radius) const {
  fcl::Sphered ball(radius);
  double first = kNever;
  for (const auto& prism : prisms_) {
    // A motion remembers how far it was followed, so each part needs a new one.
    const auto moving = motion(circle.position, circle.positionAt(kHorizon));
    fcl::ContinuousCollisionResultd result;
    fcl::continuousCollide<double>(prism.get(), &still_, &ball, &moving, kRequest, result);
    if (result.is_collide) first = std::min(first, kHorizon * result.time_of_contact);
  }
  return first;
}

}  // namespace footprint_collision_predictor::bench
