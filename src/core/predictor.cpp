#include "footprint_collision_predictor/predictor.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "broad_phase.hpp"
#include "closest_approach.hpp"
#include "narrow_phase.hpp"

namespace footprint_collision_predictor::core {
namespace {

Shape shapeOf(const ObstacleBatch& obstacles, std::size_t i) {
  return {obstacles.disc(i), obstacles.outline(i)};
}

/// Calls visit(index) for all obstacles that may come within gap() [m] of the footprint within
/// horizon() [s], in order. Both may shrink as they are visited.
template <typename Horizon, typename Gap, typename Visit>
void forEachNear(const Polygon& footprint, const Twist& twist, const ObstacleBatch& obstacles,
                 const Horizon& horizon, const Gap& gap, const Visit& visit) {
  std::array<std::size_t, kBlock> candidates;
  const InstructionSet set = widestInstructionSet();
  const auto sweep = [&](double duration) {
    return SweptFootprint(footprint, twist, duration,
                          windowsFor(footprint, twist, duration, obstacles.largestAcceleration()));
  };
  double swept_for = horizon();
  SweptFootprint swept = sweep(swept_for);
  for (std::size_t begin = 0; begin < obstacles.size(); begin += kBlock) {
    if (horizon() < swept_for) {
      swept_for = horizon();
      swept = sweep(swept_for);
    }
    const std::size_t end = std::min(begin + kBlock, obstacles.size());
    const std::size_t count = findCandidates(obstacles, begin, end, swept, gap(), set, &candidates);
    for (std::size_t k = 0; k < count; ++k) visit(candidates[k]);
  }
}

/// The obstacle with the smallest gap now, of those with less than `below` [m].
struct NearestObstacle {
  std::size_t obstacle;
  Nearest nearest;
};

std::optional<NearestObstacle> nearestObstacle(const Polygon& footprint,
                                               const ObstacleBatch& obstacles, double below) {
  std::optional<NearestObstacle> smallest;
  const auto gap = [&] { return smallest ? smallest->nearest.gap : below; };
  const auto now = [] { return 0.0; };
  forEachNear(footprint, {}, obstacles, now, gap, [&](std::size_t j) {
    if (!mayComeWithin(gap(), footprint, obstacles.disc(j), obstacles.bounding_radius[j])) return;
    const Nearest nearest = nearestNow(footprint, shapeOf(obstacles, j));
    if (nearest.gap < gap()) smallest = NearestObstacle{j, nearest};
  });
  return smallest;
}

/// Whether a contact of obstacle j replaces the one known of a segment.
bool comesFirst(const Edge& edge, const ObstacleBatch& obstacles, const Contact& contact,
                std::size_t j, const SegmentContact& known) {
  if (contact.time != known.contact.time) return contact.time < known.contact.time;
  return gapNow(edge, shapeOf(obstacles, j)) < gapNow(edge, shapeOf(obstacles, known.obstacle));
}

/// Whether the footprint's contact with obstacle j comes before one with the obstacle `known`.
bool comesFirst(const Polygon& footprint, const ObstacleBatch& obstacles, double time,
                std::size_t j, double known_time, std::size_t known) {
  if (time != known_time || j == known) return time < known_time;
  return nearestNow(footprint, shapeOf(obstacles, j)).gap <
         nearestNow(footprint, shapeOf(obstacles, known)).gap;
}

/// A touch of a vertex is one of both its segments, at the same time. Each has found it by itself,
/// but for rounding.
void shareVertexContacts(const Polygon& footprint,
                         std::vector<std::optional<SegmentContact>>* contacts) {
  for (std::size_t i = 0; i < contacts->size(); ++i) {
    if (!(*contacts)[i]) continue;
    const SegmentContact& hit = *(*contacts)[i];
    const auto neighbour = neighbourAt(hit.contact.feature, i, contacts->size());
    if (!neighbour) continue;
    auto& other = (*contacts)[*neighbour];
    if (other && other->contact.time <= hit.contact.time) continue;
    other = hit;
    other->contact.feature = featureOf(footprint.segment(*neighbour), hit.contact.point);
  }
}

/// The first contact of all segments, of those at a vertex the one with the lower index.
std::optional<FootprintContact> firstOf(
    const Polygon& footprint, const Twist& twist, const ObstacleBatch& obstacles,
    const std::vector<std::optional<SegmentContact>>& contacts) {
  std::optional<std::size_t> first;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    if (!contacts[i]) continue;
    if (!first || comesFirst(footprint, obstacles, contacts[i]->contact.time, contacts[i]->obstacle,
                             contacts[*first]->contact.time, contacts[*first]->obstacle))
      first = i;
  }
  if (!first) return std::nullopt;
  const SegmentContact& hit = *contacts[*first];
  FootprintContact contact =
      contactLater(footprint, twist, shapeOf(obstacles, hit.obstacle), {hit.contact, *first});
  contact.obstacle = hit.obstacle;
  return contact;
}

std::optional<ClosestApproach> closestOf(const Polygon& footprint, const Twist& twist,
                                         const ObstacleBatch& obstacles, double horizon,
                                         const Prediction& prediction) {
  if (prediction.first) return ClosestApproach{0, prediction.first->contact.time};
  if (!prediction.clearance) return std::nullopt;
  ClosestApproach closest{*prediction.clearance, 0};
  const auto ahead = [&] { return horizon; };
  const auto gap = [&] { return closest.distance; };
  const SweptFootprint swept(
      footprint, twist, horizon,
      windowsFor(footprint, twist, horizon, obstacles.largestAcceleration()));
  forEachNear(footprint, twist, obstacles, ahead, gap, [&](std::size_t j) {
    if (mayComeWithin(gap(), swept, obstacles.disc(j), obstacles.bounding_radius[j]))
      lower(footprint, twist, shapeOf(obstacles, j), horizon, &closest);
  });
  return closest;
}

}  // namespace

