// Random numbers that are the same everywhere: the standard's distributions are not.
#pragma once

#include <cmath>
#include <cstdint>

#include "footprint_collision_predictor/geometry.hpp"

namespace footprint_collision_predictor::test {

/// splitmix64 (Steele, Lea, Flood 2014). One generator for each case, so that any of them can be
/// made again from (seed, index) alone.
class Random {
 public:
  explicit Random(std::uint64_t seed, std::uint64_t index = 0)
      : state_(seed * 0x9E3779B97F4A7C15u + index * 0xD1B54A32D192ED03u) {
    next();
  }

  std::uint64_t next() {
    std::uint64_t z = (state_ += 0x9E3779B97F4A7C15u);
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return z ^ (z >> 31);
  }

  double uniform(double low, double high) {
    return low + (high - low) * (static_cast<double>(next() >> 11) * 0x1p-53);
  }
  /// Every decade alike: robots meet both 1e-6 and 1e3.
  double logUniform(double low, double high) {
    return std::exp(uniform(std::log(low), std::log(high)));
  }
  /// In [low, high].
  int integer(int low, int high) {
    return low + static_cast<int>(next() % static_cast<std::uint64_t>(high - low + 1));
  }
  bool chance(double p) { return uniform(0, 1) < p; }
  double sign() { return chance(0.5) ? 1 : -1; }
  double angle() { return uniform(-M_PI, M_PI); }
  /// A unit vector.
  core::Vec2 direction() {
    const double a = angle();
    return {std::cos(a), std::sin(a)};
  }

 private:
  std::uint64_t state_;
};

}  // namespace footprint_collision_predictor::test
