// Exact time to collision of one moving circle with one segment.
//
// The guarantee, in metres, since time is ill-conditioned in a graze:
//  1. Never missed, never late: if the true gap reaches 0 within the horizon, a contact is reported
//     no later than that moment (+ 1e-9 s, relative for large t).
//  2. Never invented: at the reported time the gap is <= contactTolerance(): some 1e-14 of the
//     coordinates relative to the segment, and 1e-9 m more where the segment turns.
//  3. The result does not depend on the origin, the axes, or the direction of the segment.
#pragma once

#include <optional>

#include "footprint_collision_predictor/motion.hpp"

namespace footprint_collision_predictor::core {

/// Where on the segment the circle touches; on an end, the end is named.
enum class Feature { kInside, kStart, kEnd };

/// The first moment at which the circle touches the segment.
struct Contact {
  double time;      ///< [s] in [0, horizon]; 0 when touching or overlapping at once
  Feature feature;  ///< which part of the segment is touched
  Vec2 point;       ///< [m] the point of the segment that is touched; the nearest one in an overlap
};

/// Earliest t in [0, horizon] at which the distance from the disc's centre to the segment is at
/// most its radius. Touching is contact, also at t = 0 while separating, and at the horizon itself.
///
/// \param segment that stands still; start == end is a point
/// \param disc as it moves in the segment's frame
/// \param horizon [s] in [0, kMaxHorizon]
/// \return nothing when the disc does not touch within the horizon
std::optional<Contact> timeToCollision(const Segment& segment, const Disc& disc, double horizon);

/// The same for a segment of a moving body. One that turns so often that ten million steps do not
/// decide, which takes a gap of less than a millimetre for some 1e5 rad, is told as touching.
///
/// \param segment in the body's frame, as the contact's point is
/// \param twist of the body, over ground; constant as felt on board: a straight line or an arc
/// \param disc over ground, in the body's frame at t = 0
std::optional<Contact> timeToCollision(const Segment& segment, const Twist& twist, const Disc& disc,
                                       double horizon);

/// Gap [m] up to which a disc counts as touching a segment that stands still at time t: what
/// rounding can amount to, in favour of contact, since exact tangency cannot be decided in floating
/// point.
double contactTolerance(const Segment& segment, const Disc& disc, double t);

}  // namespace footprint_collision_predictor::core
