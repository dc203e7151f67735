// How long the core takes, beside what a user could take instead, on the same inputs in one run.
// With --quick only the footprint of 8 edges, and no more than 10,000 obstacles.
#include <benchmark/benchmark.h>

#include <cstdio>
#include <string>

#include "benchmarks.hpp"

namespace footprint_collision_predictor::bench {
namespace {

void addFootprint(const std::string& name, const Polygon& footprint, bool convex) {
  for (const MotionKind kind : {MotionKind::kStraight, MotionKind::kAccelerating}) {
    std::fprintf(stderr, "Asking the oracle: %s motion, footprint %s\n", nameOf(kind).c_str(),
                 name.c_str());
    const auto scene = std::make_shared<const Scene>(makeScene(name, footprint, kind, kInputs));
    addFootprintBenchmarks(scene, convex);
    if (name == "8") addSegmentBenchmarks(scene);
  }
}

void addAll(bool quick) {
  for (const int edges : {4, 8, 16, 32})
    if (edges == 8 || !quick) addFootprint(std::to_string(edges), convexFootprint(edges), true);
  if (!quick) addFootprint("concave", concaveFootprint(), false);
  std::fprintf(stderr, "Asking the oracle: many obstacles\n");
  for (const MotionKind kind : {MotionKind::kStraight, MotionKind::kAccelerating})
    addManyBenchmarks(kind, quick ? 10000 : 1000000);
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
