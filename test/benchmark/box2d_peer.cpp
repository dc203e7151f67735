#include "box2d_peer.hpp"

#include <algorithm>
#include <cmath>

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

b2Sweep rotation(const Twist& twist, double from, double to) {
  const Vec2 centre = core::leftNormal(twist.linear) / twist.angular;
  b2Sweep sweep = translation(centre, centre);
  sweep.localCenter = toBox2d(centre);
  sweep.a0 = static_cast<float>(from * twist.angular);
  sweep.a = static_cast<float>(to * twist.angular);
  return sweep;
}

// It "may miss some intermediate, non-tunneling collisions" of what turns, says its header, and to
// call it for shorter intervals then. Of the turning scene's hits, one sweep of 2.5 rad misses a
// quarter, sweeps of 0.25 rad two, and sweeps of this many radians none.
constexpr double kMostTurn = 0.1;

}  // namespace

Box2dPeer::Box2dPeer(const Scene& scene) : obstacle_(1, b2Vec2(0, 0)) {
  for (const Polygon& part : scene.convex_parts) {
    vertices_.emplace_back();
    for (const Vec2& vertex : part.vertices()) vertices_.back().push_back(toBox2d(vertex));
    parts_.emplace_back();
    parts_.back().Set(vertices_.back().data(), static_cast<int>(part.size()), 0);
  }
  const double turn = kHorizon * std::abs(scene.twist.angular);
  const double pieces = std::max(1.0, std::ceil(turn / kMostTurn));
  duration_ = kHorizon / pieces;
  for (double piece = 0; piece < pieces; ++piece)
    sweeps_.push_back(turn == 0
                          ? translation({0, 0}, {0, 0})
                          : rotation(scene.twist, piece * duration_, (piece + 1) * duration_));
  input_.tMax = 1;
}

double Box2dPeer::firstContact(const Disc& disc, const std::vector<Vec2>& outline) {
  if (!outline.empty()) obstacle_.resize(outline.size());
  std::transform(outline.begin(), outline.end(), obstacle_.begin(), toBox2d);
  // It stops when the shapes overlap by three slops; the disc grows by these, so that what it
  // aims for is the true contact.
  input_.proxyB.Set(obstacle_.data(), static_cast<int>(obstacle_.size()),
                    static_cast<float>(disc.radius) + 3 * b2_linearSlop);
  for (std::size_t i = 0; i < sweeps_.size(); ++i) {
    const double start = static_cast<double>(i) * duration_;
    input_.sweepA = sweeps_[i];
    input_.sweepB =
        translation(disc.motion.positionAt(start), disc.motion.positionAt(start + duration_));
    const double share = firstContactOfSweep();
    if (share != kNever) return start + share * duration_;
  }
  return kNever;
}

double Box2dPeer::firstContactOfSweep() {
  double first = kNever;
  for (const b2DistanceProxy& part : parts_) {
    input_.proxyA = part;
    b2TOIOutput output;
    b2TimeOfImpact(&output, &input_);
    if (output.state == b2TOIOutput::e_separated) continue;
    // Also where it gave up (e_failed): up to there it has shown that nothing touches.
    const bool now = output.state == b2TOIOutput::e_overlapped;
    first = std::min(first, now ? 0 : static_cast<double>(output.t));
  }
  return first;
}

}  // namespace footprint_collision_predictor::bench
