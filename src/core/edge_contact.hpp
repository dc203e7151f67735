// What timeToCollision() does for a segment, for edges that are known already, and with the roles
// swapped.
#pragma once

#include <optional>

#include "footprint_collision_predictor/time_to_collision.hpp"

namespace footprint_collision_predictor::core {

/// The same disc with its position told from a point.
inline Disc relativeTo(const Vec2& point, const Disc& disc) {
  return {{disc.motion.position - point, disc.motion.velocity, disc.motion.acceleration},
          disc.radius,
          disc.radius_rate};
}

/// The same edge with its start at the origin.
inline Edge fromStart(const Edge& edge) {
  Edge local = edge;
  local.start.setZero();
  local.end = edge.end - edge.start;
  return local;
}

/// position + vertex as told from a point. Any two of the three may cancel: what rounding takes off
/// the difference is added again (Knuth's TwoSum).
inline Vec2 vertexFrom(const Vec2& point, const Vec2& position, const Vec2& vertex) {
  const Vec2 difference = position - point;
  const Vec2 subtracted = position - difference;
  const Vec2 lost = (position - (difference + subtracted)) + (subtracted - point);
  return (difference + vertex) + lost;
}

/// timeToCollision() of time_to_collision.hpp, for an edge that stands still.
std::optional<Contact> timeToCollision(const Edge& edge, const Disc& disc, double horizon);
/// The same for an edge of a body that moves.
std::optional<Contact> timeToCollision(const Edge& edge, const Twist& twist, const Disc& disc,
                                       double horizon);

/// \param along [m] how far along the edge the disc's centre is from its start, at its contact at t
/// \param slack [m] within which an end is named
Contact contactAt(const Edge& edge, double along, double t, double slack);

/// Earliest t in [0, horizon] at which a point that moves evenly is within a growing reach of the
/// origin.
std::optional<double> timeToReach(const Vec2& position, const Vec2& velocity, double reach,
                                  double reach_rate, double horizon);

/// Earliest t in [0, horizon] at which an edge of an obstacle's outline, rounded by the disc's
/// radius, touches a point of the footprint. \param point [m] in the footprint's frame \param twist
/// of the footprint \param edge of the outline, relative to the disc's centre
std::optional<double> timeToTouchPoint(const Vec2& point, const Twist& twist, const Edge& edge,
                                       const Disc& disc, double horizon);

}  // namespace footprint_collision_predictor::core
