#include "stepping_peer.hpp"

#include <algorithm>
#include <cmath>

namespace footprint_collision_predictor::bench {

SteppingPeer::SteppingPeer(const Polygon& footprint, double step) : step_(step) {
  for (std::size_t i = 0; i < footprint.size(); ++i) {
    const Segment segment = footprint.segment(i);
    const Vec2 direction = segment.end - segment.start;
    edges_.push_back({segment.start, direction, 1 / direction.squaredNorm()});
  }
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

double SteppingPeer::firstContact(const Motion& circle, double radius) const {
  const int steps = static_cast<int>(std::lround(kHorizon / step_));
  for (int i = 0; i <= steps; ++i)
    if (touches(circle.positionAt(i * step_), radius * radius)) return i * step_;
  return kNever;
}

}  // namespace footprint_collision_predictor::bench
