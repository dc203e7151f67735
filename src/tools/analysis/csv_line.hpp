// One line of comma-separated values, for programs to read.
#pragma once

#include <ros/time.h>

#include <cstdint>
#include <string>

namespace footprint_collision_predictor::tools {

/// The shortest text from which the same number is read again; "inf", "-inf" and "nan".
std::string digits(double value);

/// Numbers are written so that reading them gives the same number again; "inf", "-inf" and "nan"
/// are what pandas and PlotJuggler understand.
class CsvLine {
 public:
  CsvLine& add(double value);
  CsvLine& add(std::int64_t value);
  CsvLine& add(const ros::Time& time);    ///< [s] with all nine decimals
  CsvLine& add(const std::string& text);  ///< in quotes where it needs them

  const std::string& text() const { return text_; }

 private:
  void separate() {
    if (!text_.empty()) text_ += ',';
  }

  std::string text_;
};

}  // namespace footprint_collision_predictor::tools
