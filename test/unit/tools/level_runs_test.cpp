// The stretches of equal level of a recording.
#include "analysis/level_runs.hpp"

#include <gtest/gtest.h>

namespace footprint_collision_predictor::tools {
namespace {

using W = CollisionWarning;

class LevelRunsTest : public testing::Test {
 protected:
  void at(double elapsed, std::uint8_t level, LevelRuns& runs) {
    Evaluation evaluation{elapsed, false, {}};
    evaluation.answer.warning.level = level;
    runs.take(evaluation);
  }

  /// [s] at each level until `end`.
  static std::array<double, 4> seconds(const LevelRuns& levels, double end) {
    std::array<double, 4> sums{};
    const auto& runs = levels.runs();
    for (std::size_t i = 0; i < runs.size(); ++i)
      sums.at(runs[i].level) += (i + 1 < runs.size() ? runs[i + 1].begin : end) - runs[i].begin;
    return sums;
  }
};

TEST_F(LevelRunsTest, BeforeTheFirstEvaluationNothingIsKnown) {
  LevelRuns runs;
  at(1, W::CLEAR, runs);
  at(2, W::CLEAR, runs);
  at(3, W::WARN, runs);
  ASSERT_EQ(runs.runs().size(), 3u);
  EXPECT_EQ(seconds(runs, 4), (std::array<double, 4>{1, 2, 1, 0}));
}

TEST_F(LevelRunsTest, OfTwoAnswersOfOneMomentTheLaterCounts) {
  LevelRuns runs;
  at(0, W::CLEAR, runs);
  at(1, W::UNKNOWN, runs);
  at(1, W::CRITICAL, runs);
  EXPECT_EQ(seconds(runs, 2), (std::array<double, 4>{0, 1, 0, 1}));
}

TEST_F(LevelRunsTest, TooManyAreJoinedToTheWorseLevel) {
  LevelRuns runs(10);
  for (int i = 0; i < 1000; ++i) at(0.1 * i, i % 2 == 0 ? W::CLEAR : W::UNKNOWN, runs);
  at(100, W::CLEAR, runs);
  for (int i = 1; i < 1000; ++i) at(100 + i, W::CLEAR, runs);
  EXPECT_LE(runs.runs().size(), 10u);
  const auto sums = seconds(runs, 1100);
  EXPECT_NEAR(sums[W::UNKNOWN], 100, 15);  // not hidden
  EXPECT_NEAR(sums[W::CLEAR], 1000, 15);
}

TEST_F(LevelRunsTest, CriticalIsWorseThanUnknown) {
  LevelRuns runs(4);
  const std::array<std::uint8_t, 4> levels = {W::UNKNOWN, W::CRITICAL, W::WARN, W::CLEAR};
  for (std::size_t i = 0; i < 400; ++i) at(0.1 * static_cast<double>(i), levels.at(i % 4), runs);
  EXPECT_GT(seconds(runs, 40)[W::CRITICAL], 30);
}

}  // namespace
}  // namespace footprint_collision_predictor::tools
