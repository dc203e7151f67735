// A whole footprint and one obstacle, and how to write them down so that they can be asked again.
#pragma once

#include <string>
#include <vector>

#include "footprint_collision_predictor/predictor.hpp"

namespace footprint_collision_predictor::test {

using core::Vec2;

struct FootprintCase {
  std::vector<Vec2> footprint;  ///< in its own frame
  core::Twist twist;            ///< over ground
  core::Disc disc;              ///< over ground, in the footprint's frame at t = 0
  std::vector<Vec2> outline;    ///< as of an Obstacle
  double horizon;
};

/// The case as C++ source, every bit of it: paste it into a test and call
/// expectFootprintGuarantee() with it.
std::string asCode(const FootprintCase& c);

core::Obstacle obstacleOf(const FootprintCase& c);

/// The size of the numbers that the answer at t is made of, relative to the robot [m].
double sizeOfCoordinates(const FootprintCase& c, double t);

}  // namespace footprint_collision_predictor::test
