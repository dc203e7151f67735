// What the answer truly is, in 113 bits, by another way than a product would go: the disc of an end
// as a quartic whose roots are isolated by its derivatives, the strip between the ends as a
// rectangle whose four sides are each asked with a quadratic.
#pragma once

#include <optional>

#include "case.hpp"
#include "quad.hpp"

namespace footprint_collision_predictor::test {

/// First t in [0, horizon] at which the distance from the centre to the segment is <= the radius.
/// Exact tangency is decided by the last of 113 bits.
/// \throws std::invalid_argument for a segment that turns, which has no polynomials.
std::optional<Quad> trueContact(const Case& c);

/// Distance from the centre to the segment minus the radius at time t [m]. Any case, also turning.
Quad trueGap(const Case& c, Quad t);

/// Positive where the centre is to the left of the segment's line at time t, negative to the right.
Quad trueSide(const Case& c, Quad t);

/// How far [m] a point of the body is from the true nearest point of the segment at time t.
Quad distanceFromNearest(const Case& c, double t, const Vec2& point);

/// The same moment by bisection: whatever the largest speed cannot reach is free. No polynomial in
/// it; slow. Brackets a graze to `width` seconds, so it may report one that only nearly touches.
/// Any case, also turning.
std::optional<Quad> contactByBisection(const Case& c, double width);

}  // namespace footprint_collision_predictor::test
