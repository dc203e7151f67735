// Time cut in halves until every piece is known to be free of contact, or is too short to be cut.
// Nothing here solves for a root: a piece is free when the gap in its middle is larger than what
// the speed there and a bound on the acceleration can take away on either side.
#pragma once

#include <optional>
#include <vector>

#include "moving_outline.hpp"
#include "plane.hpp"

namespace footprint_collision_predictor::test {

/// When the first contact is: not before `free_until`, and no later than `contact_at`.
struct FirstTouch {
  Real free_until;                 ///< [s] the horizon when all is free
  std::optional<Real> contact_at;  ///< [s] the gap is <= 0 then
};

struct SmallestGap {
  Real gap;   ///< [m] the true one, if positive, is at most 5e-8 smaller
  Real time;  ///< [s] when it is so small
};

/// Distance of the segments to the outline's edges, minus its radius [m].
Real gapAt(Real t, const std::vector<Line>& segments, const MovingOutline& outline);

/// Without free_until and contact_at within 1e-10 s there is a graze that time cannot be cut finely
/// enough for. What has no radius touches also where an edge got to the other side of a segment.
FirstTouch findFirstTouch(const std::vector<Line>& segments, const MovingOutline& outline,
                          Real horizon);

/// Within [0, horizon]; any gap <= 5e-8 m does where there is a contact.
SmallestGap findSmallestGap(const std::vector<Line>& segments, const MovingOutline& outline,
                            Real horizon);

}  // namespace footprint_collision_predictor::test
