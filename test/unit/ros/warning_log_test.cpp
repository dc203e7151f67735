// A fault is told once, again when it is over, and never floods the log.
#include "warning_log.hpp"

#include <gtest/gtest.h>

namespace footprint_collision_predictor {
namespace {

using Warning = CollisionWarning;

class WarningLogTest : public testing::Test {
 protected:
  /// \return the line, or "" for none
  std::string at(double seconds, std::uint8_t level, std::uint32_t reason = 0,
                 const std::string& message = "") {
    Warning warning;
    warning.level = level;
    warning.reason = reason;
    warning.message = message;
    const auto line = log.update(warning, ros::SteadyTime(seconds));
    return line ? line->text : "";
  }

  WarningLog log;
};

TEST_F(WarningLogTest, TheFirstIsTold) { EXPECT_EQ(at(1, Warning::CLEAR), "CLEAR"); }

TEST_F(WarningLogTest, AFaultIsToldOnceAndOnceMoreWhenItIsOver) {
  at(100, Warning::CLEAR);
  const std::uint32_t stale = Warning::REASON_OBSTACLES_STALE;
  EXPECT_EQ(at(102, Warning::UNKNOWN, stale, "it is old"), "UNKNOWN: it is old");
  for (int i = 1; i < 1000; ++i) EXPECT_EQ(at(102 + 0.05 * i, Warning::UNKNOWN, stale), "");
  EXPECT_EQ(at(160, Warning::CLEAR), "CLEAR (over: obstacles too old)");
  for (int i = 1; i < 1000; ++i) EXPECT_EQ(at(160 + 0.05 * i, Warning::CLEAR), "");
}

TEST_F(WarningLogTest, OneFaultOfTwoIsOver) {
  at(100, Warning::UNKNOWN, Warning::REASON_CLOCK | Warning::REASON_TRANSFORM, "both");
  EXPECT_EQ(at(102, Warning::UNKNOWN, Warning::REASON_TRANSFORM, "one"),
            "UNKNOWN: one (over: clock not running)");
}

TEST_F(WarningLogTest, WhatGetsWorseIsToldAtOnceWhatGetsBetterAfterAWhile) {
  at(100, Warning::CLEAR);
  EXPECT_EQ(at(100.01, Warning::WARN), "WARN");
  EXPECT_EQ(at(100.02, Warning::CRITICAL), "CRITICAL");
  EXPECT_EQ(at(100.03, Warning::CLEAR), "");
  EXPECT_EQ(at(101.01, Warning::CLEAR), "");
  EXPECT_EQ(at(101.03, Warning::CLEAR), "CLEAR");
}

TEST_F(WarningLogTest, AFaultThatComesAndGoesGivesNoFlood) {
  int lines = 0;
  for (int i = 0; i < 1000; ++i) {  // 10 s at 100 Hz
    const bool bad = i % 2 == 0;
    if (!at(100 + 0.01 * i, bad ? Warning::UNKNOWN : Warning::CLEAR,
            bad ? Warning::REASON_STAMP : 0)
             .empty())
      ++lines;
  }
  EXPECT_LE(lines, 22);
  EXPECT_GE(lines, 10);
}

TEST_F(WarningLogTest, ReasonsThatAlternateGiveNoFlood) {
  int lines = 0;
  for (int i = 0; i < 1000; ++i)
    if (!at(100 + 0.01 * i, Warning::UNKNOWN,
            i % 2 == 0 ? Warning::REASON_STAMP : Warning::REASON_TRANSFORM)
             .empty())
      ++lines;
  EXPECT_LE(lines, 11);
}

TEST_F(WarningLogTest, EveryReasonHasAName) {
  for (int bit = 0; bit < 28; ++bit) {
    const std::uint32_t reason = 1u << bit;
    if (reason == Warning::REASON_SETTLING ||
        (reason > Warning::REASON_SETTLING && reason < Warning::REASON_NOT_PREDICTED))
      continue;
    WarningLog fresh;
    Warning warning;
    warning.reason = reason;
    fresh.update(warning, ros::SteadyTime(100));
    warning.reason = 0;
    const auto line = fresh.update(warning, ros::SteadyTime(102));
    ASSERT_TRUE(line);
    EXPECT_NE(line->text.find("over: "), std::string::npos) << "bit " << bit;
  }
}

}  // namespace
}  // namespace footprint_collision_predictor
