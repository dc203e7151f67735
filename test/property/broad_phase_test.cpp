// No obstacle that touches is thrown away: the farthest vertex of the footprint, where the circles
// of the broad phase are tight, is touched by a hair, at any scale and beside anything.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "guarantee.hpp"
#include "scene.hpp"

namespace footprint_collision_predictor::test {
namespace {

constexpr double kFarthest = 5e7;  // [m] leaves room for the scene about it
constexpr double kFastest = 3e5;   // [m/s] of one part of a velocity, likewise

/// A regular polygon, and when a vertex of it has certainly been touched, by whom.
struct Graze {
  Scene scene;
  std::size_t vertex;
  double time;
};

std::vector<Vec2> regularPolygon(const Vec2& centre, double radius, int sides) {
  std::vector<Vec2> vertices;
  for (int i = 0; i < sides; ++i) {
    const double angle = 2 * M_PI * i / sides;
    vertices.push_back(centre + radius * Vec2(std::cos(angle), std::sin(angle)));
  }
  return vertices;
}

/// So far away, or so fast, that single precision has few digits left for the others; it leaves.
core::Obstacle anyOther(const Graze& graze, double size, Random& random) {
  const Vec2 away = random.direction();
  const double farther = std::min(size * random.logUniform(1e2, 1e12), kFarthest);
  const double speed =
      random.chance(0.5) ? 0 : std::min(size * random.logUniform(1, 1e9), kFastest);
  const Vec2 velocity = graze.scene.twist.linear + speed * away;
  return {{graze.scene.footprint[0] + farther * away, velocity, {0, 0}}, 0.1 * size};
}

/// What passes a vertex, farthest in at a time and there by a hair within reach.
core::Obstacle anyGrazing(const Graze& graze, const Vec2& centre, double size, Random& random) {
  const Vec2& vertex = graze.scene.footprint[graze.vertex];
  const double t = graze.time;
  const Vec2 out = (vertex - centre).normalized();
  const double reach = size * random.logUniform(1e-3, 10);
  const double rate = random.chance(0.5) ? 0 : random.uniform(0, 0.9 * reach / t);
  const double speed = random.sign() * std::min(size / t * random.logUniform(1e-2, 1e2), kFastest);
  const double bend = random.chance(0.5) ? 0
                                         : std::min(size / (t * t) * random.logUniform(1e-6, 1),
                                                    kFastest / std::max(t, 1.0));
  const Vec2 v = speed * core::leftNormal(out), a = bend * out;
  const double path = std::abs(speed) * t + 0.5 * bend * t * t;
  const double rounding = 1e-13 * (centre.lpNorm<1>() + t * graze.scene.twist.linear.lpNorm<1>() +
                                   path + reach + 2 * size);
  const double hair = rounding + size * random.logUniform(1e-12, 1e-3);
  const Vec2 nearest = vertex + (reach - hair) * out;
  return {{nearest - t * v + 0.5 * t * t * a, v - t * a + graze.scene.twist.linear, a},
          reach - rate * t,
          rate};
}

Graze anyGraze(Random& random) {
  const double size =
      random.chance(0.1) ? random.logUniform(1e-24, 1e-6) : random.logUniform(1e-6, 1e3);
  const double horizon = random.logUniform(0.1, 1000);
  const Vec2 centre =
      random.chance(0.3)
          ? Vec2(0, 0)
          : Vec2(std::min(size * random.logUniform(1, 1e9), kFarthest) * random.direction());
  Graze graze;
  const double speed =
      random.chance(0.3) ? 0 : std::min(size / horizon * random.logUniform(1e-3, 1e3), kFastest);
  graze.scene = {regularPolygon(centre, size, random.integer(3, 12)),
                 {speed * random.direction(), 0},
                 {},
                 horizon};
  graze.vertex = static_cast<std::size_t>(
      random.integer(0, static_cast<int>(graze.scene.footprint.size()) - 1));
  graze.time = horizon * random.uniform(0.1, 1);
  while (random.chance(0.7)) graze.scene.obstacles.push_back(anyOther(graze, size, random));
  graze.scene.obstacles.push_back(anyGrazing(graze, centre, size, random));
  while (random.chance(0.5)) graze.scene.obstacles.push_back(anyOther(graze, size, random));
  return graze;
}

TEST(BroadPhase, KeepsWhatTouchesByAHair) {
  forEachCase("touched by a hair", kMain, [](Random& random) -> std::string {
    const Graze graze = anyGraze(random);
    const Scene& scene = graze.scene;
    const core::Polygon footprint(scene.footprint);
    const core::ObstacleBatch batch(scene.obstacles);
    const double latest = graze.time + 1e-9 * std::max(1.0, graze.time);
    const auto first = firstContact(footprint, scene.twist, batch, scene.horizon);
    if (!first || first->contact.time > latest) return "footprint\n" + asCode(scene);
    std::vector<std::optional<core::SegmentContact>> segments;
    firstContacts(footprint, scene.twist, batch, scene.horizon, &segments);
    const auto& touched = segments[graze.vertex];
    if (!touched || touched->contact.time > latest) return "segment\n" + asCode(scene);
    return "";
  });
}

}  // namespace
}  // namespace footprint_collision_predictor::test
