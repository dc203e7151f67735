#include "box2d_peer.hpp"

#include <algorithm>

namespace footprint_collision_predictor::bench {
namespace {

b2Vec2 toBox2d(const Vec2& v) { return {static_cast<float>(v.x()), static_cast<float>(v.y())}; }

b2Sweep translation(const Vec2& from, const Vec2& to) {
  b2Sweep sweep;
  sweep.localCenter.SetZero();
  sweep.c0 = toBox2d(from);
  sweep.c = toBox2d(to);
  sweep.a0 = sweep.a = sweep.alpha0 = 0;
  return sweep;
}

b2Sweep rotation(const Twist& twist) {
  const Vec2 centre = core::leftNormal(twist.linear) / twist.angular;
  b2Sweep sweep = translation(centre, centre);
  sweep.localCenter = toBox2d(centre);
  sweep.a = static_cast<float>(kHorizon * twist.angular);
  return sweep;
}

}  // namespace

Box2dPeer::Box2dPeer(const Scene& scene) : obstacle_(1, b2Vec2(0, 0)) {
  for (const Polygon& part : scene.convex_parts) {
    vertices_.emplace_back();
    for (const Vec2& vertex : part.vertices()) vertices_.back().push_back(toBox2d(vertex));
    parts_.emplace_back();
    parts_.back().Set(vertices_.back().data(), static_cast<int>(part.size()), 0);
  }
  const bool turns = scene.twist.angular != 0;
  input_.sweepA = turns ? rotation(scene.twist) : translation({0, 0}, {0, 0});
  input_.tMax = 1;
}

double Box2dPeer::firstContact(const Disc& disc, const std::vector<Vec2>& outline) {
  if (!outline.empty()) obstacle_.resize(outline.size());
  std::transform(outline.begin(), outline.end(), obstacle_.begin(), toBox2d);
  // It stops when the shapes overlap by three slops; the disc grows by these, so that what it
  // aims for is the true contact.
  input_.proxyB.Set(obstacle_.data(), static_cast<int>(obstacle_.size()),
                    static_cast<float>(disc.radius) + 3 * b2_linearSlop);
  input_.sweepB = translation(disc.motion.position, disc.motion.positionAt(kHorizon));
  double first = kNever;
  for (const b2DistanceProxy& part : parts_) {
    input_.proxyA = part;
    b2TOIOutput output;
    b2TimeOfImpact(&output, &input_);
    if (output.state == b2TOIOutput::e_separated) continue;
    // Also where it gave up (e_failed): up to there it has shown that nothing touches.
    const bool now = output.state == b2TOIOutput::e_overlapped;
    first = std::min(first, now ? 0 : kHorizon * static_cast<double>(output.t));
  }
  return first;
}

}  // namespace footprint_collision_predictor::bench
