// What must hold between two questions about footprints, in every motion, whatever the answers are.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "footprint_oracle.hpp"
#include "guarantee.hpp"
#include "scene.hpp"

namespace footprint_collision_predictor::test {
namespace {

using core::Obstacle;
using core::Polygon;
using core::Prediction;

constexpr SuiteSize kScenes{2000, 400000};

Prediction predicted(const Scene& scene) {
  return predict(Polygon(scene.footprint), scene.twist, scene.obstacles, scene.horizon);
}

template <typename SomeContact>
double timeOf(const std::optional<SomeContact>& contact) {
  return contact ? contact->contact.time : HUGE_VAL;
}

/// Within the guarantee, both say the same of when and whether there is a contact.
template <typename A, typename B>
bool agree(const Scene& scene, const std::optional<A>& a, const std::optional<B>& b,
           std::optional<std::size_t> segment = {}) {
  if (!a && !b) return true;
  const std::size_t first = timeOf(a) < timeOf(b) ? a.value().obstacle : b.value().obstacle;
  return areBothRight(scene, first, std::min(timeOf(a), timeOf(b)), std::max(timeOf(a), timeOf(b)),
                      segment);
}

/// The other scene's segment i is this one's segment numbers(i).
template <typename Numbers>
std::string disagreement(const Scene& scene, const Scene& other, const Numbers& numbers) {
  const Prediction a = predicted(scene);
  const Prediction b = predicted(other);
  if (!agree(scene, a.first, b.first)) return "first contact\n" + asCode(scene);
  if (std::abs(*a.clearance - *b.clearance) > 1e-9) return "clearance\n" + asCode(scene);
  if (std::abs(a.closest->distance - b.closest->distance) > 2e-6)
    return "closest\n" + asCode(scene);
  for (std::size_t i = 0; i < scene.footprint.size(); ++i)
    if (!agree(scene, a.segments.at(numbers(i)), b.segments.at(i), numbers(i)))
      return "segment " + std::to_string(numbers(i)) + "\n" + asCode(scene);
  return "";
}

std::string disagreement(const Scene& scene, const Scene& other) {
  return disagreement(scene, other, [](std::size_t i) { return i; });
}

/// Everything as linear maps of points and of directions have it; the twist is changed already.
template <typename PointMap, typename Map>
Scene mapped(const Scene& scene, const core::Twist& twist, const PointMap& point, const Map& map) {
  Scene other{{}, twist, {}, scene.horizon};
  for (const Vec2& v : scene.footprint) other.footprint.push_back(point(v));
  for (const Obstacle& o : scene.obstacles) {
    std::vector<Vec2> outline;
    for (const Vec2& v : o.outline()) outline.push_back(map(v));
    const core::Motion& m = o.motion();
    other.obstacles.push_back({{point(m.position), map(m.velocity), map(m.acceleration)},
                               o.radius(),
                               o.disc().radius_rate,
                               outline});
  }
  return other;
}

TEST(FootprintLaw, TheFirstContactIsThatOfTheFirstSegment) {
  forEachCase("footprint = min of segments", kScenes, [](Random& random) -> std::string {
    const Scene scene = anyScene(random, 6);
    const Prediction p = predicted(scene);
    const auto first = firstContact(Polygon(scene.footprint), scene.twist,
                                    core::ObstacleBatch(scene.obstacles), scene.horizon);
    std::optional<core::SegmentContact> earliest;
    for (const auto& segment : p.segments)
      if (timeOf(segment) < timeOf(earliest)) earliest = segment;
    for (std::size_t i = 0; i < scene.obstacles.size(); ++i)
      if (FootprintOracle(scene.with(i)).isWithinNow())
        earliest = core::SegmentContact{{0, core::Feature::kInside, {0, 0}}, i};
    for (const auto& answer : {first, p.first})
      if (answer.has_value() != earliest.has_value() || !agree(scene, answer, earliest))
        return "first contact\n" + asCode(scene);
    return "";
  });
}

TEST(FootprintLaw, TheWindingChangesOnlyTheNumbers) {
  forEachCase("reversed winding", kScenes, [](Random& random) {
    const Scene scene = anyScene(random, 6);
    Scene reversed = scene;
    std::reverse(reversed.footprint.begin(), reversed.footprint.end());
    const std::size_t n = scene.footprint.size();
    return disagreement(scene, reversed, [n](std::size_t i) { return (2 * n - 2 - i) % n; });
  });
}

TEST(FootprintLaw, TheFrameOfTheBodyChangesNothing) {
  forEachCase("another frame", kScenes, [](Random& random) {
    Scene scene;
    const Scene other = withFootprint([&] {
      scene = anyScene(random, 6);
      const Vec2 origin = random.uniform(0, 10) * random.direction();
      const Eigen::Rotation2Dd turn(random.angle());
      const core::Twist moved = atPoint(origin, scene.twist);
      return mapped(
          scene, {turn * moved.linear, moved.angular},
          [&](const Vec2& p) -> Vec2 { return turn * Vec2(p - origin); },
          [&](const Vec2& v) -> Vec2 { return turn * v; });
    });
    return disagreement(scene, other);
  });
}

TEST(FootprintLaw, AMirrorChangesNothing) {
  forEachCase("mirror", kScenes, [](Random& random) {
    const Scene scene = anyScene(random, 6);
    const auto mirror = [](const Vec2& v) { return Vec2(v.x(), -v.y()); };
    const core::Twist twist{mirror(scene.twist.linear), -scene.twist.angular};
    return disagreement(scene, mapped(scene, twist, mirror, mirror));
  });
}

TEST(FootprintLaw, WhoSharesAMotionSeesNothingOfIt) {
  forEachCase("shared velocity", kScenes, [](Random& random) -> std::string {
    Scene scene = anyScene(random, 6);
    scene.twist.angular = 0;
    Scene other = scene;
    const Vec2 shared = random.uniform(0, 5) * random.direction();
    other.twist.linear += shared;
    for (Obstacle& o : other.obstacles) {
      core::Motion m = o.motion();
      m.velocity += shared;
      o = Obstacle(m, o.radius(), o.disc().radius_rate, o.outline());
    }
    return disagreement(scene, other);
  });
}

TEST(FootprintLaw, LaterTheContactIsAsMuchNearer) {
  forEachCase("carried on", kScenes, [](Random& random) -> std::string {
    const Scene scene = anyScene(random, 6);
    const auto first = predicted(scene).first;
    const double dt = random.uniform(0, 1) * (first ? first->contact.time : scene.horizon);
    Scene later = scene;
    later.horizon -= dt;
    for (Obstacle& o : later.obstacles) o = o.after(dt, scene.twist);
    auto then = predicted(later).first;
    if (then) then->contact.time += dt;
    return agree(scene, first, then) ? "" : "later by " + std::to_string(dt) + "\n" + asCode(scene);
  });
}

TEST(FootprintLaw, LargerObstaclesAreNeverLater) {
  forEachCase("larger radius", kScenes, [](Random& random) -> std::string {
    const Scene scene = anyScene(random, 6);
    Scene larger = scene;
    for (Obstacle& o : larger.obstacles)
      o = Obstacle(o.motion(), o.radius() + random.logUniform(1e-12, 1), o.disc().radius_rate,
                   o.outline());
    const Prediction a = predicted(scene);
    const Prediction b = predicted(larger);
    if (timeOf(b.first) > timeOf(a.first) &&
        !areBothRight(larger, a.first->obstacle, timeOf(a.first), timeOf(b.first)))
      return "first contact\n" + asCode(scene);
    return *b.clearance <= *a.clearance + 1e-12 && b.closest->distance <= a.closest->distance + 2e-6
               ? ""
               : "gap\n" + asCode(scene);
  });
}

TEST(FootprintLaw, ALongerHorizonKeepsEarlierHits) {
  forEachCase("longer horizon", kScenes, [](Random& random) -> std::string {
    const Scene scene = anyScene(random, 6);
    Scene longer = scene;
    longer.horizon *= random.logUniform(1, 10);
    const auto first = predicted(scene).first;
    auto with_longer = predicted(longer).first;
    if (with_longer && with_longer->contact.time > scene.horizon) with_longer = std::nullopt;
    return agree(scene, first, with_longer) ? "" : asCode(scene);
  });
}

}  // namespace
}  // namespace footprint_collision_predictor::test
