#include "scene.hpp"

#include <cmath>

#include "random.hpp"

namespace footprint_collision_predictor::bench {
namespace {

using test::Random;

const Twist kTwist{{0.8, 0.1}, 0};
constexpr double kAimed = 0.045;  // the other hits come about by chance

Obstacle anyObstacle(MotionKind kind, Random& random) {
  const Vec2 position = random.uniform(0.8, 10) * random.direction();
  const double radius = random.uniform(0.1, 0.6);
  Vec2 acceleration{0, 0};
  if (kind == MotionKind::kAccelerating) acceleration = random.uniform(0, 1) * random.direction();
  Vec2 velocity = random.uniform(0, 2) * random.direction();
  if (random.chance(kAimed)) {
    const double time = random.uniform(0.5, kHorizon);
    const Vec2 target = random.uniform(0, 0.3) * random.direction();
    velocity = (target - position) / time - (0.5 * time) * acceleration + kTwist.linear;
  }
  return Obstacle({position, velocity, acceleration}, radius);
}

std::vector<Obstacle> anyObstacles(MotionKind kind, std::size_t count) {
  std::vector<Obstacle> obstacles;
  obstacles.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    Random random(kSeed, i);
    obstacles.push_back(anyObstacle(kind, random));
  }
  return obstacles;
}

Polygon convexFootprint(int edges) {
  Random random(kSeed);
  std::vector<Vec2> vertices;
  for (int i = 0; i < edges; ++i) {
    const double angle = 2 * M_PI * (i + random.uniform(0, 0.5)) / edges;
    vertices.push_back({0.5 * std::cos(angle), 0.35 * std::sin(angle)});
  }
  return Polygon(vertices);
}

Polygon rectangle(const Vec2& low, const Vec2& high) {
  return Polygon({low, {high.x(), low.y()}, high, {low.x(), high.y()}});
}

}  // namespace

std::string nameOf(MotionKind kind) {
  return kind == MotionKind::kStraight ? "straight" : "accelerating";
}

std::vector<Segment> segmentsOf(const Polygon& footprint) {
  std::vector<Segment> segments;
  for (std::size_t i = 0; i < footprint.size(); ++i) segments.push_back(footprint.segment(i));
  return segments;
}

Scene convexScene(int edges, MotionKind kind, std::size_t obstacles) {
  const Polygon footprint = convexFootprint(edges);
  return {std::to_string(edges), kind,   footprint,
          {footprint},           kTwist, anyObstacles(kind, obstacles)};
}

Scene concaveScene(MotionKind kind, std::size_t obstacles) {
  const Polygon footprint({{0.5, 0.35},
                           {-0.5, 0.35},
                           {-0.5, -0.35},
                           {0.5, -0.35},
                           {0.5, -0.2},
                           {-0.1, -0.2},
                           {-0.1, 0.2},
                           {0.5, 0.2}});
  const std::vector<Polygon> parts = {rectangle({-0.5, -0.35}, {-0.1, 0.35}),
                                      rectangle({-0.1, -0.35}, {0.5, -0.2}),
                                      rectangle({-0.1, 0.2}, {0.5, 0.35})};
  return {"concave", kind, footprint, parts, kTwist, anyObstacles(kind, obstacles)};
}

}  // namespace footprint_collision_predictor::bench
