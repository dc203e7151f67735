// One line of the results: a method that is called over and over, and how right it was.
#pragma once

#include <benchmark/benchmark.h>

#include <algorithm>
#include <ctime>
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

/// How often to go through all inputs in one repetition, and how many of these to make.
struct Effort {
  benchmark::IterationCount passes;
  int repetitions;
};

/// Long enough for the clock and the scheduler not to matter, and every input equally often. What
/// takes long by itself is repeated less often.
template <typename Call>
Effort effortFor(std::size_t inputs, const Call& call) {
  constexpr double kSeconds = 0.02;
  constexpr double kLong = 0.2;  // [s]
  constexpr std::size_t kSample = 4096;
  const std::size_t sample = std::min(inputs, kSample);
  const std::clock_t start = std::clock();  // of the processor: others may be busy, too
  for (std::size_t i = 0; i < sample; ++i) benchmark::DoNotOptimize(call(i));
  const double took = static_cast<double>(std::clock() - start + 1) / CLOCKS_PER_SEC;
  const double one_pass = took * static_cast<double>(inputs) / static_cast<double>(sample);
  return {std::max<benchmark::IterationCount>(
              1, static_cast<benchmark::IterationCount>(kSeconds / one_pass)),
          one_pass < kLong ? 5 : 3};
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
  const Effort effort = effortFor(inputs, call);
  benchmark::RegisterBenchmark(name.c_str(), measure)
      ->Iterations(effort.passes * static_cast<benchmark::IterationCount>(inputs))
      ->Repetitions(effort.repetitions);
}

}  // namespace footprint_collision_predictor::bench
