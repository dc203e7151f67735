// How footprints are told apart in texts to people.
#pragma once

#include <string>

namespace footprint_collision_predictor {

/// Of the footprint of a robot that has no other.
constexpr char kOnlyFootprint[] = "footprint";

/// What a text about a footprint begins with: "trailer: ", or nothing for the only one.
inline std::string prefixFor(const std::string& footprint) {
  return footprint.empty() || footprint == kOnlyFootprint ? "" : footprint + ": ";
}

}  // namespace footprint_collision_predictor
