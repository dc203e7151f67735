// One question to timeToCollision, and how to write it down so that it can be asked again.
#pragma once

#include <string>

#include "footprint_collision_predictor/time_to_collision.hpp"

namespace footprint_collision_predictor::test {

using core::Motion;
using core::Segment;
using core::Vec2;

struct Case {
  Segment segment;
  Motion circle;
  double radius;
  double horizon;
};

/// The case as C++ source, every bit of it: paste it into a test and call expectGuarantee() with
/// it.
std::string asCode(const Case& c);

inline std::optional<core::Contact> ask(const Case& c) {
  return core::timeToCollision(c.segment, c.circle, c.radius, c.horizon);
}

/// |p| + |v| t + |a| t^2 / 2 + radius + length, relative to the segment: the size of the numbers a
/// result is made of, in metres.
double sizeOfCoordinates(const Case& c, double t);

}  // namespace footprint_collision_predictor::test
