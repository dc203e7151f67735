#include "footprint_collision_predictor/obstacle_batch.hpp"

#include <algorithm>

#include "rounding.hpp"
#include "shape.hpp"

namespace footprint_collision_predictor::core {
namespace {

float notLess(double value) { return static_cast<float>((1 + kGenerousSingle) * value); }

}  // namespace

ObstacleBatch::ObstacleBatch(const std::vector<Obstacle>& obstacles) {
  resize(obstacles.size());
  for (std::size_t i = 0; i < obstacles.size(); ++i) put(obstacles[i], i);
}

void ObstacleBatch::clear() {
  resize(0);
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
  discs_.resize(obstacles);
  ObstacleColumns& c = columns_;
  for (auto* column : {&c.x, &c.y, &c.vx, &c.vy, &c.ax, &c.ay, &c.bounding_radius, &c.radius_rate})
    column->resize(obstacles);
}

void ObstacleBatch::put(const Obstacle& obstacle, std::size_t i) {
  const Motion& m = obstacle.motion();
  if (i == 0) origin_ = m.position;
  const Vec2 position = m.position - origin_;
  ObstacleColumns& c = columns_;
  discs_[i] = obstacle.disc();
  c.x[i] = static_cast<float>(position.x());
  c.y[i] = static_cast<float>(position.y());
  c.vx[i] = static_cast<float>(m.velocity.x());
  c.vy[i] = static_cast<float>(m.velocity.y());
  c.ax[i] = static_cast<float>(m.acceleration.x());
  c.ay[i] = static_cast<float>(m.acceleration.y());
  c.bounding_radius[i] = notLess(obstacle.boundingRadius());
  c.radius_rate[i] = static_cast<float>(obstacle.disc().radius_rate);
  appendOutline(obstacle, &outline_edges_);
  if (!outline_edges_.empty()) {
    outline_end_.resize(i + 1);  // that of circles before the first outline is 0
    outline_end_[i] = static_cast<std::uint32_t>(outline_edges_.size());
  }
  largest_coordinates_ = std::max(largest_coordinates_, position.lpNorm<1>());
  largest_speed_ = std::max(largest_speed_, m.velocity.lpNorm<1>());
  largest_acceleration_ = std::max(largest_acceleration_, m.acceleration.lpNorm<1>());
  grows_ = grows_ || obstacle.disc().radius_rate > 0;
}

Outline ObstacleBatch::outline(std::size_t i) const {
  if (outline_edges_.empty()) return {};
  const std::size_t begin = i == 0 ? 0 : outline_end_[i - 1];
  return {outline_edges_.data() + begin, outline_end_[i] - begin};
}

}  // namespace footprint_collision_predictor::core
