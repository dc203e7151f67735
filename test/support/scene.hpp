// A footprint among many obstacles, random ones too.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
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

/// 1 to `most` obstacles, each with an outline or without. Some are the same as others, some touch
/// at once; in some scenes nearly all are far away.
Scene anyScene(Random& random, int most = 2000);

/// So far away, and leaving, that nothing the footprint does within the horizon leads there.
core::Obstacle anyOutOfReach(const Scene& scene, Random& random);

/// Whether both are right who say that the obstacle is first touched at `earlier` and at `later`
/// (HUGE_VAL for never): in a graze the guarantee leaves that open. Of the footprint when there is
/// no segment.
bool areBothRight(const Scene& scene, std::size_t obstacle, double earlier, double later,
                  std::optional<std::size_t> segment = {});

/// Every obstacle as asCode() has it.
std::string asCode(const Scene& scene);

}  // namespace footprint_collision_predictor::test
