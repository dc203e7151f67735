// Random numbers that are the same with every compiler and standard library.
#pragma once

#include <cmath>
#include <cstdint>
#include <random>

namespace footprint_collision_predictor::tools {

class RandomNumbers {
 public:
  explicit RandomNumbers(std::uint64_t seed) : engine_(seed) {}

  double uniform(double low, double high) {
    constexpr double kStep = 1.0 / 9007199254740992.0;  // 2^-53
    return low + (high - low) * kStep * static_cast<double>(engine_() >> 11);
  }

  /// Of mean 0 and standard deviation 1, by Box and Muller.
  double normal() {
    constexpr double kTurn = 2 * 3.14159265358979323846;
    const double radius = std::sqrt(-2 * std::log(1 - uniform(0, 1)));
    return radius * std::cos(uniform(0, kTurn));
  }

 private:
  std::mt19937_64 engine_;  // whose sequence the standard fixes; its distributions are not
};

}  // namespace footprint_collision_predictor::tools
