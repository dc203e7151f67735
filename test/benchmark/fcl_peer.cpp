#include "fcl_peer.hpp"

#include <fcl/geometry/shape/convex.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/math/motion/interp_motion.h>
#include <fcl/math/motion/translation_motion.h>
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

Vector3d toFcl(const Vec2& v) { return {v.x(), v.y(), 0}; }

fcl::TranslationMotiond translation(const Vec2& from, const Vec2& to) {
  return {fcl::Matrix3d::Identity(), toFcl(from), toFcl(to)};
}

fcl::InterpMotion<double> rotation(const Twist& twist) {
  const Pose pose = poseAt(twist, kHorizon);
  fcl::Matrix3d turn;
  turn << pose.cosine, -pose.sine, 0, pose.sine, pose.cosine, 0, 0, 0, 1;
  return {fcl::Matrix3d::Identity(), Vector3d::Zero(), turn, toFcl(pose.position),
          toFcl(core::leftNormal(twist.linear) / twist.angular)};
}

// The default is ten naive steps; conservative advancement is what it has for exact times. Of its
// two solvers of distances this one is as fast here and the more accurate.
const fcl::ContinuousCollisionRequestd kRequest(10, 1e-4, fcl::CCDM_TRANS, fcl::GST_INDEP,
                                                fcl::CCDC_CONSERVATIVE_ADVANCEMENT);
const fcl::TranslationMotiond kStill = translation({0, 0}, {0, 0});

}  // namespace

FclPeer::FclPeer(const Scene& scene) : twist_(scene.twist) {
  for (const Polygon& part : scene.convex_parts) prisms_.push_back(prism(part));
}

double FclPeer::firstContact(const Disc& disc) const {
  fcl::Sphered ball(disc.radius);
  double first = kNever;
  for (const auto& prism : prisms_) {
    // A motion remembers how far it was followed, so each part needs a new one.
    const auto moving = translation(disc.motion.position, disc.motion.positionAt(kHorizon));
    fcl::ContinuousCollisionResultd result;
    if (twist_.angular == 0) {
      fcl::continuousCollide<double>(prism.get(), &kStill, &ball, &moving, kRequest, result);
    } else {
      const auto turning = rotation(twist_);
      fcl::continuousCollide<double>(prism.get(), &turning, &ball, &moving, kRequest, result);
    }
    if (result.is_collide) first = std::min(first, kHorizon * result.time_of_contact);
  }
  return first;
}

}  // namespace footprint_collision_predictor::bench
