// At which level a recording was, and when.
#pragma once

#include <cstdint>
#include <vector>

#include "replay.hpp"

namespace footprint_collision_predictor::tools {

/// From `begin` [s] on, until the next run or the recording's end.
struct LevelRun {
  double begin;
  std::uint8_t level;
};

/// The runs of equal level, in order; the first begins at 0. Memory is bounded: where there are too
/// many, short ones are joined with the one before them, as the worse level of both.
class LevelRuns {
 public:
  explicit LevelRuns(std::size_t most = 20000) : most_(most) {}

  void take(const Evaluation& evaluation);
  const std::vector<LevelRun>& runs() const { return runs_; }

 private:
  void join();

  const std::size_t most_;
  double shortest_ = 0.01;  // [s]
  std::vector<LevelRun> runs_{{0, CollisionWarning::UNKNOWN}};
};

}  // namespace footprint_collision_predictor::tools
