#include "footprint_collision_predictor/predictor.hpp"

#include <limits>

#include "batch.hpp"
#include "narrow_phase.hpp"

namespace footprint_collision_predictor::core {
namespace {

/// The first contact of all segments, of those at a vertex the one with the lower index.
std::optional<FootprintContact> firstOf(
    const BatchQuery& q, const std::vector<std::optional<SegmentContact>>& contacts) {
  std::optional<std::size_t> first;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    if (!contacts[i]) continue;
    if (!first || comesFirst(q, contacts[i]->contact.time, contacts[i]->obstacle,
                             contacts[*first]->contact.time, contacts[*first]->obstacle))
      first = i;
  }
  if (!first) return std::nullopt;
  const SegmentContact& hit = *contacts[*first];
  FootprintContact contact =
      contactLater(q.footprint, q.twist, shapeOf(q.obstacles, hit.obstacle), {hit.contact, *first});
  contact.obstacle = hit.obstacle;
  return contact;
}

}  // namespace

std::optional<FootprintContact> firstContact(const Polygon& footprint, const Twist& twist,
                                             const ObstacleBatch& obstacles, double horizon) {
  return firstContact(BatchQuery{footprint, twist, obstacles, horizon});
}

void firstContacts(const Polygon& footprint, const Twist& twist, const ObstacleBatch& obstacles,
                   double horizon, std::vector<std::optional<SegmentContact>>* contacts) {
  firstContacts(BatchQuery{footprint, twist, obstacles, horizon}, contacts);
}

Prediction predict(const Polygon& footprint, const Twist& twist,
                   const std::vector<Obstacle>& obstacles, double horizon) {
  const ObstacleBatch batch(obstacles);
  const BatchQuery query{footprint, twist, batch, horizon};
  Prediction prediction;
  firstContacts(query, &prediction.segments);
  const auto nearest = nearestObstacle(query, std::numeric_limits<double>::infinity());
  if (!nearest) return prediction;
  prediction.clearance = nearest->nearest.gap;
  if (nearest->nearest.gap <= 0) {
    const Shape shape = shapeOf(batch, nearest->obstacle);
    prediction.first = contactNow(footprint, twist, shape, nearest->nearest);
    prediction.first->obstacle = nearest->obstacle;
  } else {
    prediction.first = firstOf(query, prediction.segments);
  }
  prediction.closest = prediction.first ? ClosestApproach{0, prediction.first->contact.time}
                                        : closestApproach(query, *prediction.clearance);
  return prediction;
}

}  // namespace footprint_collision_predictor::core
