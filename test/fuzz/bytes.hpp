// Numbers from raw bytes, such that few bytes make the numbers in which trouble lies.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "footprint_collision_predictor/geometry.hpp"

namespace footprint_collision_predictor::test {

class Bytes {
 public:
  Bytes(const std::uint8_t* data, std::size_t size) : data_(data), left_(size) {}

  std::uint8_t byte() {
    if (left_ == 0) return 0;
    --left_;
    return *data_++;
  }

  /// Within [-limit, limit], never NaN: a small integer, a fraction, any power of two, all 64 bits
  /// as they come, or a value already used, exactly or a few ulp beside it.
  double number(double limit) {
    const std::uint8_t kind = byte();
    const double value = std::clamp(drawn(kind), -limit, limit);
    used_[kind % kUsed] = value;
    return value;
  }
  double notNegative(double limit) { return std::abs(number(limit)); }
  core::Vec2 vector(double limit) {
    const double x = number(limit);
    return {x, number(limit)};
  }

 private:
  static constexpr std::size_t kUsed = 8;

  double drawn(std::uint8_t kind) {
    const int small = static_cast<std::int8_t>(byte());
    switch (kind >> 5) {
      case 0:
      case 1:
        return small;
      case 2:
        return small / 16.0;
      case 3:
        return std::ldexp(small < 0 ? -1 : 1, small);
      case 4:
        return std::ldexp(0.01 * small, static_cast<std::int8_t>(byte()) / 4);
      case 5:
        return used_[kind % kUsed];
      case 6:
        return ulpsAway(used_[kind % kUsed], small / 16);
      default:
        return anyBits();
    }
  }

  double anyBits() {
    std::uint64_t bits = 0;
    for (int i = 0; i < 8; ++i) bits = bits << 8 | byte();
    double value;
    std::memcpy(&value, &bits, sizeof(value));
    return std::isnan(value) ? 0 : value;
  }

  static double ulpsAway(double x, int steps) {
    for (int i = std::abs(steps); i > 0; --i)
      x = std::nextafter(x, steps > 0 ? HUGE_VAL : -HUGE_VAL);
    return x;
  }

  const std::uint8_t* data_;
  std::size_t left_;
  double used_[kUsed] = {};
};

}  // namespace footprint_collision_predictor::test
