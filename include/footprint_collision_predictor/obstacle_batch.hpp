// Many obstacles as a structure of arrays, to be gone through fast.
#pragma once

#include <cstddef>
#include <vector>

#include "footprint_collision_predictor/motion.hpp"

namespace footprint_collision_predictor::core {

/// Filled once for each moment; cleared and refilled with no more than before, it does not
/// allocate. Less than 100 bytes for each circle.
class ObstacleBatch {
 public:
  ObstacleBatch() = default;
  explicit ObstacleBatch(const std::vector<Obstacle>& obstacles);

  void clear();
  void reserve(std::size_t obstacles);
  void add(const Obstacle& obstacle);
  std::size_t size() const { return x_.size(); }

 private:
  std::vector<double> x_;
};

}  // namespace footprint_collision_predictor::core
