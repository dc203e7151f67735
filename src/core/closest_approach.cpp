// Branch and bound: from a moment on, whatever a lower bound of the gap keeps above the smallest
// gap known is passed over in one step, the same as on the way to a contact. The smallest gap known
// falls fast, since the minimum of a parabola through each state is tried too.
#include "closest_approach.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "advancement.hpp"
#include "convex_body.hpp"
#include "edge_contact.hpp"

namespace footprint_collision_predictor::core {
namespace {

// What the smallest gap may be off [m], beside rounding.
constexpr double kResolution = 2e-7;
constexpr double kRounding = 64 * std::numeric_limits<double>::epsilon();

/// A convex body, and a disc that moves beside it.
template <typename Body, typename Path>
class Search {
 public:
  /// \param extent [m] of the body
  Search(const Body& body, double extent, const Path& path, const Disc& disc, double horizon)
      : body_(body), extent_(extent), path_(path), disc_(disc), horizon_(horizon) {}

  void lower(ClosestApproach* closest) const {
    const double size = path_.sizeAt(horizon_) + extent_ + disc_.radiusAt(horizon_);
    const double resolution = kResolution + kRounding * size;
    constexpr std::size_t kMaxSteps = 10000000;
    double t = 0, step = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < kMaxSteps; ++i) {
      const Gap<Body, Path> gap = gapAt(t);
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
  Gap<Body, Path> gapAt(double t) const { return {body_, path_, disc_, t}; }

  /// Follows a gap that shrinks down to where it stops, or to the horizon: Newton's method on its
  /// slope, kept within a bracket, and bisection where two steps do not make the next one half as
  /// long (Press et al., "Numerical Recipes", 9.4). Where the gap has several minima, any of them
  /// will do; a slope also vanishes where the gap is largest, which is no place to stop.
  void descend(double t, ClosestApproach* closest) const {
    constexpr int kMaxSteps = 60;
    double shrinks = t, grows = horizon_, next = horizon_;
    double step = horizon_ - t, step_before = step;
    for (int i = 0; i < kMaxSteps; ++i) {
      const Gap<Body, Path> gap = gapAt(next);
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

  const Body& body_;
  double extent_;
  const Path& path_;
  const Disc& disc_;
  double horizon_;
};

/// A body of the footprint, where it is in the footprint's frame, and how large it is [m].
template <typename Body>
struct Part {
  Body body;
  Vec2 origin;
  double extent;
};

Part<EdgeBody> partOf(const Edge& edge) {
  return {EdgeBody{fromStart(edge)}, edge.start, edge.length};
}

Part<ConvexBody> wholeOf(const Polygon& footprint) {
  return {ConvexBody(footprint.sides()), footprint.centroid(), 2 * footprint.boundingRadius()};
}

/// A disc, or a vertex of an outline rounded by it, beside a part of the footprint.
/// \param vertex [m] relative to the disc's centre
template <typename Body>
void lowerByDisc(const Part<Body>& part, const Twist& twist, const Disc& disc, const Vec2& vertex,
                 double horizon, ClosestApproach* closest) {
  const Motion& m = disc.motion;
  const Motion local{vertexFrom(part.origin, m.position, vertex), m.velocity, m.acceleration};
  const Twist at_origin = atPoint(part.origin, twist);
  const auto search = [&](const auto& path) {
    Search(part.body, part.extent, path, disc, horizon).lower(closest);
  };
  if (twist.angular == 0)
    search(StraightPath(relativeMotion(local, at_origin)));
  else
    search(PathSeenFromTurningBody(local, at_origin));
}

/// A vertex of the footprint beside an edge of the outline.
void lowerByVertex(const Vec2& vertex, const Twist& twist, const Edge& edge, const Disc& disc,
                   double horizon, ClosestApproach* closest) {
  const Motion& m = disc.motion;
  const Motion seen_from{vertexFrom(vertex, m.position, edge.start), m.velocity, m.acceleration};
  const PathOfTurningPoint path(seen_from, atPoint(vertex, twist));
  Search(EdgeBody{fromStart(edge)}, edge.length, path, disc, horizon).lower(closest);
}

/// A part of the footprint beside the whole obstacle, but for the footprint's own vertices.
template <typename Body>
void lowerByShape(const Part<Body>& part, const Twist& twist, const Shape& shape, double horizon,
                  ClosestApproach* closest) {
  const auto by = [&](const Vec2& vertex) {
    lowerByDisc(part, twist, shape.disc, vertex, horizon, closest);
  };
  if (shape.outline.size == 0) by({0, 0});
  for (const Edge& edge : shape.outline) {
    by(edge.start);
    // The next edge of a polygon starts where this one ends.
    if (!shape.outline.isClosed()) by(edge.end);
  }
}

}  // namespace

void lower(const Polygon& footprint, const Twist& twist, const Shape& shape, double horizon,
           ClosestApproach* closest) {
  if (footprint.isConvex()) lowerByShape(wholeOf(footprint), twist, shape, horizon, closest);
  for (std::size_t i = 0; i < footprint.size(); ++i) {
    const Edge& edge = footprint.segment(i);
    if (!footprint.isConvex()) lowerByShape(partOf(edge), twist, shape, horizon, closest);
    for (const Edge& other : shape.outline)
      lowerByVertex(edge.start, twist, other, shape.disc, horizon, closest);
  }
}

}  // namespace footprint_collision_predictor::core
