#include "analysis/csv_line.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <limits>

namespace footprint_collision_predictor::tools {
namespace {

using Limits = std::numeric_limits<double>;

std::string written(double value) { return CsvLine().add(value).text(); }

TEST(CsvLineTest, NumbersReadBackTheSame) {
  for (const double value :
       {0.1, 1.0 / 3, -1e-300, 1e22, 123456789.987654321, Limits::max(), Limits::denorm_min(), 5.0})
    EXPECT_EQ(std::strtod(written(value).c_str(), nullptr), value) << written(value);
}

TEST(CsvLineTest, WhatIsNoNumberReadsAsPandasAndPlotJugglerHaveIt) {
  EXPECT_EQ(written(Limits::infinity()), "inf");
  EXPECT_EQ(written(-Limits::infinity()), "-inf");
  EXPECT_EQ(written(Limits::quiet_NaN()), "nan");
  EXPECT_EQ(written(-Limits::quiet_NaN()), "nan");
}

TEST(CsvLineTest, TimesKeepEveryNanosecond) {
  EXPECT_EQ(CsvLine().add(ros::Time(1600000000, 7)).text(), "1600000000.000000007");
}

TEST(CsvLineTest, FieldsAreSeparatedAndTextsQuotedWhereNeeded) {
  CsvLine line;
  line.add(std::int64_t{-1}).add(std::string("a b.bag")).add(std::string("a, \"b\".bag")).add(0.5);
  EXPECT_EQ(line.text(), "-1,a b.bag,\"a, \"\"b\"\".bag\",0.5");
}

}  // namespace
}  // namespace footprint_collision_predictor::tools
