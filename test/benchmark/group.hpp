// Methods that answer the same questions: each is put to the oracle once, then measured.
#pragma once

#include <benchmark/benchmark.h>

#include <string>
#include <utility>
#include <vector>

#include "score.hpp"

namespace footprint_collision_predictor::bench {

/// The questions of one scene with their true answers; needed only while methods are added.
class Group {
 public:
  Group(std::string name, std::vector<Question> questions);

  const std::string& name() const { return name_; }
  std::size_t size() const { return questions_.size(); }
  const std::vector<double>& truths() const { return truths_; }

  /// \param answer double(std::size_t): first contact of question i, or kNever. Called through its
  ///     own type, since a std::function would cost a fast method more than a slow one.
  template <typename Answer>
  void add(const std::string& method, const Tolerance& tolerance, const Answer& answer) const {
    registerMeasurement(method, tolerance, judge(questions_, truths_, tolerance, answer), answer);
  }

 private:
  template <typename Answer>
  void registerMeasurement(const std::string& method, const Tolerance& tolerance,
                           const Score& score, const Answer& answer) const {
    const std::size_t inputs = size();
    const auto measure = [=](benchmark::State& state) {
      std::size_t i = 0;
      for (auto _ : state) {
        benchmark::DoNotOptimize(answer(i));
        if (++i == inputs) i = 0;
      }
      report(score, tolerance, inputs, &state);
    };
    // Every input exactly once in each repetition, by everybody.
    benchmark::RegisterBenchmark((name_ + "/" + method).c_str(), measure)
        ->Iterations(static_cast<benchmark::IterationCount>(inputs));
  }

  static void report(const Score& score, const Tolerance& tolerance, std::size_t inputs,
                     benchmark::State* state);

  std::string name_;
  std::vector<Question> questions_;
  std::vector<double> truths_;
};

/// The whole footprint against one obstacle at a time.
Group footprintGroup(const Scene& scene);
/// One segment against one obstacle: the segments take turns.
Group segmentGroup(const Scene& scene);

}  // namespace footprint_collision_predictor::bench
