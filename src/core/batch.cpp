#include "batch.hpp"

#include <algorithm>
#include <array>

#include "closest_approach.hpp"
#include "convex.hpp"
#include "edge_contact.hpp"
#include "narrow_phase.hpp"

namespace footprint_collision_predictor::core {
namespace {

/// Calls visit(index) for all obstacles that may come within gap() [m] of the footprint within
/// horizon() [s], in order. Both may shrink as they are visited.
template <typename Horizon, typename Gap, typename Visit>
void forEachNear(const BatchQuery& q, const Horizon& horizon, const Gap& gap, const Visit& visit) {
  std::array<std::size_t, kBlock> candidates;
  const ObstacleBatch& obstacles = q.obstacles;
  const auto sweep = [&](double duration) {
    return SweptFootprint(q.footprint, q.twist, duration, obstacles.largestAcceleration());
  };
  double swept_for = horizon();
  SweptFootprint swept = sweep(swept_for);
  for (std::size_t begin = 0; begin < obstacles.size(); begin += kBlock) {
    if (horizon() < swept_for) {
      swept_for = horizon();
      swept = sweep(swept_for);
    }
    const std::size_t end = std::min(begin + kBlock, obstacles.size());
    const std::size_t count =
        findCandidates(obstacles, begin, end, swept, gap(), q.set, &candidates);
    for (std::size_t k = 0; k < count; ++k) visit(candidates[k]);
  }
}

/// Whether a contact of obstacle j replaces the one known of a segment.
bool comesFirst(const Edge& edge, const ObstacleBatch& obstacles, const Contact& contact,
                std::size_t j, const SegmentContact& known) {
  if (contact.time != known.contact.time) return contact.time < known.contact.time;
  return gapNow(edge, shapeOf(obstacles, j)) < gapNow(edge, shapeOf(obstacles, known.obstacle));
}

/// Whether it is certain, and quickly told, that an obstacle touches no segment until a time.
bool surelyStaysAway(const BatchQuery& q, const Shape& shape, double until) {
  // What starts within the footprint may touch from there.
  const bool may_be_within = mayComeWithin(0, q.footprint, shape.disc, shape.disc.radius);
  if (shape.outline.size > 0 || may_be_within || !q.footprint.isConvex()) return false;
  const ConvexAnswer answer = firstTouchOfConvex(
      q.footprint, q.twist, relativeTo(q.footprint.centroid(), shape.disc), until);
  return answer.is_certain && !answer.touch;
}

/// A touch of a vertex is one of both its segments, at the same time. Each has found it by itself,
/// but for rounding.
void shareVertexContacts(const Polygon& footprint,
                         std::vector<std::optional<SegmentContact>>* contacts) {
  for (std::size_t i = 0; i < contacts->size(); ++i) {
    if (!(*contacts)[i]) continue;
    const SegmentContact& hit = *(*contacts)[i];
    const std::size_t neighbour = neighbourAt(footprint, hit.contact.feature, i);
    auto& other = (*contacts)[neighbour];
    if (other && other->contact.time <= hit.contact.time) continue;
    other = hit;
    other->contact.feature = featureOf(footprint.segment(neighbour), hit.contact.point);
  }
}

}  // namespace

Shape shapeOf(const ObstacleBatch& obstacles, std::size_t i) {
  return {obstacles.disc(i), obstacles.outline(i)};
}

bool comesFirst(const BatchQuery& q, double time, std::size_t j, double known_time,
                std::size_t known) {
  if (time != known_time || j == known) return time < known_time;
  return nearestNow(q.footprint, shapeOf(q.obstacles, j)).gap <
         nearestNow(q.footprint, shapeOf(q.obstacles, known)).gap;
}

std::optional<NearestObstacle> nearestObstacle(const BatchQuery& q, double below) {
  const ObstacleBatch& obstacles = q.obstacles;
  std::optional<NearestObstacle> smallest;
  const auto gap = [&] { return smallest ? smallest->nearest.gap : below; };
  const auto now = [] { return 0.0; };
  forEachNear({q.footprint, {}, obstacles, 0, q.set}, now, gap, [&](std::size_t j) {
    if (!mayComeWithin(gap(), q.footprint, obstacles.disc(j), obstacles.boundingRadius(j))) return;
    const Nearest nearest = nearestNow(q.footprint, shapeOf(obstacles, j));
    if (nearest.gap < gap()) smallest = NearestObstacle{j, nearest};
  });
  return smallest;
}

ClosestApproach closestApproach(const BatchQuery& q, double clearance) {
  const Polygon& footprint = q.footprint;
  const Twist& twist = q.twist;
  const ObstacleBatch& obstacles = q.obstacles;
  const double horizon = q.horizon;
  ClosestApproach closest{clearance, 0};
  const auto ahead = [&] { return q.horizon; };
  const auto gap = [&] { return closest.distance; };
  const SweptFootprint swept(footprint, twist, horizon, obstacles.largestAcceleration());
  forEachNear(q, ahead, gap, [&](std::size_t j) {
    if (mayComeWithin(gap(), swept, obstacles.disc(j), obstacles.boundingRadius(j)))
      lower(footprint, twist, shapeOf(obstacles, j), horizon, &closest);
  });
  return closest;
}

std::optional<FootprintContact> firstContact(const BatchQuery& q) {
  const Polygon& footprint = q.footprint;
  const Twist& twist = q.twist;
  const ObstacleBatch& obstacles = q.obstacles;
  const double horizon = q.horizon;
  std::optional<NearestObstacle> now;  // of those that overlap the footprint
  std::optional<FirstTouch> later;
  std::size_t obstacle = 0;
  const auto until = [&] { return now ? 0 : later ? later->contact.time : horizon; };
  const auto gap = [&] { return now ? now->nearest.gap : 0; };
  forEachNear(q, until, gap, [&](std::size_t j) {
    const Shape shape = shapeOf(obstacles, j);
    if (mayComeWithin(0, footprint, shape.disc, obstacles.boundingRadius(j))) {
      const Nearest nearest = nearestNow(footprint, shape);
      if (nearest.gap <= 0 && (!now || nearest.gap < gap())) now = NearestObstacle{j, nearest};
    }
    if (now) return;
    const auto touch = firstTouch(footprint, twist, shape, horizon, until());
    if (!touch) return;
    if (later && !comesFirst(q, touch->contact.time, j, later->contact.time, obstacle)) return;
    later = touch;
    obstacle = j;
  });
  if (!now && !later) return std::nullopt;
  const Shape shape = shapeOf(obstacles, now ? now->obstacle : obstacle);
  FootprintContact first = now ? contactNow(footprint, twist, shape, now->nearest)
                               : contactLater(footprint, twist, shape, *later);
  first.obstacle = now ? now->obstacle : obstacle;
  return first;
}

void firstContacts(const BatchQuery& q, std::vector<std::optional<SegmentContact>>* contacts) {
  const Polygon& footprint = q.footprint;
  const Twist& twist = q.twist;
  const ObstacleBatch& obstacles = q.obstacles;
  const double horizon = q.horizon;
  contacts->assign(footprint.size(), std::nullopt);
  // Nothing later than the last of the first contacts is of interest.
  const auto until = [&] {
    double last = 0;
    for (const auto& known : *contacts)
      last = std::max(last, known ? known->contact.time : horizon);
    return last;
  };
  const auto gap = [] { return 0.0; };
  forEachNear(q, until, gap, [&](std::size_t j) {
    const Shape shape = shapeOf(obstacles, j);
    if (surelyStaysAway(q, shape, until())) return;
    const NarrowPhase narrow(footprint, twist, shape, horizon);
    for (std::size_t i = 0; i < footprint.size(); ++i) {
      auto& known = (*contacts)[i];
      const auto contact = narrow.contactOf(i, known ? known->contact.time : horizon);
      if (contact && (!known || comesFirst(footprint.segment(i), obstacles, *contact, j, *known)))
        known = SegmentContact{*contact, j};
    }
  });
  shareVertexContacts(footprint, contacts);
}

}  // namespace footprint_collision_predictor::core