std::optional<FootprintContact> firstContact(const Polygon& footprint, const Twist& twist,
                                             const Obstacle& obstacle, double horizon) {
  if (!obstacle.outline().empty())
    return firstContact(footprint, twist, ObstacleBatch({obstacle}), horizon);
  const Shape shape{obstacle.disc(), {}};
  if (!mayTouch(footprint, twist, shape.disc, horizon)) return std::nullopt;
  if (mayComeWithin(0, footprint, shape.disc, shape.disc.radius)) {
    const Nearest nearest = nearestNow(footprint, shape);
    if (nearest.gap <= 0) return contactNow(footprint, twist, shape, nearest);
  }
  const auto touch = firstTouch(footprint, twist, shape, horizon, horizon);
  if (!touch) return std::nullopt;
  return contactLater(footprint, twist, shape, *touch);
}

std::optional<FootprintContact> firstContact(const Polygon& footprint, const Twist& twist,
                                             const ObstacleBatch& obstacles, double horizon) {
  std::optional<NearestObstacle> now;  // of those that overlap the footprint
  std::optional<FirstTouch> later;
  std::size_t obstacle = 0;
  const auto until = [&] { return now ? 0 : later ? later->contact.time : horizon; };
  const auto gap = [&] { return now ? now->nearest.gap : 0; };
  forEachNear(footprint, twist, obstacles, until, gap, [&](std::size_t j) {
    const Shape shape = shapeOf(obstacles, j);
    if (mayComeWithin(0, footprint, shape.disc, obstacles.bounding_radius[j])) {
      const Nearest nearest = nearestNow(footprint, shape);
      if (nearest.gap <= 0 && (!now || nearest.gap < gap())) now = NearestObstacle{j, nearest};
    }
    if (now) return;
    const auto touch = firstTouch(footprint, twist, shape, horizon, until());
    if (!touch) return;
    if (later &&
        !comesFirst(footprint, obstacles, touch->contact.time, j, later->contact.time, obstacle))
      return;
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

void firstContacts(const Polygon& footprint, const Twist& twist, const ObstacleBatch& obstacles,
                   double horizon, std::vector<std::optional<SegmentContact>>* contacts) {
  contacts->assign(footprint.size(), std::nullopt);
  // Nothing later than the last of the first contacts is of interest.
  const auto until = [&] {
    double last = 0;
    for (const auto& known : *contacts)
      last = std::max(last, known ? known->contact.time : horizon);
    return last;
  };
  const auto gap = [] { return 0.0; };
  forEachNear(footprint, twist, obstacles, until, gap, [&](std::size_t j) {
    const Shape shape = shapeOf(obstacles, j);
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

Prediction predict(const Polygon& footprint, const Twist& twist,
                   const std::vector<Obstacle>& obstacles, double horizon) {
  const ObstacleBatch batch(obstacles);
  Prediction prediction;
  firstContacts(footprint, twist, batch, horizon, &prediction.segments);
  const auto nearest = nearestObstacle(footprint, batch, std::numeric_limits<double>::infinity());
  if (nearest) prediction.clearance = nearest->nearest.gap;
  if (nearest && nearest->nearest.gap <= 0) {
    const Shape shape = shapeOf(batch, nearest->obstacle);
    prediction.first = contactNow(footprint, twist, shape, nearest->nearest);
    prediction.first->obstacle = nearest->obstacle;
  } else {
    prediction.first = firstOf(footprint, twist, batch, prediction.segments);
  }
  prediction.closest = closestOf(footprint, twist, batch, horizon, prediction);
  return prediction;
}

}  // namespace footprint_collision_predictor::core
