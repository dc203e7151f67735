// How long the core takes, beside what a user could take instead, on the same inputs in one run.
// With --quick only the footprint of 8 edges, and no more than 10,000 obstacles.
#include <benchmark/benchmark.h>

#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "benchmarks.hpp"

namespace footprint_collision_predictor::bench {
namespace {

void addScene(Scene scene) {
  std::fprintf(stderr, "Asking the oracle: %s motion, footprint %s\n", nameOf(scene.kind).c_str(),
               scene.name.c_str());
  const auto shared = std::make_shared<const Scene>(std::move(scene));
  addFootprintBenchmarks(shared);
  if (shared->name == "8") addSegmentBenchmarks(shared);
}

void addAll(bool quick) {
  const std::vector<int> edges = quick ? std::vector<int>{8} : std::vector<int>{4, 8, 16, 32};
  for (const MotionKind kind : {MotionKind::kStraight, MotionKind::kAccelerating}) {
    for (const int count : edges) addScene(convexScene(count, kind, kInputs));
    if (!quick) addScene(concaveScene(kind, kInputs));
    std::fprintf(stderr, "Asking the oracle: %s motion, many obstacles\n", nameOf(kind).c_str());
    addManyBenchmarks(kind, quick ? 10000 : 1000000);
  }
}

}  // namespace
}  // namespace footprint_collision_predictor::bench

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  const bool quick = argc == 2 && std::string(argv[1]) == "--quick";
  if (argc > 1 && !quick) {
    benchmark::ReportUnrecognizedArguments(argc, argv);
    return 2;
  }
  footprint_collision_predictor::bench::addAll(quick);
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
