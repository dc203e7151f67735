#include "convex.hpp"

#include <algorithm>
#include <cmath>

#include "advancement.hpp"
#include "edge_contact.hpp"
#include "rounding.hpp"

namespace footprint_collision_predictor::core {
namespace {

constexpr ConvexAnswer kUncertain{false, std::nullopt};
constexpr ConvexAnswer kNever{true, std::nullopt};

double alongAt(const Side& side, const Vec2& p) { return side.tangent.dot(p) - side.start; }

/// Whether a point beyond an end of side i is beyond the end of its neighbour there too: then the
/// vertex between them is what is nearest.
bool isNearestToVertex(const std::vector<Side>& sides, std::size_t i, const Vec2& p) {
  const std::size_t n = sides.size();
  if (alongAt(sides[i], p) > 0) return alongAt(sides[(i + 1) % n], p) <= 0;
  const Side& before = sides[(i + n - 1) % n];
  return alongAt(before, p) >= before.length;
}

/// Straight motion: the way of the centre is clipped against all sides moved out by the radius
/// (Cyrus and Beck, 1978). It enters through one of them. Between its ends that is the touch;
/// beyond an end, as long as the vertex there is nearest, nothing but that vertex can be touched,
/// since between two vertices the way would have to leave. The time is then that of the one
/// segment.
ConvexAnswer clip(const Polygon& footprint, const Disc& disc, double horizon, double until) {
  const std::vector<Side>& sides = footprint.sides();
  const Vec2 p = disc.motion.position - footprint.centroid();
  const Vec2& v = disc.motion.velocity;
  const double size = p.lpNorm<1>() + disc.radius + 2 * footprint.boundingRadius() +
                      horizon * (v.lpNorm<1>() + disc.radius_rate);
  const double reach = disc.radius + kGenerous * size;
  double enter = -1, leave = until;
  std::size_t entered = 0;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const Side& side = sides[i];
    const double gap = side.normal.dot(p) - side.offset - reach;
    const double closing = disc.radius_rate - side.normal.dot(v);
    if (gap > 0) {
      if (gap > closing * leave) return kNever;
      const double t = gap / closing;
      if (t > enter) {
        enter = t;
        entered = i;
      }
    } else if (gap > closing * leave) {
      leave = gap / closing;
    }
  }
  if (enter > leave) return kNever;
  if (enter < 0) return kUncertain;
  const Vec2 at = p + enter * v;
  const double along = alongAt(sides[entered], at);
  const bool is_inside = along >= 0 && along <= sides[entered].length;
  if (!is_inside && !isNearestToVertex(sides, entered, at)) return kUncertain;
  const auto contact = timeToCollision(footprint.segment(entered), disc, horizon);
  if (!contact) return kUncertain;
  return {true, FirstTouch{*contact, entered}};
}

/// The footprint as a body, about its centroid.
class ConvexBody {
 public:
  explicit ConvexBody(const std::vector<Side>& sides) : sides_(sides) {}

  /// \param p outside
  Away awayFrom(const Vec2& p) const {
    std::size_t nearest = 0;
    double smallest = HUGE_VAL, nearest_beyond = 0, nearest_across = 0;
    for (std::size_t i = 0; i < sides_.size(); ++i) {
      const double across = sides_[i].normal.dot(p) - sides_[i].offset;
      const double along = alongAt(sides_[i], p);
      const double beyond = along - std::clamp(along, 0.0, sides_[i].length);
      const double square = across * across + beyond * beyond;
      if (square >= smallest) continue;
      smallest = square;
      nearest = i;
      nearest_beyond = beyond;
      nearest_across = across;
    }
    const Side& side = sides_[nearest];
    return {nearest_across * side.normal + nearest_beyond * side.tangent, nearest_beyond != 0,
            nearest};
  }

 private:
  const std::vector<Side>& sides_;
};

/// Any other motion: advancement of the whole. \param path of the centre about the centroid
template <typename Path>
ConvexAnswer advance(const Polygon& footprint, const Path& path, const Disc& disc, double until,
                     double tolerance) {
  constexpr std::size_t kFewSteps = 16;
  const auto enough = [&](double t) {
    const double size = path.sizeAt(t) + disc.radiusAt(t) + 2 * footprint.boundingRadius();
    return tolerance + kRoundingAllowance * size;
  };
  const ConvexBody body(footprint.sides());
  const Advance result = advanceToContact(body, path, disc, until, enough, kFewSteps);
  if (result.outcome == Advance::kUndecided) return kUncertain;
  if (result.outcome == Advance::kNoContact) return kNever;
  const Edge& edge = footprint.segment(result.segment);
  const Vec2 centre = path.at(result.time).position - (edge.start - footprint.centroid());
  return {true,
          FirstTouch{contactAt(edge, centre, result.time, enough(result.time)), result.segment}};
}

}  // namespace

ConvexAnswer firstTouchOfConvex(const Polygon& footprint, const Twist& twist, const Disc& disc,
                                double horizon, double until) {
  const Motion& m = disc.motion;
  const Motion local{m.position - footprint.centroid(), m.velocity, m.acceleration};
  if (twist.angular != 0)
    return advance(footprint, PathSeenFromTurningBody(local, atPoint(footprint.centroid(), twist)),
                   disc, until, kTurningTolerance);
  if (m.acceleration != Vec2::Zero())
    return advance(footprint, StraightPath(relativeMotion(local, twist)), disc, until, 0);
  return clip(footprint, {relativeMotion(m, twist), disc.radius, disc.radius_rate}, horizon, until);
}

}  // namespace footprint_collision_predictor::core
