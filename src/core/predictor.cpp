#include "footprint_collision_predictor/predictor.hpp"

#include <algorithm>

namespace footprint_collision_predictor::core {
namespace {

/// The footprint's nearest segment to a point, and the signed distance to it (negative inside).
struct Nearest {
  std::size_t segment;
  double signed_distance;
};

Nearest nearestTo(const Vec2& point, const Polygon& footprint) {
  Nearest nearest{0, distance(footprint.segment(0), point)};
  for (std::size_t i = 1; i < footprint.size(); ++i) {
    const double d = distance(footprint.segment(i), point);
    if (d < nearest.signed_distance) nearest = {i, d};
  }
  if (footprint.contains(point)) nearest.signed_distance = -nearest.signed_distance;
  return nearest;
}

Feature featureOf(const Segment& segment, const Vec2& point) {
  if (point == segment.start) return Feature::kStart;
  return point == segment.end ? Feature::kEnd : Feature::kInside;
}

/// The other segment at the vertex that a contact names; nothing when it is inside of its segment.
std::optional<std::size_t> neighbourAt(Feature feature, std::size_t segment, std::size_t size) {
  if (feature == Feature::kStart) return (segment + size - 1) % size;
  if (feature == Feature::kEnd) return (segment + 1) % size;
  return std::nullopt;
}

/// A touch of a vertex is one of both its segments, at the same time. Each has found it by itself,
/// but for rounding.
void shareVertexContacts(const Polygon& footprint,
                         std::vector<std::optional<SegmentContact>>& segments) {
  for (std::size_t i = 0; i < segments.size(); ++i) {
    if (!segments[i]) continue;
    const SegmentContact& hit = *segments[i];
    const auto neighbour = neighbourAt(hit.contact.feature, i, segments.size());
    if (!neighbour) continue;
    auto& other = segments[*neighbour];
    if (other && other->contact.time <= hit.contact.time) continue;
    other = hit;
    other->contact.feature = featureOf(footprint.segment(*neighbour), hit.contact.point);
  }
}

/// Speed at which the gap shrinks at the contact [m/s].
double closingSpeed(const Polygon& footprint, const FootprintContact& first, const Motion& motion) {
  const Contact& contact = first.contact;
  const Segment segment = footprint.segment(first.segment);
  // From the segment's start, so that nothing is lost far from the origin.
  const Segment local{Vec2::Zero(), segment.end - segment.start};
  const Motion centre{motion.position - segment.start, motion.velocity, motion.acceleration};
  const Vec2 position = centre.positionAt(contact.time);
  const Vec2 away = position - closestPoint(local, position);
  const Vec2 velocity = motion.velocityAt(contact.time);
  if (away.norm() > contactTolerance(segment, motion, 0, contact.time)) {
    const bool inside = contact.time == 0 && footprint.contains(motion.position);
    return std::max(0.0, velocity.dot(away.normalized()) * (inside ? 1 : -1));
  }
  // A centre on the boundary itself, as that of a point obstacle, has the segment's normal; a
  // vertex has many, of which the one against the velocity is the worst.
  if (contact.feature != Feature::kInside) return velocity.norm();
  const Vec2 left = leftNormal(local.end).normalized();
  return std::max(0.0, velocity.dot(left) * (footprint.isCounterClockwise() ? 1 : -1));
}

/// A bound on the gap from below [m]: the footprint lies within a circle about its centroid, and
/// within the time a path with constant acceleration leaves its chord by at most |a| t^2 / 8.
double smallestGapBound(const Polygon& footprint, const Motion& m, double radius, double horizon) {
  const Segment chord{m.position, m.positionAt(horizon)};
  const double bulge = m.acceleration.norm() * horizon * horizon / 8;
  return distance(chord, footprint.centroid()) - bulge - footprint.boundingRadius() - radius;
}

/// Whether no rounding can make a contact of it. Far more than contactTolerance() grows to on the
/// way.
bool cannotTouch(const Polygon& footprint, const Motion& m, double radius, double horizon) {
  constexpr double kRounding = 1e-12;
  const double path = m.velocity.norm() * horizon + m.acceleration.norm() * horizon * horizon;
  const double size =
      (m.position - footprint.centroid()).norm() + path + radius + footprint.boundingRadius();
  return smallestGapBound(footprint, m, radius, horizon) > kRounding * size;
}

/// Whether a contact of the candidate replaces the one known of this segment.
bool comesFirst(const Segment& segment, const Contact& candidate, const Obstacle& obstacle,
                const Contact& known, const Obstacle& known_obstacle) {
  if (candidate.time != known.time) return candidate.time < known.time;
  const auto gap = [&](const Obstacle& o) {
    return distance(segment, o.motion().position) - o.radius();
  };
  return gap(obstacle) < gap(known_obstacle);
}

/// The first contact of all segments, of those at a vertex the one with the lower index.
std::optional<FootprintContact> firstOf(
    const std::vector<std::optional<SegmentContact>>& segments) {
  std::optional<FootprintContact> first;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    if (segments[i] && (!first || segments[i]->contact.time < first->contact.time))
      first = FootprintContact{segments[i]->contact, i, segments[i]->obstacle, 0};
  }
  return first;
}

/// An obstacle that touches the solid footprint now, at the nearest point of the boundary.
FootprintContact contactNow(const Polygon& footprint, const Vec2& centre, std::size_t nearest,
                            std::size_t obstacle) {
  const Vec2 point = closestPoint(footprint.segment(nearest), centre);
  Contact contact{0, featureOf(footprint.segment(nearest), point), point};
  const auto neighbour = neighbourAt(contact.feature, nearest, footprint.size());
  const std::size_t segment = std::min(nearest, neighbour.value_or(nearest));
  contact.feature = featureOf(footprint.segment(segment), point);
  return {contact, segment, obstacle, 0};
}

}  // namespace

