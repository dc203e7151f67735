#include "footprint_collision_predictor/obstacle_batch.hpp"

#include <algorithm>

#include "shape.hpp"

namespace footprint_collision_predictor::core {

ObstacleBatch::ObstacleBatch(const std::vector<Obstacle>& obstacles) {
  resize(obstacles.size());
  for (std::size_t i = 0; i < obstacles.size(); ++i) put(obstacles[i], i);
}

void ObstacleBatch::clear() {
  for (auto* values : {&x, &y, &vx, &vy, &ax, &ay, &radius, &radius_rate, &bounding_radius})
    values->clear();
  outline_end_.clear();
  outline_edges_.clear();
  largest_coordinates_ = largest_speed_ = largest_acceleration_ = 0;
  grows_ = false;
}

void ObstacleBatch::reserve(std::size_t obstacles) {
  for (auto* values : {&x, &y, &vx, &vy, &ax, &ay, &radius, &radius_rate, &bounding_radius})
    values->reserve(obstacles);
  outline_end_.reserve(obstacles);
}

void ObstacleBatch::add(const Obstacle& obstacle) {
  resize(size() + 1);
  put(obstacle, size() - 1);
}

void ObstacleBatch::resize(std::size_t obstacles) {
  for (auto* values : {&x, &y, &vx, &vy, &ax, &ay, &radius, &radius_rate, &bounding_radius})
    values->resize(obstacles);
  outline_end_.resize(obstacles);
}

void ObstacleBatch::put(const Obstacle& obstacle, std::size_t i) {
  const Motion& m = obstacle.motion();
  x[i] = m.position.x();
  y[i] = m.position.y();
  vx[i] = m.velocity.x();
  vy[i] = m.velocity.y();
  ax[i] = m.acceleration.x();
  ay[i] = m.acceleration.y();
  radius[i] = obstacle.radius();
  radius_rate[i] = obstacle.disc().radius_rate;
  bounding_radius[i] = boundingRadius(obstacle);
  appendOutline(obstacle, &outline_edges_);
  outline_end_[i] = static_cast<std::uint32_t>(outline_edges_.size());
  largest_coordinates_ = std::max(largest_coordinates_, m.position.lpNorm<1>());
  largest_speed_ = std::max(largest_speed_, m.velocity.lpNorm<1>());
  largest_acceleration_ = std::max(largest_acceleration_, m.acceleration.lpNorm<1>());
  grows_ = grows_ || radius_rate[i] > 0;
}

Disc ObstacleBatch::disc(std::size_t i) const {
  return {{{x[i], y[i]}, {vx[i], vy[i]}, {ax[i], ay[i]}}, radius[i], radius_rate[i]};
}

Outline ObstacleBatch::outline(std::size_t i) const {
  const std::size_t begin = i == 0 ? 0 : outline_end_[i - 1];
  return {outline_edges_.data() + begin, outline_end_[i] - begin};
}

}  // namespace footprint_collision_predictor::core
