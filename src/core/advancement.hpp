// Conservative advancement (Mirtich, 1996) of a second order: from a moment when a disc is apart
// from a convex body, the normal at the nearest point is frozen. The gap along it is a lower bound
// of the gap, and so is a parabola below that; up to the first root of this parabola there is no
// contact. The steps come from the left, cannot overshoot, and near a contact converge
// quadratically.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

#include "footprint_collision_predictor/geometry.hpp"
#include "path.hpp"

namespace footprint_collision_predictor::core {

/// First root in (0, window] of gap + slope s + curvature s^2 / 2, with gap > 0; the window when
/// there is none.
inline double firstRoot(double gap, double slope, double curvature, double window) {
  // Decided before any root is taken: a tiny curvature would underflow in it, and lead nowhere.
  if (slope >= 0 && gap + window * (slope + 0.5 * curvature * window) > 0) return window;
  const double discriminant = slope * slope - 2 * curvature * gap;
  if (discriminant < 0) return window;
  const double root = std::sqrt(discriminant);
  const double step = slope < 0 ? 2 * gap / (root - slope) : (slope + root) / -curvature;
  return std::min(step, window);
}

/// How a point lies to the nearest point of a body.
struct Away {
  /// [m] from there to the point. Put together along the sides, not told from a vertex: close to
  /// one, its rounded coordinates could turn it so far that it is no normal of the body any more.
  Vec2 vector;
  /// [m] > 0 when the nearest point is a vertex: how far the point lies beyond each of the sides
  /// that meet there, along them, at least
  double beyond;
  std::size_t segment;  ///< the one it is on
};

/// A single edge as a body, with its start at the origin.
struct EdgeBody {
  Edge edge;

  Away awayFrom(const Vec2& p) const {
    const double along = edge.tangent.dot(p);
    if (along <= 0) return {p, -along, 0};
    const Vec2 across = cross(edge.tangent, p) * leftNormal(edge.tangent);
    const double beyond = std::max(along - edge.length, 0.0);
    return {beyond * edge.tangent + across, beyond, 0};
  }
};

/// A point at the origin as a body.
struct PointBody {
  Away awayFrom(const Vec2& p) const { return {p, 0, 0}; }
};

/// The gap between a growing disc and a convex body at one moment, and how it may shrink from
/// there.
template <typename Body, typename Path>
class Gap {
 public:
  Gap(const Body& body, const Path& path, const Disc& disc, double t)
      : path_(path), state_(path.at(t)), away_(body.awayFrom(state_.position)) {
    distance_ = away_.vector.norm();
    // On the body itself any direction will do: there the gap is no more than rounding.
    normal_ = distance_ > 0 ? Vec2(away_.vector / distance_) : Vec2(1, 0);
    size_ = distance_ - disc.radiusAt(t);
    slope_ = normal_.dot(state_.velocity) - disc.radius_rate;
  }

  /// [m]
  double size() const { return size_; }
  /// [m/s] at which it grows
  double slope() const { return slope_; }
  /// [m/s^2] at which the slope grows
  double curvature() const {
    const double bend = normal_.dot(state_.acceleration);
    if (!(away_.beyond > 0)) return bend;
    const double past = cross(normal_, state_.velocity);
    return bend + past * past / distance_;
  }
  /// Of the body, the one that is nearest.
  std::size_t segment() const { return away_.segment; }
  /// [s] for how long, at most `window`, the gap certainly stays above `level` [m] < size().
  double staysAbove(double level, double window) const {
    double step = 0;
    if constexpr (Path::kBodyTurns) {
      const double room = away_.beyond > 0 ? roomOfVertex() : 0;
      if (room > 0) step = staysAboveOverGround(level, std::min(room, window));
      if (step < room || room >= window) return step;
    }
    const double curvature = path_.lowestAcceleration(state_, normal_, window);
    return std::max(step, firstRoot(size_ - level, slope_, curvature, window));
  }

 private:
  /// [s] for how long a nearest vertex surely remains what lies farthest along the normal, when
  /// this is fixed over ground: the angle to the sides' normals is no less than its sine.
  double roomOfVertex() const { return path_.timeToTurn(away_.beyond / distance_); }

  /// The same with the normal fixed over ground. The slope is no other: going round the vertex does
  /// not lead away from it.
  double staysAboveOverGround(double level, double window) const {
    const double curvature =
        path_.lowestAccelerationOverGround(state_.position - away_.vector, state_, normal_, window);
    return firstRoot(size_ - level, slope_, curvature, window);
  }

  const Path& path_;
  PathState state_;
  Away away_;
  double distance_;
  Vec2 normal_;
  double size_;
  double slope_;
};

/// Where to go next from t: a window of a few lengths of the last step, in which the path can be
/// bent less, says more than all the time left, unless it ends before the gap does.
template <typename Body, typename Path>
double nextStep(const Gap<Body, Path>& gap, double level, double time_left, double last_step) {
  constexpr double kWindow = 8;
  const double window = std::min(kWindow * last_step, time_left);
  const double step = gap.staysAbove(level, window);
  const bool ends_before = step >= window && window < time_left;
  return ends_before ? std::max(step, gap.staysAbove(level, time_left)) : step;
}

/// How an advancement ended.
struct Advance {
  enum { kContact, kNoContact, kUndecided } outcome;
  double time;          ///< [s] of the contact, or up to which there is none
  std::size_t segment;  ///< of the body, where it was nearest
};

/// Goes on to the first t in [start, horizon] at which the gap is at most the tolerance. It is
/// aimed at half of that, so that it is never later than the contact.
///
/// \param tolerance [m] > 0, as a function of time, which does not fall
template <typename Body, typename Path, typename Tolerance>
Advance advanceToContact(const Body& body, const Path& path, const Disc& disc, double start,
                         double horizon, const Tolerance& tolerance, std::size_t max_steps) {
  double t = start, step = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < max_steps; ++i) {
    const Gap<Body, Path> gap(body, path, disc, t);
    const double enough = tolerance(t);
    if (gap.size() <= enough) return {Advance::kContact, t, gap.segment()};
    const double last_step = step, left = horizon - t;
    step = nextStep(gap, enough / 2, left, last_step);
    // Where it lands far away, rounding is that of the numbers there.
    while (tolerance(t + step) >= 2 * gap.size()) step /= 2;
    const double enough_there = tolerance(t + step);
    if (enough_there > 1.25 * enough) step = nextStep(gap, enough_there / 2, step, last_step);
    if (step >= left) return {Advance::kNoContact, horizon, 0};
    t += step;
  }
  return {Advance::kUndecided, t, 0};
}

}  // namespace footprint_collision_predictor::core
