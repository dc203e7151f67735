// Random cases in which the radius grows.
#pragma once

#include "generators.hpp"

namespace footprint_collision_predictor::test {

/// Log-uniform in 1e-9 .. 1e1 m/s.
double anyRadiusRate(Random& random);

/// anyCase() that grows.
Case growingCase(Random& random);

/// Grows towards the segment about as fast as it leaves, so that the gap almost rests where it is
/// about 0: at an end on any path, or at the inside, where it slides along the widening strip.
Case growingGraze(Random& random);

/// touchingNow() that grows, about as fast as it leaves in one half.
Case growingNow(Random& random);

/// Leaves square to the segment, slower than it grows by 1e-9 .. 1 of that.
Case caughtUp(Random& random);

}  // namespace footprint_collision_predictor::test
