// Branch and bound: from a moment on, whatever a lower bound of the gap keeps above the smallest
// gap known is passed over in one step, the same as on the way to a contact. The smallest gap known
// falls fast, since the minimum of a parabola through each state is tried too.
#include "closest_approach.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "advancement.hpp"

namespace footprint_collision_predictor::core {
namespace {

// What the smallest gap may be off [m], beside rounding.
constexpr double kResolution = 2e-7;
constexpr double kRounding = 64 * std::numeric_limits<double>::epsilon();

/// One edge that starts at the origin, and a disc that moves beside it.
template <typename Path>
class Search {
 public:
  Search(const EdgeBody& edge, const Path& path, const Disc& disc, double horizon)
      : edge_(edge), path_(path), disc_(disc), horizon_(horizon) {}

  void lower(ClosestApproach* closest) const {
    const double size = path_.sizeAt(horizon_) + edge_.edge.length + disc_.radiusAt(horizon_);
    const double resolution = kResolution + kRounding * size;
    constexpr std::size_t kMaxSteps = 10000000;
    double t = 0, step = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < kMaxSteps; ++i) {
      const Gap<EdgeBody, Path> gap = gapAt(t);
      if (gap.size() < closest->distance) {
        *closest = {gap.size(), t};
        if (gap.slope() < 0) descend(t, closest);
        closest->distance = std::max(closest->distance, 0.0);
      }
      step = nextStep(gap, closest->distance - resolution, horizon_ - t, step);
      if (step >= horizon_ - t) return;
      t += step;
    }
  }

 private:
  Gap<EdgeBody, Path> gapAt(double t) const { return {edge_, path_, disc_, t}; }

  /// Follows a gap that shrinks down to where it stops, or to the horizon: Newton's method on its
  /// slope, kept within a bracket, and bisection where two steps do not make the next one half as
  /// long (Press et al., "Numerical Recipes", 9.4). Where the gap has several minima, any of them
  /// will do; a slope also vanishes where the gap is largest, which is no place to stop.
  void descend(double t, ClosestApproach* closest) const {
    constexpr int kMaxSteps = 60;
    double shrinks = t, grows = horizon_, next = horizon_;
    double step = horizon_ - t, step_before = step;
    for (int i = 0; i < kMaxSteps; ++i) {
      const Gap<EdgeBody, Path> gap = gapAt(next);
      const bool falls = gap.slope() < 0 && gap.size() <= closest->distance;
      if (gap.size() < closest->distance) *closest = {gap.size(), next};
      if (falls && next == horizon_) return;
      (falls ? shrinks : grows) = next;
      const bool is_lowest = gap.size() <= closest->distance;
      if (i > 0 && is_lowest && std::abs(gap.slope()) * (grows - shrinks) < kResolution / 8) return;
      double towards = next - gap.slope() / gap.curvature();
      const bool usable = gap.curvature() > 0 && towards > shrinks && towards < grows &&  // no NaN
                          std::abs(towards - next) <= 0.5 * step_before;
      if (!usable) towards = 0.5 * (shrinks + grows);
      step_before = step;
      step = std::abs(towards - next);
      next = towards;
    }
  }

  const EdgeBody& edge_;
  const Path& path_;
  const Disc& disc_;
  double horizon_;
};

Edge fromStart(const Edge& edge) {
  Edge local = edge;
  local.start.setZero();
  local.end = edge.end - edge.start;
  return local;
}

template <typename Path>
void search(const Edge& edge, const Path& path, const Disc& disc, double horizon,
            ClosestApproach* closest) {
  const EdgeBody local{fromStart(edge)};
  Search<Path>(local, path, disc, horizon).lower(closest);
}

/// A disc, or a vertex of an outline rounded by it, beside an edge of the footprint.
/// \param vertex [m] relative to the disc's centre
void lowerByDisc(const Edge& edge, const Twist& twist, const Disc& disc, const Vec2& vertex,
                 double horizon, ClosestApproach* closest) {
  const Motion& m = disc.motion;
  const Motion local{(m.position - edge.start) + vertex, m.velocity, m.acceleration};
  const Twist at_start = atPoint(edge.start, twist);
  if (twist.angular == 0)
    search(edge, StraightPath(relativeMotion(local, at_start)), disc, horizon, closest);
  else
    search(edge, PathSeenFromTurningBody(local, at_start), disc, horizon, closest);
}

/// A vertex of the footprint beside an edge of the outline.
void lowerByVertex(const Vec2& vertex, const Twist& twist, const Edge& edge, const Disc& disc,
                   double horizon, ClosestApproach* closest) {
  const Motion& m = disc.motion;
  const Motion seen_from{(m.position - vertex) + edge.start, m.velocity, m.acceleration};
  const PathOfTurningPoint path(seen_from, atPoint(vertex, twist));
  search(edge, path, disc, horizon, closest);
}

}  // namespace

void lower(const Polygon& footprint, const Twist& twist, const Shape& shape, double horizon,
           ClosestApproach* closest) {
  for (std::size_t i = 0; i < footprint.size(); ++i) {
    const Edge& edge = footprint.segment(i);
    if (shape.outline.size == 0)
      lowerByDisc(edge, twist, shape.disc, Vec2::Zero(), horizon, closest);
    for (const Edge& other : shape.outline) {
      lowerByVertex(edge.start, twist, other, shape.disc, horizon, closest);
      lowerByDisc(edge, twist, shape.disc, other.start, horizon, closest);
      // The next edge of a polygon starts where this one ends.
      if (!shape.outline.isClosed())
        lowerByDisc(edge, twist, shape.disc, other.end, horizon, closest);
    }
  }
}

}  // namespace footprint_collision_predictor::core
