#include "scene.hpp"

#include <algorithm>
#include <cmath>

#include "footprint_oracle.hpp"

namespace footprint_collision_predictor::test {

FootprintCase Scene::with(std::size_t obstacle) const {
  const core::Obstacle& o = obstacles[obstacle];
  return {footprint, twist, o.disc(), o.outline(), horizon};
}

Scene anyScene(Random& random, int most) {
  Moves moves{random.chance(0.5), random.chance(0.5), random.chance(0.5)};
  const FootprintCase robot = anyFootprintCase(random, moves);
  Scene scene{robot.footprint, robot.twist, {}, robot.horizon};
  const double outlines = random.chance(0.3) ? 0 : random.uniform(0, 1);
  const double aimed = random.chance(0.5) ? random.uniform(0, 1) : random.logUniform(1e-3, 0.1);
  const auto count = static_cast<std::size_t>(random.logUniform(1, most + 1));
  while (scene.obstacles.size() < count) {
    if (!scene.obstacles.empty() && random.chance(0.05)) {
      const int last = static_cast<int>(scene.obstacles.size()) - 1;
      const core::Obstacle same =
          scene.obstacles[static_cast<std::size_t>(random.integer(0, last))];
      scene.obstacles.push_back(same);
      continue;
    }
    moves.has_outline = random.chance(outlines);
    FootprintCase c = anyFootprintCase(random, moves);
    if (!random.chance(aimed))
      c.disc.motion.position += random.logUniform(10, 1e4) * random.direction();
    scene.obstacles.push_back(obstacleOf(c));
  }
  return scene;
}

core::Obstacle anyOutOfReach(const Scene& scene, Random& random) {
  const Vec2 away = random.direction();
  const double travelled = scene.twist.linear.norm() * scene.horizon;
  const double speed = random.uniform(0, 5);
  const double growth = random.chance(0.5) ? 0 : random.uniform(0, speed);
  const double distance = 100 + travelled + random.logUniform(1, 1e5);
  return {
      {distance * away, speed * away, random.uniform(0, 3) * away}, random.uniform(0, 5), growth};
}

bool areBothRight(const Scene& scene, std::size_t obstacle, double earlier, double later,
                  std::optional<std::size_t> segment) {
  if (later - earlier <= 1e-9 * std::max(1.0, earlier)) return true;
  const FootprintCase c = scene.with(obstacle);
  const FootprintOracle oracle(c);
  const Real gap = segment ? oracle.gapOfSegment(*segment, earlier) : oracle.gap(earlier);
  const double size = std::max(1.0, sizeOfCoordinates(c, earlier));
  if (gap > (scene.twist.angular == 0 ? 1e-9 : 1e-6) * size) return false;
  const FirstTouch touch = segment ? oracle.firstTouchOfSegment(*segment) : oracle.firstTouch();
  return !touch.contact_at ||
         later <= *touch.contact_at + 1e-9L * std::max(1.0L, *touch.contact_at);
}

std::string asCode(const Scene& scene) {
  std::string text;
  for (std::size_t i = 0; i < scene.obstacles.size(); ++i) text += asCode(scene.with(i)) + "\n";
  return text;
}

}  // namespace footprint_collision_predictor::test
