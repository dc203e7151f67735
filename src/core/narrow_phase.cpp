#include "narrow_phase.hpp"

#include <algorithm>
#include <cmath>

#include "edge_contact.hpp"
#include "path.hpp"

namespace footprint_collision_predictor::core {
namespace {

void keepEarlier(const std::optional<Contact>& candidate, std::optional<Contact>* earliest) {
  if (candidate && (!*earliest || candidate->time < (*earliest)->time)) *earliest = candidate;
}

/// The first contact of two chains always involves a vertex of one of them: the outline's against
/// the edge, or the edge's against the outline. Only chains that cross at once need neither.
std::optional<Contact> contactWithOutline(const Edge& edge, const Twist& twist, const Shape& shape,
                                          double horizon) {
  if (const auto point = crossingNow(edge, shape)) return Contact{0, Feature::kInside, *point};
  std::optional<Contact> earliest;
  const auto touchOutline = [&](const Vec2& vertex, Feature feature, const Edge& other) {
    const auto time = timeToTouchPoint(vertex, twist, other, shape.disc, horizon);
    if (time) keepEarlier(Contact{*time, feature, vertex}, &earliest);
  };
  const auto touchVertex = [&](const Vec2& vertex) {
    Disc disc = shape.disc;
    disc.motion.position += vertex;
    keepEarlier(timeToCollision(edge, twist, disc, horizon), &earliest);
  };
  for (const Edge& other : shape.outline) {
    touchOutline(edge.start, Feature::kStart, other);
    touchOutline(edge.end, Feature::kEnd, other);
    touchVertex(other.start);
    if (!shape.outline.isClosed()) touchVertex(other.end);
  }
  return earliest;
}

/// Speed at which the gap shrinks at the contact [m/s], but for the radius' growth.
double closingSpeed(const Polygon& footprint, const Twist& twist, const Shape& shape,
                    const FootprintContact& first, bool is_nested) {
  const Contact& contact = first.contact;
  const Edge& edge = footprint.segment(first.segment);
  // From the contact, so that nothing is lost far from the origin.
  Shape local = shape;
  local.disc.motion.position -= contact.point;
  const Twist at_contact = atPoint(contact.point, twist);
  std::optional<Vec2> outline_direction;
  const Vec2 away = nearestOf(local, at_contact, contact.time, {0, 0}, &outline_direction);
  const double angle = twist.angular * contact.time;
  const Vec2 velocity =
      turned(shape.disc.motion.velocityAt(contact.time), std::cos(angle), -std::sin(angle)) -
      at_contact.linear;
  Disc point = local.disc;
  point.radius = point.radius_rate = 0;
  point.motion = relativeMotion(point.motion, at_contact);
  const double nothing = 2 * contactTolerance({{0, 0}, {0, 0}}, point, contact.time);
  if (away.norm() > nothing)
    return std::max(0.0, velocity.dot(away.normalized()) * (is_nested ? 1 : -1));
  // What has no radius touches with its centre or outline. An edge has its normal; a vertex has
  // many, of which the one against the velocity is the worst.
  if (contact.feature == Feature::kInside) {
    const Vec2 left = leftNormal(edge.tangent);
    return std::max(0.0, velocity.dot(left) * (footprint.isCounterClockwise() ? 1 : -1));
  }
  if (outline_direction) return std::abs(cross(*outline_direction, velocity));
  return velocity.norm();
}

}  // namespace

std::optional<Contact> contactOf(const Polygon& footprint, std::size_t i, const Twist& twist,
                                 const Shape& shape, double horizon) {
  const Edge& edge = footprint.segment(i);
  if (shape.outline.size == 0) return timeToCollision(edge, twist, shape.disc, horizon);
  return contactWithOutline(edge, twist, shape, horizon);
}

FootprintContact contactNow(const Polygon& footprint, const Twist& twist, const Shape& shape,
                            const Nearest& nearest) {
  const Feature feature = featureOf(footprint.segment(nearest.segment), nearest.point);
  FootprintContact first =
      contactLater(footprint, twist, shape, {0, feature, nearest.point}, nearest.segment);
  const bool is_nested = nearest.gap + shape.disc.radius < 0;
  first.closing_speed = closingSpeed(footprint, twist, shape, first, is_nested);
  return first;
}

FootprintContact contactLater(const Polygon& footprint, const Twist& twist, const Shape& shape,
                              const Contact& contact, std::size_t i) {
  FootprintContact first{contact, i, 0, 0};
  const auto neighbour = neighbourAt(contact.feature, i, footprint.size());
  if (neighbour && *neighbour < i) {
    first.segment = *neighbour;
    first.contact.feature = featureOf(footprint.segment(*neighbour), contact.point);
  }
  first.closing_speed = closingSpeed(footprint, twist, shape, first, false);
  return first;
}

std::optional<std::size_t> neighbourAt(Feature feature, std::size_t segment, std::size_t size) {
  if (feature == Feature::kStart) return (segment + size - 1) % size;
  if (feature == Feature::kEnd) return (segment + 1) % size;
  return std::nullopt;
}

}  // namespace footprint_collision_predictor::core
