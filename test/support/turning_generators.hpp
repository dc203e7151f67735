// Random cases in which the segment's body drives an arc.
#pragma once

#include "generators.hpp"

namespace footprint_collision_predictor::test {

/// Where [m] a point of the body is at time t, over ground, in the body's frame at t = 0. In double
/// and by another formula than the oracles: good enough to aim with.
Vec2 carried(const Vec2& point, const Twist& twist, double t);
/// The direction of the body's axes likewise.
Vec2 turned(const Vec2& vector, double angle);

/// 0 in one of twenty, else +-1e-12 .. 10 rad/s, half of them above 1e-2.
double anyYawRate(Random& random);

/// Aimed at the segment on its way, straight or accelerating, in most cases. Here and below: any
/// yaw rate, within the horizon up to six turns, about a place on the segment, near it, at its
/// body's origin, or wherever a linear velocity of 1e-3 .. 10 m/s puts it.
Case turningCase(Random& random);

/// A pillar that stands in the way, or close to it.
Case pillar(Random& random);

/// A moment comes at which the disc touches but for 1e-15 .. 1e-3 of its radius and moves
/// alongside; a pillar in one half.
Case turningGraze(Random& random);

/// A moment comes at which the disc touches the segment just beside an end, at a shallow angle as
/// seen from the body; a point in more than half.
Case turningSinking(Random& random);

/// Touches at t = 0 but for +-1e-16 .. 1e-6 m, and moves in, out or alongside as seen from the
/// body.
Case turningNow(Random& random);

/// Any of these kinds.
Case turningOfEveryKind(Random& random);
/// Any of these kinds, with a radius that grows, too.
Case turningAndGrowing(Random& random);
/// Any of these kinds, with the body's origin 1e3 .. 1e6 m away from its segment: it turns about a
/// place near the segment all the same, or about one as far away, and then slowly.
Case turningFarFromOrigin(Random& random);

/// The same motions, described in another frame that is fixed to the body: an orthogonal matrix and
/// where its origin was. A mirror makes left turns right turns. Coordinates are rounded.
Case fromOtherFrame(const Case& c, const Eigen::Matrix2d& turn, const Vec2& by);

}  // namespace footprint_collision_predictor::test
