#include "footprint_collision_predictor/obstacle_batch.hpp"

#include <algorithm>

namespace footprint_collision_predictor::core {

ObstacleBatch::ObstacleBatch(const std::vector<Obstacle>& obstacles) {
  reserve(obstacles.size());
  for (const Obstacle& obstacle : obstacles) add(obstacle);
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
  const Motion& m = obstacle.motion();
  x.push_back(m.position.x());
  y.push_back(m.position.y());
  vx.push_back(m.velocity.x());
  vy.push_back(m.velocity.y());
  ax.push_back(m.acceleration.x());
  ay.push_back(m.acceleration.y());
  radius.push_back(obstacle.radius());
  radius_rate.push_back(obstacle.disc().radius_rate);
  double reach = 0;
  const std::vector<Vec2>& vertices = obstacle.outline();
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    reach = std::max(reach, vertices[i].norm());
    if (vertices.size() > 2 || i == 0)
      outline_edges_.emplace_back(Segment{vertices[i], vertices[(i + 1) % vertices.size()]});
  }
  bounding_radius.push_back(obstacle.radius() + reach);
  outline_end_.push_back(static_cast<std::uint32_t>(outline_edges_.size()));
  largest_coordinates_ = std::max(largest_coordinates_, m.position.lpNorm<1>());
  largest_speed_ = std::max(largest_speed_, m.velocity.lpNorm<1>());
  largest_acceleration_ = std::max(largest_acceleration_, m.acceleration.lpNorm<1>());
  grows_ = grows_ || obstacle.disc().radius_rate > 0;
}

Disc ObstacleBatch::disc(std::size_t i) const {
  return {{{x[i], y[i]}, {vx[i], vy[i]}, {ax[i], ay[i]}}, radius[i], radius_rate[i]};
}

Outline ObstacleBatch::outline(std::size_t i) const {
  const std::size_t begin = i == 0 ? 0 : outline_end_[i - 1];
  return {outline_edges_.data() + begin, outline_end_[i] - begin};
}

}  // namespace footprint_collision_predictor::core
