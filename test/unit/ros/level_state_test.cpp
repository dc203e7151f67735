// The rules of the level, as a table of what comes and what is shown.
#include "level_state.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace footprint_collision_predictor {
namespace {

using core::Level;
using Warning = CollisionWarning;

Findings of(std::uint32_t reason) {
  Findings findings;
  if (reason != 0) findings.add(reason, "reason " + std::to_string(reason));
  return findings;
}

class LevelStateTest : public testing::Test {
 protected:
  Level show(const Sight& sight, std::uint32_t reason = 0, Counts counts = Counts::kAsNew) {
    findings = of(reason);
    return state.judge(sight, counts, findings);
  }
  Level hit(double time, std::uint32_t reason = 0) { return show({true, time}, reason); }
  Level free(std::uint32_t reason = 0) { return show({true, std::nullopt}, reason); }
  Level nothing(std::uint32_t reason = 0) { return show({}, reason); }
  void settle() {
    for (int i = 0; i < 3; ++i) free();
  }

  LevelState state{{3, 1.5}, 3};
  Findings findings;
};

TEST_F(LevelStateTest, ClearOnlyAfterEnoughGoodMessages) {
  for (int i = 0; i < 2; ++i) {
    EXPECT_EQ(free(), Level::kUnknown);
    EXPECT_EQ(findings.reasons(), Warning::REASON_SETTLING);
  }
  EXPECT_EQ(free(), Level::kClear);
  EXPECT_TRUE(findings.empty());
}

TEST_F(LevelStateTest, RepeatsDoNotCount) {
  for (int i = 0; i < 100; ++i)
    EXPECT_EQ(show({true, std::nullopt}, 0, Counts::kNot), Level::kUnknown);
  settle();
  EXPECT_EQ(show({true, 1.0}, 0, Counts::kNot), Level::kCritical) << "but they show what is worse";
  EXPECT_EQ(show({true, std::nullopt}, 0, Counts::kNot), Level::kClear) << "and hold nothing";
}

TEST_F(LevelStateTest, WithoutAnEvaluationItIsUnknownWhateverIsHeld) {
  hit(1);
  EXPECT_EQ(nothing(Warning::REASON_OBSTACLES_STALE), Level::kUnknown);
  EXPECT_EQ(findings.reasons(), Warning::REASON_OBSTACLES_STALE) << "not settling as well";
}

TEST_F(LevelStateTest, EveryReasonBelow2To24MakesUnknownAndNoneAbove) {
  for (int bit = 0; bit < 28; ++bit) {
    settle();
    EXPECT_EQ(free(1u << bit), bit < 24 ? Level::kUnknown : Level::kClear) << "bit " << bit;
  }
}

TEST_F(LevelStateTest, ACertainHitIsCriticalWhateverElseIsWrong) {
  EXPECT_EQ(hit(1.5, Warning::REASON_OBSTACLES_INVALID), Level::kCritical);
  EXPECT_EQ(hit(1.6, Warning::REASON_OBSTACLES_INVALID), Level::kUnknown);
  EXPECT_EQ(hit(1.6), Level::kUnknown) << "UNKNOWN is not left before three good ones";
}

TEST_F(LevelStateTest, AHeldLevelSaysSo) {
  settle();
  hit(2);
  EXPECT_EQ(free(), Level::kWarn);
  EXPECT_EQ(findings.reasons(), 0u);
  EXPECT_NE(findings.text().find("3 obstacles messages in a row"), std::string::npos);
}

TEST_F(LevelStateTest, ResetForgetsAllThatWasHeld) {
  settle();
  state.reset();
  EXPECT_EQ(free(), Level::kUnknown);
}

TEST_F(LevelStateTest, NewThresholdsCountFromTheNextSight) {
  settle();
  EXPECT_EQ(hit(2), Level::kWarn);
  state.reconfigure({3, 2.5}, 3);
  EXPECT_EQ(hit(2), Level::kCritical);
  state.reconfigure({3, 2.5}, 1);
  EXPECT_EQ(free(), Level::kClear);
}

}  // namespace
}  // namespace footprint_collision_predictor
