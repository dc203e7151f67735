// No obstacle that touches is thrown away: the farthest vertex of the footprint, where the circles
// of the broad phase are tight, is touched by a hair, at any scale and beside anything.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "guarantee.hpp"
#include "scene.hpp"

namespace footprint_collision_predictor::test {
namespace {

constexpr double kFarthest = 4e7;  // [m] leaves room for the scene about it
constexpr double kFastest = 3e5;   // [m/s] of one part of a velocity, likewise

/// A regular polygon, and when a vertex of it has certainly been touched.
struct Graze {
  Scene scene;
  Vec2 centre;      ///< [m] of the polygon
  core::Twist own;  ///< of the centre
  double size;      ///< [m] from the centre to a vertex
  std::size_t vertex;
  double time;  ///< [s]
};

std::vector<Vec2> regularPolygon(const Vec2& centre, double radius, int sides) {
  std::vector<Vec2> vertices;
  for (int i = 0; i < sides; ++i) {
    const double angle = 2 * M_PI * i / sides;
    vertices.push_back(centre + radius * Vec2(std::cos(angle), std::sin(angle)));
  }
  return vertices;
}

/// Where something comes in a time that moves with a twist: along a line or an arc.
Vec2 wayOf(const core::Twist& twist, double time) {
  const auto& [u, w] = twist;
  if (w == 0) return time * u;
  const double half_sine = std::sin(w * time / 2);
  return std::sin(w * time) / w * u + 2 * half_sine * half_sine / w * core::leftNormal(u);
}

Graze anyMove(Random& random) {
  Graze graze;
  graze.size = random.chance(0.1) ? random.logUniform(1e-24, 1e-6) : random.logUniform(1e-6, 1e3);
  const double horizon = random.logUniform(0.1, 1000);
  graze.centre = {0, 0};
  if (random.chance(0.7))
    graze.centre = std::min(graze.size * random.logUniform(1, 1e9), kFarthest) * random.direction();
  graze.own = {};
  if (random.chance(0.7))
    graze.own.linear = std::min(graze.size / horizon * random.logUniform(1e-3, 1e3), kFastest) *
                       random.direction();
  if (random.chance(0.5)) graze.own.angular = random.sign() * random.logUniform(1e-6, 10) / horizon;
  graze.scene = {regularPolygon(graze.centre, graze.size, random.integer(3, 12)),
                 atPoint(-graze.centre, graze.own),
                 {},
                 horizon};
  const int last = static_cast<int>(graze.scene.footprint.size()) - 1;
  graze.vertex = static_cast<std::size_t>(random.integer(0, last));
  graze.time = horizon * random.uniform(0.1, 1);
  return graze;
}

/// So far away, or so fast, that single precision has few digits left for the others; it leaves.
core::Obstacle anyOther(const Graze& graze, Random& random) {
  const Vec2 away = random.direction();
  const double farther = std::min(graze.size * random.logUniform(1e2, 1e12), kFarthest);
  const double speed =
      random.chance(0.5) ? 0 : std::min(graze.size * random.logUniform(1, 1e9), kFastest);
  return {{graze.centre + farther * away, graze.own.linear + speed * away, {0, 0}},
          0.1 * graze.size};
}

/// What passes the vertex, farthest in at the time and there by a hair within reach.
core::Obstacle anyGrazing(const Graze& graze, Random& random) {
  const double t = graze.time, size = graze.size;
  const Eigen::Rotation2Dd turn(graze.own.angular * t);
  const Vec2 vertex = graze.scene.footprint[graze.vertex] - graze.centre;
  const Vec2 out = turn * vertex.normalized();
  const double reach = size * random.logUniform(1e-3, 10);
  const double rate = random.chance(0.5) ? 0 : random.uniform(0, 0.9 * reach / t);
  const double fastest = std::min(kFastest, kFarthest / t);
  const double speed = random.sign() * std::min(size / t * random.logUniform(1e-2, 1e6), fastest);
  double bend = 0;
  if (random.chance(0.5))
    bend = std::min(size / (t * t) * random.logUniform(1e-6, 1), kFastest / std::max(t, 1.0));
  const Vec2 v = turn * graze.own.linear + speed * core::leftNormal(out), a = bend * out;
  const double path = t * v.norm() + t * graze.own.linear.norm() + bend * t * t;
  const double rounding =
      1e-13 *
      ((1 + std::abs(graze.own.angular) * t) * graze.centre.lpNorm<1>() + path + reach + 2 * size);
  const double hair = rounding + size * random.logUniform(1e-12, 1e-3);
  const Vec2 nearest = graze.centre + wayOf(graze.own, t) + turn * vertex + (reach - hair) * out;
  return {{nearest - t * v + 0.5 * t * t * a, v - t * a, a}, reach - rate * t, rate};
}

Graze anyGraze(Random& random) {
  Graze graze = anyMove(random);
  std::vector<core::Obstacle>& obstacles = graze.scene.obstacles;
  while (random.chance(0.7)) obstacles.push_back(anyOther(graze, random));
  obstacles.push_back(anyGrazing(graze, random));
  while (random.chance(0.5)) obstacles.push_back(anyOther(graze, random));
  return graze;
}

TEST(BroadPhase, KeepsWhatTouchesByAHair) {
  forEachCase("touched by a hair", kMain, [](Random& random) -> std::string {
    const Graze graze = anyGraze(random);
    const Scene& scene = graze.scene;
    const core::Polygon footprint(scene.footprint);
    const core::ObstacleBatch batch(scene.obstacles);
    const double latest = graze.time + 1e-9 * std::max(1.0, graze.time);
    const auto isInTime = [&](const std::optional<core::FootprintContact>& contact) {
      return contact && contact->contact.time <= latest;
    };
    const auto isMetAlone = [&](const core::Obstacle& obstacle) {
      return isInTime(firstContact(footprint, scene.twist, obstacle, scene.horizon));
    };
    if (std::none_of(scene.obstacles.begin(), scene.obstacles.end(), isMetAlone))
      return "alone\n" + asCode(scene);
    if (!isInTime(firstContact(footprint, scene.twist, batch, scene.horizon)))
      return "footprint\n" + asCode(scene);
    std::vector<std::optional<core::SegmentContact>> segments;
    firstContacts(footprint, scene.twist, batch, scene.horizon, &segments);
    const auto& touched = segments[graze.vertex];
    if (!touched || touched->contact.time > latest) return "segment\n" + asCode(scene);
    return "";
  });
}

}  // namespace
}  // namespace footprint_collision_predictor::test
