// What can be proven about a moving disc and a segment: bisection of time, in intervals. It knows
// nothing of polynomials or roots, so it takes any motion that can be written down for intervals.
#pragma once

#include <functional>
#include <optional>

#include "case.hpp"
#include "interval.hpp"

namespace footprint_collision_predictor::test {

/// Centre [m] from the segment's start, along the axes of its frame, and radius [m] >= 0, over an
/// interval of time.
struct DiscOverTime {
  Jet x;
  Jet y;
  Jet radius;
};

/// A motion, evaluated in jets: `2 + t * v` moves, and so does anything else made of their
/// operators. Intervals must be made within it, where rounding is upwards.
using DiscMotion = std::function<DiscOverTime(const Jet& time)>;

/// The motion of a case, as seen from its segment. `more` [m] is added to its radius.
DiscMotion motionOf(const Case& c, double more = 0);

/// What is proven of the first contact. It lies within [free_until, contact_at]; without contact_at
/// no contact was proven, and with nothing unproven there is none at all.
struct Proof {
  double free_until;                 ///< [s] no contact before; the horizon when all is free
  std::optional<double> contact_at;  ///< [s] the gap is <= 0 then
  bool free;                         ///< no contact in [0, horizon]

  /// Known to 1e-9 s.
  bool isBracketed() const { return contact_at && *contact_at - free_until <= 1e-9; }
  /// A graze by less than rounding, or one so flat that 64 bits do not fix its time.
  bool isUndecided() const { return !free && !isBracketed(); }
};

/// The first contact within [0, horizon] of a disc and a segment.
Proof prove(const Segment& segment, const DiscMotion& disc, double horizon);
Proof prove(const Case& c);

/// Whether the gap at time t is proven to be larger than `gap` [m].
bool isProvenApart(const Case& c, double t, double gap);

}  // namespace footprint_collision_predictor::test
