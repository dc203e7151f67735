// One line of the results: a method that is called over and over, and how right it was.
#pragma once

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <string>

#include "score.hpp"

namespace footprint_collision_predictor::bench {

/// \param queries that one call answers: the time is given for each of them
inline void report(const Score& score, const Tolerance& tolerance, std::size_t queries,
                   benchmark::State* state) {
  auto& counters = state->counters;
  counters["queries_per_call"] = static_cast<double>(queries);
  counters["questions"] = static_cast<double>(score.questions);
  counters["hits"] = static_cast<double>(score.hits);
  counters["misses"] = static_cast<double>(score.misses);
  counters["late"] = static_cast<double>(score.late);
  counters["inventions"] = static_cast<double>(score.inventions);
  counters["worst_time_error"] = score.worst_time_error;
  counters["tolerance_m"] = tolerance.clearance;
  counters["tolerance_s"] = tolerance.time;
}

/// How often to go through all inputs in one repetition: long enough for the clock and the
/// scheduler not to matter, and every input equally often.
template <typename Call>
benchmark::IterationCount passes(std::size_t inputs, const Call& call) {
  constexpr double kSeconds = 0.05;
  constexpr std::size_t kSample = 4096;
  const std::size_t sample = std::min(inputs, kSample);
  const auto start = std::chrono::steady_clock::now();
  for (std::size_t i = 0; i < sample; ++i) benchmark::DoNotOptimize(call(i));
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  const double one_pass = took.count() * static_cast<double>(inputs) / static_cast<double>(sample);
  return std::max<benchmark::IterationCount>(
      1, static_cast<benchmark::IterationCount>(kSeconds / one_pass));
}

/// \param call anything(std::size_t input), as its own type: a std::function would cost a fast
///     method more than a slow one.
template <typename Call>
void addMeasurement(const std::string& name, std::size_t inputs, std::size_t queries,
                    const Score& score, const Tolerance& tolerance, const Call& call) {
  const auto measure = [=](benchmark::State& state) {
    std::size_t i = 0;
    for (auto _ : state) {
      benchmark::DoNotOptimize(call(i));
      if (++i == inputs) i = 0;
    }
    report(score, tolerance, queries, &state);
  };
  benchmark::RegisterBenchmark(name.c_str(), measure)
      ->Iterations(passes(inputs, call) * static_cast<benchmark::IterationCount>(inputs));
}

/// "footprint/straight/8": what is asked, of which scene.
inline std::string pathOf(const std::string& what, const Scene& scene) {
  return what + "/" + nameOf(scene.kind) + "/" + scene.name;
}

}  // namespace footprint_collision_predictor::bench
