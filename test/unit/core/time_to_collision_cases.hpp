// Named questions, one for each region around a segment, with answers worked out by hand.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "case.hpp"

namespace footprint_collision_predictor::test {

struct NamedCase {
  std::string name;
  Case question;
  std::optional<double> time;  ///< [s]; nothing when there is no contact
  core::Feature feature;
  Vec2 point;
  bool graze;  ///< touches without crossing: the time is ill-conditioned, metres decide
};

/// All of them. Radius 1 and segment (0, 0) to (4, 0) where nothing else is said; small integers
/// throughout.
const std::vector<NamedCase>& namedCases();

/// Those in which the segment's body turns.
std::vector<NamedCase> turningCases();

}  // namespace footprint_collision_predictor::test
