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

/// One value for each obstacle, for what goes through all of them.
struct ObstacleColumns {
  std::vector<double> x, y;             ///< [m] position
  std::vector<double> vx, vy;           ///< [m/s] velocity
  std::vector<double> ax, ay;           ///< [m/s^2] acceleration
  std::vector<double> radius;           ///< [m]
  std::vector<double> radius_rate;      ///< [m/s]
  std::vector<double> bounding_radius;  ///< [m]
};

/// Obstacles, laid out for firstContact() and firstContacts(). Filled once for each moment; cleared
/// and refilled with no more than before, it does not allocate. 76 bytes for each circle.
class ObstacleBatch {
 public:
  ObstacleBatch() = default;
  explicit ObstacleBatch(const std::vector<Obstacle>& obstacles);

  void clear();
  void add(const Obstacle& obstacle);
  std::size_t size() const { return columns_.x.size(); }

  Disc disc(std::size_t i) const;
  /// Relative to the disc's centre.
  Outline outline(std::size_t i) const;
  /// [m] of the circle about the position that holds it all now
  double boundingRadius(std::size_t i) const { return columns_.bounding_radius[i]; }
  /// [m/s^2] at least that of every obstacle
  double largestAcceleration() const { return largest_acceleration_; }
  /// Whether the radius of any obstacle grows.
  bool grows() const { return grows_; }
  /// [m] at least as far as any obstacle gets from the origin within a time [s]
  double farthest(double horizon) const {
    return largest_coordinates_ +
           horizon * (largest_speed_ + 0.5 * horizon * largest_acceleration_);
  }

  const ObstacleColumns& columns() const { return columns_; }

 private:
  void resize(std::size_t obstacles);
  void put(const Obstacle& obstacle, std::size_t i);

  template <typename Change>
  void changeColumns(const Change& change);

  ObstacleColumns columns_;
  std::vector<std::uint32_t> outline_end_;  ///< in outline_edges_
  std::vector<Edge> outline_edges_;
  double largest_coordinates_ = 0, largest_speed_ = 0, largest_acceleration_ = 0;
  bool grows_ = false;
};

}  // namespace footprint_collision_predictor::core
