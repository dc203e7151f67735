// The level of one moment.
#include "footprint_collision_predictor/warning.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace footprint_collision_predictor::core {
namespace {

const Thresholds kThresholds{3, 1.5};

Level assessed(std::optional<double> time, bool good) { return assess(time, good, kThresholds); }

TEST(Level, HasTheValuesOfTheMessage) {
  EXPECT_EQ(static_cast<int>(Level::kUnknown), 0);
  EXPECT_EQ(static_cast<int>(Level::kClear), 1);
  EXPECT_EQ(static_cast<int>(Level::kWarn), 2);
  EXPECT_EQ(static_cast<int>(Level::kCritical), 3);
}

TEST(Level, IsOrderedCriticalUnknownWarnClear) {
  const Level order[] = {Level::kCritical, Level::kUnknown, Level::kWarn, Level::kClear};
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) {
      EXPECT_EQ(isWorse(order[i], order[j]), i < j) << i << " " << j;
      EXPECT_EQ(worse(order[i], order[j]), order[i < j ? i : j]) << i << " " << j;
    }
}

TEST(Level, AValueThatIsNoneCountsAsUnknown) {
  const auto none = static_cast<Level>(7);
  EXPECT_TRUE(isWorse(none, Level::kWarn));
  EXPECT_FALSE(isWorse(none, Level::kUnknown));
  EXPECT_TRUE(isWorse(Level::kCritical, none));
}

TEST(Assess, ThresholdsAreInclusive) {
  EXPECT_EQ(assessed(0, true), Level::kCritical);
  EXPECT_EQ(assessed(1.5, true), Level::kCritical);
  EXPECT_EQ(assessed(std::nextafter(1.5, 2), true), Level::kWarn);
  EXPECT_EQ(assessed(3, true), Level::kWarn);
  EXPECT_EQ(assessed(std::nextafter(3.0, 4), true), Level::kClear);
  EXPECT_EQ(assessed(std::nullopt, true), Level::kClear);
}

TEST(Assess, OneBadInputMakesItUnknownUnlessAHitIsCertain) {
  EXPECT_EQ(assessed(std::nullopt, false), Level::kUnknown);
  EXPECT_EQ(assessed(4, false), Level::kUnknown);
  EXPECT_EQ(assessed(3, false), Level::kUnknown);
  EXPECT_EQ(assessed(std::nextafter(1.5, 2), false), Level::kUnknown);
  EXPECT_EQ(assessed(1.5, false), Level::kCritical);
  EXPECT_EQ(assessed(0, false), Level::kCritical);
}

TEST(Assess, EqualThresholdsLeaveNoWarn) {
  EXPECT_EQ(assess(2, true, {2, 2}), Level::kCritical);
  EXPECT_EQ(assess(2.1, true, {2, 2}), Level::kClear);
}

}  // namespace
}  // namespace footprint_collision_predictor::core
