// Random cases, by the kind of trouble they make.
#pragma once

#include "case.hpp"
#include "random.hpp"

namespace footprint_collision_predictor::test {

/// Length log-uniform in 1e-2 .. 1e2 m, any direction, near the origin.
Segment anySegment(Random& random);

/// A place within reach: either end, a hair beside it, or anywhere between.
Vec2 pointOn(const Segment& segment, Random& random);

/// A point of the segment and the direction in which a circle that touches it there lies.
struct Touch {
  Vec2 point;
  Vec2 outwards;
};

/// The inside from either side, or an end, which is left in any direction.
Touch anyTouch(const Segment& segment, Random& random);

/// 0 in one of ten, else log-uniform in 1e-2 .. 1e2 m.
double anyRadius(Random& random);

/// A value that is almost `value`: next to it, exactly it, or off by 1e-15 .. 1e-3 of it.
double almost(double value, Random& random);

/// The motion which at that time is at `position` with that velocity.
Motion leadingTo(const Vec2& position, double time, const Vec2& velocity, const Vec2& acceleration);

/// Zero in one of three, else log-uniform in [low, high] in any direction.
Vec2 anyVector(Random& random, double low, double high);

/// Everything drawn widely; more than half of the circles are aimed at the segment.
Case anyCase(Random& random);

/// Passes one end, which is the nearest point of the segment, at the radius * (1 +- 1e-15 .. 1e-3)
/// or 1 to 4 ulp beside it, or exactly at it.
Case grazingEnd(Random& random);

/// Grazes one end on a path that is curved almost as the circle's rim is: the gap stays near 0 for
/// long, and its first and second derivative almost vanish.
Case osculating(Random& random);

/// A way that comes from beyond an end, and where it meets the segment just beside that end.
struct Sinking {
  Vec2 point;
  Vec2 direction;  ///< no unit vector
};

/// Beside an end by 1e-12 .. 1e-2 of the length, at a slope of 1e-8 .. 1, from the given side.
Sinking anySinking(const Segment& segment, const Vec2& outwards, Random& random);

/// Comes from beyond an end and touches the segment just beside it, at a shallow angle.
Case sinking(Random& random);

/// Touches the segment at t = 0, but for +-1e-16 .. 1e-6 m, and moves in, out or alongside.
Case touchingNow(Random& random);

/// Comes to a stop 1e-9 .. 1e-3 m short of or past contact, and goes back where it came from.
Case braking(Random& random);

/// Starts outwards, and the acceleration brings it back.
Case awayAndBack(Random& random);

/// Flies up to 1e6 m away and, when it comes back, touches the segment or grazes it, but for
/// +-1e-16 .. 1e-3 m.
Case boomerang(Random& random);

/// The same, elsewhere. Coordinates are rounded as they would be in a map so far from its origin.
Case translated(const Case& c, const Vec2& by);

/// x one ulp up or down, `steps` times.
double ulpsAway(double x, int steps);

}  // namespace footprint_collision_predictor::test
