#include "level_runs.hpp"

#include <array>

namespace footprint_collision_predictor::tools {
namespace {

/// CRITICAL > UNKNOWN > WARN > CLEAR
std::uint8_t worse(std::uint8_t a, std::uint8_t b) {
  constexpr std::array<int, 4> kRank = {2, 0, 1, 3};
  return kRank.at(a) >= kRank.at(b) ? a : b;
}

}  // namespace

void LevelRuns::take(const Evaluation& evaluation) {
  const std::uint8_t level = evaluation.answer.warning.level;
  if (runs_.back().level == level) return;
  if (evaluation.elapsed <= runs_.back().begin) {  // a later answer of the same moment
    runs_.back().level = level;
    return;
  }
  runs_.push_back({evaluation.elapsed, level});
  while (runs_.size() > most_) join();
}

void LevelRuns::join() {
  std::vector<LevelRun> joined;
  for (std::size_t i = 0; i < runs_.size(); ++i) {
    const bool last = i + 1 == runs_.size();
    const bool is_short = !last && runs_[i + 1].begin - runs_[i].begin < shortest_;
    if (is_short && !joined.empty())
      joined.back().level = worse(joined.back().level, runs_[i].level);
    else if (joined.empty() || joined.back().level != runs_[i].level)
      joined.push_back(runs_[i]);
  }
  runs_ = std::move(joined);
  shortest_ *= 2;
}

}  // namespace footprint_collision_predictor::tools
