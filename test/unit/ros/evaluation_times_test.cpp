// Percentiles of known series.
#include "evaluation_times.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace footprint_collision_predictor {
namespace {

ros::SteadyTime at(double seconds) { return ros::SteadyTime(seconds); }

TEST(EvaluationTimes, NothingYet) {
  const ComputationReport report = EvaluationTimes().report(0.05, at(100));
  EXPECT_EQ(report.evaluations, 0u);
  EXPECT_TRUE(std::isinf(report.since_last));
}

TEST(EvaluationTimes, PercentilesOf1To1001) {
  EvaluationTimes times;
  for (int i = 1001; i >= 2; --i) times.add(i, 990, at(100));
  const ComputationReport report = times.report(990, at(103));
  EXPECT_NEAR(report.p50, 501.5, 1);
  EXPECT_NEAR(report.p99, 991, 1);
  EXPECT_EQ(report.longest, 1001);
  EXPECT_EQ(report.late, 11u) << "991 to 1001";
  EXPECT_EQ(report.since_last, 3);
}

TEST(EvaluationTimes, OnlyTheLastThousandCount) {
  EvaluationTimes times;
  for (int i = 0; i < 5; ++i) times.add(100, 1, at(100));
  for (int i = 0; i < 1000; ++i) times.add(0.25, 1, at(101));
  const ComputationReport report = times.report(1, at(101));
  EXPECT_EQ(report.longest, 0.25);
  EXPECT_EQ(report.evaluations, 1005u);
  EXPECT_EQ(report.late, 5u);
}

}  // namespace
}  // namespace footprint_collision_predictor
