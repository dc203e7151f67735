// A footprint among many obstacles, random ones too.
#pragma once

#include <cstddef>
#include <vector>

#include "footprint_generators.hpp"

namespace footprint_collision_predictor::test {

struct Scene {
  std::vector<Vec2> footprint;
  core::Twist twist;
  std::vector<core::Obstacle> obstacles;
  double horizon;

  /// The same question about one obstacle.
  FootprintCase with(std::size_t obstacle) const;
};

/// 1 to 2000 obstacles, each with an outline or without. Some are the same as others, some touch at
/// once; in some scenes nearly all are far away.
Scene anyScene(Random& random);

/// So far away, and leaving, that nothing the footprint does within the horizon leads there.
core::Obstacle anyOutOfReach(const Scene& scene, Random& random);

}  // namespace footprint_collision_predictor::test
