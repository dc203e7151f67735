#include "csv_line.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>

namespace footprint_collision_predictor::tools {

std::string digits(double value) {
  if (std::isnan(value)) return "nan";
  if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
  std::array<char, 40> text;
#if defined(__cpp_lib_to_chars)
  const auto end = std::to_chars(text.begin(), text.end(), value).ptr;
  return {text.begin(), end};
#else  // GCC before 11
  return {text.data(),
          static_cast<std::size_t>(std::snprintf(text.data(), text.size(), "%.17g", value))};
#endif
}

CsvLine& CsvLine::add(double value) {
  separate();
  text_ += digits(value);
  return *this;
}

CsvLine& CsvLine::add(std::int64_t value) {
  separate();
  text_ += std::to_string(value);
  return *this;
}

CsvLine& CsvLine::add(const ros::Time& time) {
  separate();
  std::array<char, 40> text;
  std::snprintf(text.data(), text.size(), "%u.%09u", time.sec, time.nsec);
  text_ += text.data();
  return *this;
}

CsvLine& CsvLine::add(const std::string& text) {
  separate();
  if (text.find_first_of(",\"\n\r") == std::string::npos) {
    text_ += text;
    return *this;
  }
  text_ += '"';
  for (const char c : text) text_ += c == '"' ? std::string("\"\"") : std::string(1, c);
  text_ += '"';
  return *this;
}

}  // namespace footprint_collision_predictor::tools
