#include "box2d_peer.hpp"

#include <algorithm>

namespace footprint_collision_predictor::bench {
namespace {

b2Vec2 toBox2d(const Vec2& v) { return {static_cast<float>(v.x()), static_cast<float>(v.y())}; }

b2Sweep sweep(const Vec2& from, const Vec2& to) {
  b2Sweep result;
  result.localCenter.SetZero();
  result.c0 = toBox2d(from);
  result.c = toBox2d(to);
  result.a0 = result.a = result.alpha0 = 0;
  return result;
}

}  // namespace

Box2dPeer::Box2dPeer(const std::vector<Polygon>& convex_parts) : centre_(0, 0) {
  for (const Polygon& part : convex_parts) {
    vertices_.emplace_back();
    for (const Vec2& vertex : part.vertices()) vertices_.back().push_back(toBox2d(vertex));
    parts_.emplace_back();
    parts_.back().Set(vertices_.back().data(), static_cast<int>(part.size()), 0);
  }
  input_.sweepA = sweep({0, 0}, {0, 0});
  input_.tMax = 1;
}

double Box2dPeer::firstContact(const Motion& circle, double radius) {
  // It stops when the shapes overlap by three slops; the disc grows by these, so that what it
  // aims for is the true contact.
  input_.proxyB.Set(&centre_, 1, static_cast<float>(radius) + 3 * b2_linearSlop);
  input_.sweepB = sweep(circle.position, circle.positionAt(kHorizon));
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