Prediction predict(const Polygon& footprint, const Twist& twist,
                   const std::vector<Obstacle>& obstacles, double horizon) {
  Prediction prediction;
  prediction.segments.resize(footprint.size());
  std::optional<FootprintContact> deepest_now;
  for (std::size_t j = 0; j < obstacles.size(); ++j) {
    const Obstacle& obstacle = obstacles[j];
    const Motion motion = relativeMotion(obstacle.motion(), twist);
    const bool is_far =
        prediction.clearance &&
        smallestGapBound(footprint, motion, obstacle.radius(), 0) > *prediction.clearance;
    if (is_far && cannotTouch(footprint, motion, obstacle.radius(), horizon)) continue;
    const Nearest nearest = nearestTo(motion.position, footprint);
    bool touches_now = nearest.signed_distance <= obstacle.radius();
    for (std::size_t i = 0; i < footprint.size(); ++i) {
      const Segment segment = footprint.segment(i);
      const auto contact = timeToCollision(segment, motion, obstacle.radius(), horizon);
      if (!contact) continue;
      touches_now = touches_now || contact->time == 0;
      auto& known = prediction.segments[i];
      if (!known ||
          comesFirst(segment, *contact, obstacle, known->contact, obstacles[known->obstacle]))
        known = SegmentContact{*contact, j};
    }
    const double clearance = nearest.signed_distance - obstacle.radius();
    const bool smallest = !prediction.clearance || clearance < *prediction.clearance;
    if (touches_now && (!deepest_now || smallest))
      deepest_now = contactNow(footprint, motion.position, nearest.segment, j);
    if (smallest) prediction.clearance = clearance;
  }
  shareVertexContacts(footprint, prediction.segments);
  prediction.first = deepest_now ? deepest_now : firstOf(prediction.segments);
  if (prediction.first) {
    const Obstacle& obstacle = obstacles[prediction.first->obstacle];
    prediction.first->closing_speed =
        closingSpeed(footprint, *prediction.first, relativeMotion(obstacle.motion(), twist));
  }
  return prediction;
}

}  // namespace footprint_collision_predictor::core
