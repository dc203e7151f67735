// What a tracker in a busy hall sends.
#pragma once

#include <footprint_collision_predictor/ObstacleArray.h>

#include <cmath>
#include <cstddef>

#include "random_numbers.hpp"

namespace footprint_collision_predictor::bench {

/// So many people in frame base_link, 3 to 30 m off, who walk anywhere; the same at every call.
inline ObstacleArray crowd(std::size_t count) {
  tools::RandomNumbers random(1);
  ObstacleArray message;
  message.header.frame_id = "base_link";
  for (std::size_t i = 0; i < count; ++i) {
    const double direction = random.uniform(-M_PI, M_PI), distance = random.uniform(3, 30);
    Obstacle obstacle;
    obstacle.id = static_cast<std::int64_t>(i);
    obstacle.position.x = distance * std::cos(direction);
    obstacle.position.y = distance * std::sin(direction);
    obstacle.velocity.x = random.uniform(-1.5, 1.5);
    obstacle.velocity.y = random.uniform(-1.5, 1.5);
    obstacle.radius = 0.3;
    message.obstacles.push_back(obstacle);
  }
  return message;
}

}  // namespace footprint_collision_predictor::bench
