// Many obstacles as a structure of arrays, to be gone through fast.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "footprint_collision_predictor/motion.hpp"

namespace footprint_collision_predictor::core {

/// Edges of a line (1), of a closed polygon (more), or none of a circle; somebody else's.
struct Outline {
  const Edge* first = nullptr;
  std::size_t size = 0;

  const Edge* begin() const { return first; }
  const Edge* end() const { return first + size; }
  bool isClosed() const { return size > 1; }
};

/// What the broad phase goes through, in single precision; one value for each obstacle.
struct ObstacleColumns {
  std::vector<float> x, y;             ///< [m] position relative to the first obstacle's
  std::vector<float> vx, vy;           ///< [m/s] velocity
  std::vector<float> ax, ay;           ///< [m/s^2] acceleration
  std::vector<float> bounding_radius;  ///< [m] of a circle about the position that holds it all now
  std::vector<float> radius_rate;      ///< [m/s]
};

/// Obstacles, laid out for firstContact() and firstContacts(). Filled once for each moment; cleared
/// and refilled with no more than before, it does not allocate. 96 bytes for each circle.
class ObstacleBatch {
 public:
  ObstacleBatch() = default;
  explicit ObstacleBatch(const std::vector<Obstacle>& obstacles);

  void clear();
  void add(const Obstacle& obstacle);
  std::size_t size() const { return discs_.size(); }

  const Disc& disc(std::size_t i) const { return discs_[i]; }
  /// Relative to the disc's centre.
  Outline outline(std::size_t i) const;
  /// [m] of a circle about the position that holds it all now
  double boundingRadius(std::size_t i) const { return columns_.bounding_radius[i]; }
  /// [m/s^2] at least that of every obstacle
  double largestAcceleration() const { return largest_acceleration_; }
  /// Whether the radius of any obstacle grows.
  bool grows() const { return grows_; }
  /// [m] where columns() has its origin
  const Vec2& origin() const { return origin_; }
  /// [m] at least as far as any obstacle gets from there within a time [s]
  double farthest(double horizon) const {
    return largest_coordinates_ +
           horizon * (largest_speed_ + 0.5 * horizon * largest_acceleration_);
  }

  const ObstacleColumns& columns() const { return columns_; }

 private:
  void resize(std::size_t obstacles);
  void put(const Obstacle& obstacle, std::size_t i);

  std::vector<Disc> discs_;
  Vec2 origin_{0, 0};
  ObstacleColumns columns_;
  std::vector<std::uint32_t> outline_end_;  ///< in outline_edges_; none while that is empty
  std::vector<Edge> outline_edges_;
  double largest_coordinates_ = 0, largest_speed_ = 0, largest_acceleration_ = 0;
  bool grows_ = false;
};

}  // namespace footprint_collision_predictor::core
