#include "convex.hpp"

#include <algorithm>
#include <cmath>

#include "advancement.hpp"
#include "convex_body.hpp"
#include "edge_contact.hpp"
#include "rounding.hpp"

namespace footprint_collision_predictor::core {
namespace {

const ConvexAnswer kUncertain{false, std::nullopt};
const ConvexAnswer kNever{true, std::nullopt};

/// Whether vertex i is what is nearest to a point outside: beyond both sides that meet there.
bool isNearest(const Polygon& footprint, std::size_t i, const Vec2& p) {
  const Sides& sides = footprint.sides();
  const std::size_t before = footprint.previous(i);
  return sides.along(i, p) <= 0 && sides.along(before, p) >= sides.length[before];
}

/// A disc that moves straight, its position told from the footprint's centroid, with half of what
/// rounding may amount to as part of its radius; it grows with the way.
struct StraightDisc {
  Vec2 p, v;
  double reach, rate;
  double rounding, rounding_rate;  ///< [m] and [m/s] the other half
};

StraightDisc straightDisc(const Polygon& footprint, const Disc& disc) {
  const Vec2& p = disc.motion.position;
  const Vec2& v = disc.motion.velocity;
  const double size = p.lpNorm<1>() + disc.radius + 2 * footprint.boundingRadius();
  const double half = kRoundingAllowance / 2 * size;
  const double half_rate = kRoundingAllowance / 2 * (v.lpNorm<1>() + disc.radius_rate);
  return {p, v, disc.radius + half, disc.radius_rate + half_rate, half, half_rate};
}

/// When the way of the centre has come through all sides moved out by the radius.
struct Entry {
  double time;       ///< [s] negative when it starts within
  std::size_t side;  ///< through which it comes last
};

/// Clipping after Cyrus and Beck (1978); the sides move out as the disc grows. Without branches,
/// for what they decide is different for each side.
Entry entryOf(const StraightDisc& disc, const Sides& sides) {
  const double* normal_x = sides.normal_x.data();
  const double* normal_y = sides.normal_y.data();
  const double* offset = sides.offset.data();
  const double px = disc.p.x(), py = disc.p.y(), vx = disc.v.x(), vy = disc.v.y();
  Entry entry{-1, 0};
  for (std::size_t begin = 0; begin < sides.offset.size(); begin += kSidesAtOnce) {
    const std::size_t count = std::min(kSidesAtOnce, sides.offset.size() - begin);
    double times[kSidesAtOnce];
    for (std::size_t i = 0; i < count; ++i) {
      const double x = normal_x[begin + i], y = normal_y[begin + i];
      const double gap = x * px + y * py - offset[begin + i] - disc.reach;
      const double closing = disc.rate - (x * vx + y * vy);
      times[i] = gap / (closing > 0 ? closing : 0);  // never, when a gap does not close
    }
    double latest = entry.time;
    // Passes over NaN, which is that of a way along the side just within reach.
    for (std::size_t i = 0; i < count; ++i) latest = std::max(latest, times[i]);
    if (latest == entry.time) continue;
    std::size_t place = 0, is_before = 1;
    for (std::size_t i = 0; i < count; ++i) {
      is_before &= times[i] >= latest ? 0U : 1U;
      place += is_before;
    }
    entry = {latest, begin + place};
  }
  return entry;
}

/// Whether the way of the centre has run out through some side before a time.
bool leavesBefore(double time, const StraightDisc& disc, const Sides& sides) {
  for (std::size_t i = 0; i < sides.offset.size(); ++i) {
    const double gap = sides.across(i, disc.p) - disc.reach;
    const double closing = disc.rate - sides.normal(i).dot(disc.v);
    if (gap <= 0 && gap > closing * time) return true;
  }
  return false;
}

/// \param from_centroid a place [m]
std::size_t nearestVertex(const Polygon& footprint, const Vec2& from_centroid) {
  const auto squareTo = [&](const Vec2& vertex) {
    return ((vertex - footprint.centroid()) - from_centroid).squaredNorm();
  };
  const auto nearer = [&](const Vec2& a, const Vec2& b) { return squareTo(a) < squareTo(b); };
  const std::vector<Vec2>& vertices = footprint.vertices();
  return static_cast<std::size_t>(std::min_element(vertices.begin(), vertices.end(), nearer) -
                                  vertices.begin());
}

/// Straight motion. Where the way enters between the ends of a side, it touches. Beyond an end, as
/// long as the vertex there is what is nearest, nothing but this vertex can be touched: to come to
/// another the way would have to leave.
ConvexAnswer clip(const Polygon& footprint, const Disc& relative, double until) {
  const Sides& sides = footprint.sides();
  const StraightDisc disc = straightDisc(footprint, relative);
  const auto [enter, side] = entryOf(disc, sides);
  if (enter > until) return kNever;
  std::size_t vertex = side;
  if (enter >= 0) {
    const double along = sides.along(side, disc.p + enter * disc.v);
    if (along >= 0 && along <= sides.length[side])
      return {true,
              FirstTouch{contactAt(footprint.segment(side), along, enter, disc.rounding), side}};
    if (along > 0) vertex = footprint.next(side);
  } else {
    vertex = nearestVertex(footprint, disc.p);
  }
  const double start = std::max(enter, 0.0);
  if (!isNearest(footprint, vertex, disc.p + start * disc.v))
    return leavesBefore(start, disc, sides) ? kNever : kUncertain;
  const Edge& edge = footprint.segment(vertex);
  const Vec2 q = disc.p - (edge.start - footprint.centroid());
  if (const auto time = timeToReach(q, disc.v, disc.reach, disc.rate, until))
    return {true, FirstTouch{{*time, Feature::kStart, edge.start}, vertex}};
  // A miss by less than rounding may be a touch of a neighbour by more.
  const bool may_touch =
      timeToReach(q, disc.v, disc.reach + disc.rounding, disc.rate + disc.rounding_rate, until)
          .has_value();
  return may_touch ? kUncertain : kNever;
}

/// Until when the circles around the two are certainly apart; nothing when they are until `until`.
/// Each step costs a fraction of one with all sides.
///
/// \param path of the centre as seen from the footprint's, or the reverse, by one who does not turn
template <typename Path>
std::optional<double> timeApart(const Polygon& footprint, const Path& path, const Disc& disc,
                                double until) {
  constexpr int kFewSteps = 8;
  const double radius = footprint.boundingRadius();
  const Disc both{{}, disc.radius + radius, disc.radius_rate};
  const double near = 0.02 * radius + kGenerous * path.sizeAt(until);
  double t = 0;
  for (int i = 0; i < kFewSteps; ++i) {
    const Gap gap(PointBody{}, path, both, t);
    if (gap.size() <= near) break;
    const double step = gap.staysAbove(near / 2, until - t);
    if (step >= until - t) return std::nullopt;
    t += step;
  }
  return t;
}

/// Any other motion: advancement of the whole, from when the circles around the two touch.
///
/// \param between the path for that, as timeApart() has it
/// \param path of the centre about the centroid
template <typename Between, typename Path>
ConvexAnswer advance(const Polygon& footprint, const Between& between, const Path& path,
                     const Disc& disc, double until, double tolerance) {
  constexpr std::size_t kFewSteps = 16;
  const auto start = timeApart(footprint, between, disc, until);
  if (!start) return kNever;
  const auto enough = [&](double t) {
    const double size = path.sizeAt(t) + disc.radiusAt(t) + 2 * footprint.boundingRadius();
    return tolerance + kRoundingAllowance * size;
  };
  const ConvexBody body(footprint.sides());
  const Advance result = advanceToContact(body, path, disc, *start, until, enough, kFewSteps);
  if (result.outcome == Advance::kUndecided) return kUncertain;
  if (result.outcome == Advance::kNoContact) return kNever;
  const Edge& edge = footprint.segment(result.segment);
  const Vec2 centre = path.at(result.time).position - (edge.start - footprint.centroid());
  const double along = edge.tangent.dot(centre);
  return {true,
          FirstTouch{contactAt(edge, along, result.time, enough(result.time)), result.segment}};
}

}  // namespace

ConvexAnswer firstTouchOfConvex(const Polygon& footprint, const Twist& twist, const Disc& disc,
                                double until) {
  const Motion& m = disc.motion;
  if (twist.angular != 0) {
    const Twist at_centroid = atPoint(footprint.centroid(), twist);
    return advance(footprint, PathOfTurningPoint(m, at_centroid),
                   PathSeenFromTurningBody(m, at_centroid), disc, until, kTurningTolerance);
  }
  if (m.acceleration != Vec2::Zero()) {
    const StraightPath path(relativeMotion(m, twist));
    return advance(footprint, path, path, disc, until, 0);
  }
  return clip(footprint, {relativeMotion(m, twist), disc.radius, disc.radius_rate}, until);
}

}  // namespace footprint_collision_predictor::core
