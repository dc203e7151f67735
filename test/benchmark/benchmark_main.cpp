// How long the core takes, beside what a user could take instead, on the same inputs in one run.
// With --quick only the footprint of 8 edges, straight, accelerating and turning, and no more than
// 10,000 obstacles.
#include <benchmark/benchmark.h>

#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "benchmarks.hpp"

namespace footprint_collision_predictor::bench {
namespace {

/// Has `add` called with the scene and its true answers.
template <typename... Add>
void with(Scene scene, const Add&... add) {
  std::fprintf(stderr, "Asking the oracle: %s\n", scene.name().c_str());
  const auto shared = std::make_shared<const Scene>(std::move(scene));
  const SceneTruths truths(*shared);
  (add(shared, truths), ...);
}

void addEightEdges(Kind kind, std::size_t most) {
  for (const Contacts contacts : {Contacts::kMixed, Contacts::kLate})
    with(convexScene(8, kind, contacts, most), addFootprintBenchmarks, addManyBenchmarks);
}

void addShapes(Kind kind) {
  for (const int edges : {4, 16, 32})
    with(convexScene(edges, kind, Contacts::kMixed, kInputs), addFootprintBenchmarks);
  with(concaveScene(kind, Contacts::kMixed, kInputs), addFootprintBenchmarks);
}

void addAll(bool quick) {
  for (const Kind kind : {Kind::kStraight, Kind::kAccelerating, Kind::kTurning}) {
    addEightEdges(kind, quick ? kInputs : 1000000);
    if (!quick) addShapes(kind);
  }
  if (quick) return;
  for (const Kind kind : {Kind::kStraight, Kind::kAccelerating})
    with(convexScene(8, kind, Contacts::kMixed, kInputs), addSegmentBenchmarks);
  for (const Kind kind : {Kind::kGrowing, Kind::kWalls}) addEightEdges(kind, kInputs);
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
  footprint_collision_predictor::bench::addContext();
  footprint_collision_predictor::bench::addAll(quick);
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
