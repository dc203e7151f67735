#include <benchmark/benchmark.h>

#include <algorithm>

#include "benchmarks.hpp"
#include "footprint_collision_predictor/predictor.hpp"

namespace footprint_collision_predictor::bench {
namespace {

using Lists = std::vector<std::vector<Obstacle>>;

/// As many lists of `size` as make up all inputs, so that short lists differ from call to call too.
Lists listsOf(const Scene& scene, std::size_t size) {
  Lists lists;
  auto from = scene.obstacles.begin();
  for (std::size_t i = 0; i < std::max<std::size_t>(1, kInputs / size); ++i) {
    const auto to = from + static_cast<std::ptrdiff_t>(size);
    lists.emplace_back(from, to);
    from = to;
  }
  return lists;
}

void add(const SharedScene& scene, std::size_t size) {
  const auto lists = std::make_shared<const Lists>(listsOf(*scene, size));
  const std::string name =
      "many/" + nameOf(scene->kind) + "/" + scene->name + "/" + std::to_string(size);
  const auto measure = [scene, lists, size](benchmark::State& state) {
    std::size_t i = 0;
    for (auto _ : state) {
      benchmark::DoNotOptimize(
          core::predict(scene->footprint, scene->twist, (*lists)[i], kHorizon));
      if (++i == lists->size()) i = 0;
    }
    state.counters["obstacles"] = static_cast<double>(size);
  };
  benchmark::RegisterBenchmark(name.c_str(), measure)
      ->Iterations(static_cast<benchmark::IterationCount>(lists->size()));
}

}  // namespace

void addManyBenchmarks(MotionKind kind, std::size_t most) {
  const auto scene = std::make_shared<const Scene>(
      makeScene("8", convexFootprint(8), kind, std::max(kInputs, most)));
  for (std::size_t size = 10; size <= most; size *= 10) add(scene, size);
}

}  // namespace footprint_collision_predictor::bench
