#include <benchmark/benchmark.h>
#include <malloc.h>

#include "benchmarks.hpp"
#include "footprint_collision_predictor/obstacle_batch.hpp"
#include "instruction_sets.hpp"

namespace footprint_collision_predictor::bench {
namespace {

std::size_t bytesAllocated() {
  const struct mallinfo2 now = mallinfo2();
  return now.uordblks + now.hblkhd;
}

/// [bytes] what the allocator gave away for a batch, for each of its obstacles.
double bytesPerObstacle(Kind kind) {
  constexpr std::size_t kCount = 100000;
  const Scene scene = convexScene(8, kind, Contacts::kMixed, kCount);
  const std::size_t before = bytesAllocated();
  const core::ObstacleBatch batch(scene.obstacles);
  return static_cast<double>(bytesAllocated() - before) / kCount;
}

}  // namespace

void addContext() {
  benchmark::AddCustomContext("bytes_per_disc", std::to_string(bytesPerObstacle(Kind::kStraight)));
  benchmark::AddCustomContext("bytes_per_line", std::to_string(bytesPerObstacle(Kind::kWalls)));
  for (const NamedSet& set : allSets())
    if (!core::isSupported(set.set)) benchmark::AddCustomContext("without_" + set.name, "1");
}

}  // namespace footprint_collision_predictor::bench
