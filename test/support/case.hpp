// One question to timeToCollision, and how to write it down so that it can be asked again.
#pragma once

#include <string>

#include "footprint_collision_predictor/time_to_collision.hpp"

namespace footprint_collision_predictor::test {

using core::Disc;
using core::Motion;
using core::Segment;
using core::Twist;
using core::Vec2;

struct Case {
  Segment segment;
  Motion circle;  ///< of the disc's centre
  double radius;
  double horizon;
  double radius_rate = 0;
  Twist twist{};  ///< of the body that the segment is a part of

  Disc disc() const { return {circle, radius, radius_rate}; }
};

/// The case as C++ source, every bit of it: paste it into a test and call expectGuarantee() with
/// it.
std::string asCode(const Case& c);

/// The segment stands still for the one that does not ask for a twist.
std::optional<core::Contact> ask(const Case& c);

/// Velocity [m/s] of the segment's start at t = 0, over ground.
Vec2 startVelocity(const Case& c);

/// |p| + |v| t + |a| t^2 / 2 + radius + length + the way of the segment's start, a chord where it
/// turns; relative to the segment: the size of the numbers a result is made of, in metres.
double sizeOfCoordinates(const Case& c, double t);

}  // namespace footprint_collision_predictor::test
