#include "scene.hpp"

#include <cmath>
#include <utility>

#include "footprint_collision_predictor/predictor.hpp"
#include "random.hpp"

namespace footprint_collision_predictor::bench {
namespace {

using test::Random;

constexpr double kAimed = 0.045;  // the other hits come about by chance

Twist twistOf(Kind kind) { return {{0.8, 0.1}, kind == Kind::kTurning ? 0.5 : 0}; }

Vec2 velocityOf(const Vec2& position, const Vec2& acceleration, const Twist& twist,
                Random& random) {
  const Vec2 any = random.uniform(0, 2) * random.direction();
  if (!random.chance(kAimed)) return any;
  const double time = random.uniform(0.5, kHorizon);
  const Vec2 target = poseAt(twist, time).position + random.uniform(0, 0.3) * random.direction();
  return (target - position) / time - (0.5 * time) * acceleration;
}

Obstacle anyDisc(Kind kind, Random& random) {
  const Vec2 position = random.uniform(0.8, 10) * random.direction();
  const double radius = random.uniform(0.1, 0.6);
  Vec2 acceleration{0, 0};
  if (kind == Kind::kAccelerating) acceleration = random.uniform(0, 1) * random.direction();
  const double radius_rate = kind == Kind::kGrowing ? random.uniform(0, 0.1) : 0;
  const Vec2 velocity = velocityOf(position, acceleration, twistOf(kind), random);
  return {{position, velocity, acceleration}, radius, radius_rate};
}

Obstacle anyWall(Random& random) {
  const Vec2 position = random.uniform(0.8, 10) * random.direction();
  const Vec2 half = random.uniform(0.25, 1.5) * random.direction();
  return {{position, {0, 0}, {0, 0}}, random.uniform(0.01, 0.05), 0, {-half, half}};
}

Obstacle anyObstacle(Kind kind, Random& random) {
  return kind == Kind::kWalls ? anyWall(random) : anyDisc(kind, random);
}

std::vector<Obstacle> anyObstacles(const Polygon& footprint, Kind kind, Contacts contacts,
                                   std::size_t count) {
  std::vector<Obstacle> obstacles;
  obstacles.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    Random random(kSeed, i);
    Obstacle obstacle = anyObstacle(kind, random);
    // Whether this threw away the right ones is seen when the answers are judged.
    while (contacts == Contacts::kLate &&
           core::firstContact(footprint, twistOf(kind), obstacle, kLate))
      obstacle = anyObstacle(kind, random);
    obstacles.push_back(std::move(obstacle));
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

std::string nameOf(Kind kind) {
  switch (kind) {
    case Kind::kStraight:
      return "straight";
    case Kind::kAccelerating:
      return "accelerating";
    case Kind::kTurning:
      return "turning";
    case Kind::kGrowing:
      return "growing";
    default:
      return "walls";
  }
}

std::string nameOf(Contacts contacts) { return contacts == Contacts::kMixed ? "mixed" : "late"; }

std::string Scene::name() const {
  return nameOf(contacts) + "/" + nameOf(kind) + "/" + footprint_name;
}

Disc Scene::seen(std::size_t i) const {
  Disc disc = obstacles[i].disc();
  if (twist.angular == 0) disc.motion = core::relativeMotion(disc.motion, twist);
  return disc;
}

std::vector<Segment> segmentsOf(const Polygon& footprint) {
  std::vector<Segment> segments;
  for (std::size_t i = 0; i < footprint.size(); ++i) segments.push_back(footprint.segment(i));
  return segments;
}

Scene convexScene(int edges, Kind kind, Contacts contacts, std::size_t obstacles) {
  const Polygon footprint = convexFootprint(edges);
  return {std::to_string(edges),
          kind,
          contacts,
          footprint,
          {footprint},
          twistOf(kind),
          anyObstacles(footprint, kind, contacts, obstacles)};
}

Scene concaveScene(Kind kind, Contacts contacts, std::size_t obstacles) {
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
  return {"concave",
          kind,
          contacts,
          footprint,
          parts,
          twistOf(kind),
          anyObstacles(footprint, kind, contacts, obstacles)};
}

Pose poseAt(const Twist& twist, double t) {
  const auto& [u, w] = twist;
  if (w == 0) return {t * u, 1, 0};
  const double cosine = std::cos(w * t), sine = std::sin(w * t);
  return {(sine / w) * u + ((1 - cosine) / w) * core::leftNormal(u), cosine, sine};
}

}  // namespace footprint_collision_predictor::bench
