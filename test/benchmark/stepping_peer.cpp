#include "stepping_peer.hpp"

#include <algorithm>
#include <cmath>

namespace footprint_collision_predictor::bench {

SteppingPeer::SteppingPeer(const Scene& scene, double step)
    : turns_(scene.twist.angular != 0), step_(step) {
  for (std::size_t i = 0; i < scene.footprint.size(); ++i) {
    const Segment segment = scene.footprint.segment(i);
    const Vec2 direction = segment.end - segment.start;
    edges_.push_back({segment.start, direction, 1 / direction.squaredNorm()});
  }
  const long steps = std::lround(kHorizon / step);
  for (long i = 0; i <= steps; ++i)
    poses_.push_back(poseAt(scene.twist, static_cast<double>(i) * step));
}

Vec2 SteppingPeer::centreAt(const Disc& disc, std::size_t step) const {
  const Vec2 centre = disc.motion.positionAt(static_cast<double>(step) * step_);
  return turns_ ? poses_[step].toFrame(centre) : centre;
}

bool SteppingPeer::touches(const Vec2& centre, double radius_squared) const {
  bool inside = false;
  for (const Edge& edge : edges_) {
    const Vec2 from_start = centre - edge.start;
    const double share = from_start.dot(edge.direction) * edge.per_length_squared;
    const Vec2 gap = from_start - std::clamp(share, 0.0, 1.0) * edge.direction;
    if (gap.squaredNorm() <= radius_squared) return true;
    const bool starts_above = from_start.y() < 0;
    if (starts_above != (from_start.y() < edge.direction.y()))
      inside ^= (core::cross(edge.direction, from_start) < 0) == starts_above;
  }
  return inside;
}

double SteppingPeer::firstContact(const Disc& disc) const {
  for (std::size_t i = 0; i < poses_.size(); ++i) {
    const double t = static_cast<double>(i) * step_;
    const double radius = disc.radiusAt(t);
    if (touches(centreAt(disc, i), radius * radius)) return t;
  }
  return kNever;
}

}  // namespace footprint_collision_predictor::bench
