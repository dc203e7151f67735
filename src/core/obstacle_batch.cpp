#include "footprint_collision_predictor/obstacle_batch.hpp"

#include <algorithm>

#include "shape.hpp"

namespace footprint_collision_predictor::core {

ObstacleBatch::ObstacleBatch(const std::vector<Obstacle>& obstacles) {
  resize(obstacles.size());
  for (std::size_t i = 0; i < obstacles.size(); ++i) put(obstacles[i], i);
}

template <typename Change>
void ObstacleBatch::changeColumns(const Change& change) {
  ObstacleColumns& c = columns_;
  for (auto* column :
       {&c.x, &c.y, &c.vx, &c.vy, &c.ax, &c.ay, &c.radius, &c.radius_rate, &c.bounding_radius})
    change(*column);
}

void ObstacleBatch::clear() {
  changeColumns([](auto& column) { column.clear(); });
  outline_end_.clear();
  outline_edges_.clear();
  largest_coordinates_ = largest_speed_ = largest_acceleration_ = 0;
  grows_ = false;
}

void ObstacleBatch::add(const Obstacle& obstacle) {
  resize(size() + 1);
  put(obstacle, size() - 1);
}

void ObstacleBatch::resize(std::size_t obstacles) {
  changeColumns([&](auto& column) { column.resize(obstacles); });
  outline_end_.resize(obstacles);
}

void ObstacleBatch::put(const Obstacle& obstacle, std::size_t i) {
  const Motion& m = obstacle.motion();
  ObstacleColumns& c = columns_;
  c.x[i] = m.position.x();
  c.y[i] = m.position.y();
  c.vx[i] = m.velocity.x();
  c.vy[i] = m.velocity.y();
  c.ax[i] = m.acceleration.x();
  c.ay[i] = m.acceleration.y();
  c.radius[i] = obstacle.radius();
  c.radius_rate[i] = obstacle.disc().radius_rate;
  c.bounding_radius[i] = core::boundingRadius(obstacle);
  appendOutline(obstacle, &outline_edges_);
  outline_end_[i] = static_cast<std::uint32_t>(outline_edges_.size());
  largest_coordinates_ = std::max(largest_coordinates_, m.position.lpNorm<1>());
  largest_speed_ = std::max(largest_speed_, m.velocity.lpNorm<1>());
  largest_acceleration_ = std::max(largest_acceleration_, m.acceleration.lpNorm<1>());
  grows_ = grows_ || c.radius_rate[i] > 0;
}

Disc ObstacleBatch::disc(std::size_t i) const {
  const ObstacleColumns& c = columns_;
  // A column of zeros is not looked into: it would have to be fetched from far away.
  const Vec2 acceleration = largest_acceleration_ > 0 ? Vec2(c.ax[i], c.ay[i]) : Vec2(Vec2::Zero());
  const double radius_rate = grows_ ? c.radius_rate[i] : 0;
  return {{{c.x[i], c.y[i]}, {c.vx[i], c.vy[i]}, acceleration}, c.radius[i], radius_rate};
}

Outline ObstacleBatch::outline(std::size_t i) const {
  if (outline_edges_.empty()) return {outline_edges_.data(), 0};
  const std::size_t begin = i == 0 ? 0 : outline_end_[i - 1];
  return {outline_edges_.data() + begin, outline_end_[i] - begin};
}

}  // namespace footprint_collision_predictor::core
