// Branch and bound: from a moment on, whatever a lower bound of the gap keeps above the smallest
// gap known is passed over in one step, the same as on the way to a contact. The smallest gap known
// falls fast, since the minimum of a parabola through each state is tried too.
#include "closest_approach.hpp"

#include <algorithm>
#include <limits>

#include "advancement.hpp"

namespace footprint_collision_predictor::core {
namespace {

// What the smallest gap may be off [m], beside rounding.
constexpr double kResolution = 2e-7;
constexpr double kRounding = 64 * std::numeric_limits<double>::epsilon();

/// \param edge starts at the origin
template <typename Path>
void lower(const Edge& edge, const Path& path, const Disc& disc, double horizon,
           ClosestApproach* closest) {
  const auto take = [&](double gap, double t) {
    if (gap < closest->distance) *closest = {std::max(gap, 0.0), t};
  };
  const double resolution =
      kResolution + kRounding * (path.sizeAt(horizon) + edge.length + disc.radiusAt(horizon));
  double t = 0, step = std::numeric_limits<double>::infinity();
  constexpr std::size_t kMaxSteps = 100000;
  for (std::size_t i = 0; i < kMaxSteps; ++i) {
    const Gap<Path> gap(edge, path, disc, t);
    take(gap.size(), t);
    const double left = horizon - t;
    if (gap.slope() < 0) {
      const double lowest =
          gap.curvature() > 0 ? std::min(-gap.slope() / gap.curvature(), left) : left;
      take(Gap<Path>(edge, path, disc, t + lowest).size(), t + lowest);
    }
    step = nextStep(gap, std::min(closest->distance, gap.size()) - resolution, left, step);
    if (step >= left) return;
    t += step;
  }
}

Edge fromStart(const Edge& edge) {
  Edge local = edge;
  local.start.setZero();
  local.end = edge.end - edge.start;
  return local;
}

/// A disc beside an edge of the footprint.
void lowerByDisc(const Edge& edge, const Twist& twist, const Disc& disc, double horizon,
                 ClosestApproach* closest) {
  const Motion& m = disc.motion;
  const Motion local{m.position - edge.start, m.velocity, m.acceleration};
  const Twist at_start = atPoint(edge.start, twist);
  if (twist.angular == 0)
    lower(fromStart(edge), StraightPath(relativeMotion(local, at_start)), disc, horizon, closest);
  else
    lower(fromStart(edge), PathSeenFromTurningBody(local, at_start), disc, horizon, closest);
}

/// A vertex of the footprint beside an edge of the outline.
void lowerByVertex(const Vec2& vertex, const Twist& twist, const Edge& edge, const Disc& disc,
                   double horizon, ClosestApproach* closest) {
  const Motion& m = disc.motion;
  const Motion seen_from{m.position + edge.start - vertex, m.velocity, m.acceleration};
  const PathOfTurningPoint path(seen_from, atPoint(vertex, twist));
  lower(fromStart(edge), path, disc, horizon, closest);
}

}  // namespace

void lower(const Polygon& footprint, const Twist& twist, const Shape& shape, double horizon,
           ClosestApproach* closest) {
  for (std::size_t i = 0; i < footprint.size(); ++i) {
    const Edge& edge = footprint.segment(i);
    if (shape.outline.size == 0) lowerByDisc(edge, twist, shape.disc, horizon, closest);
    for (const Edge& other : shape.outline) {
      lowerByVertex(edge.start, twist, other, shape.disc, horizon, closest);
      Disc disc = shape.disc;
      disc.motion.position += other.start;
      lowerByDisc(edge, twist, disc, horizon, closest);
      if (shape.outline.isClosed()) continue;  // the next edge starts where this one ends
      disc.motion.position = shape.disc.motion.position + other.end;
      lowerByDisc(edge, twist, disc, horizon, closest);
    }
  }
}

}  // namespace footprint_collision_predictor::core
