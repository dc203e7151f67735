// A footprint is the first of its segments, in either winding.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "footprint_collision_predictor/predictor.hpp"
#include "generators.hpp"
#include "guarantee.hpp"

namespace footprint_collision_predictor::test {
namespace {

using core::FootprintContact;
using core::Obstacle;
using core::Polygon;
using core::Prediction;
using core::Twist;

/// Any number of corners around the origin, convex or not, counter-clockwise.
std::vector<Vec2> anyFootprint(Random& random) {
  const int corners = random.integer(3, 8);
  std::vector<Vec2> vertices;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * M_PI * (i + random.uniform(0, 0.5)) / corners;
    vertices.push_back(random.uniform(0.2, 2) * Vec2{std::cos(angle), std::sin(angle)});
  }
  return vertices;
}

Obstacle anyObstacle(Random& random) {
  const Vec2 position = random.logUniform(0.1, 20) * random.direction();
  const Vec2 velocity = random.uniform(0, 5) * random.direction() - random.uniform(0, 1) * position;
  return {{position, velocity, anyVector(random, 1e-6, 2)}, random.logUniform(1e-2, 2)};
}

std::string described(const std::vector<Vec2>& vertices, const std::vector<Obstacle>& obstacles) {
  std::string text;
  for (std::size_t i = 0; i < vertices.size(); ++i)
    for (const Obstacle& o : obstacles)
      text +=
          asCode({{vertices[i], vertices[(i + 1) % vertices.size()]}, o.motion(), o.radius(), 5}) +
          "\n";
  return text;
}

bool close(double a, double b) { return std::abs(a - b) <= 1e-9; }

TEST(FootprintLaw, TheFirstContactIsThatOfTheFirstSegment) {
  forEachCase("footprint = min of segments", kLaw, [](Random& random) -> std::string {
    const std::vector<Vec2> vertices = anyFootprint(random);
    const Polygon footprint(vertices);
    std::vector<Obstacle> obstacles;
    for (int i = random.integer(1, 6); i > 0; --i) obstacles.push_back(anyObstacle(random));
    const Prediction p = predict(footprint, {}, obstacles, 5);

    bool inside = false;
    for (const Obstacle& o : obstacles) inside |= footprint.contains(o.motion().position);
    double earliest = HUGE_VAL;
    for (std::size_t i = 0; i < footprint.size(); ++i) {
      double segment = HUGE_VAL;
      for (const Obstacle& o : obstacles) {
        const auto contact = timeToCollision(footprint.segment(i), o.motion(), o.radius(), 5);
        if (contact) segment = std::min(segment, contact->time);
      }
      const auto& got = p.segments.at(i);
      if (got ? !close(got->contact.time, segment) : segment <= 5)
        return "segment " + std::to_string(i) + "\n" + described(vertices, obstacles);
      earliest = std::min(earliest, segment);
    }
    double clearance = HUGE_VAL;
    for (const Obstacle& o : obstacles) {
      double gap = HUGE_VAL;
      for (std::size_t i = 0; i < footprint.size(); ++i)
        gap = std::min(gap, distance(footprint.segment(i), o.motion().position));
      if (footprint.contains(o.motion().position)) gap = -gap;
      clearance = std::min(clearance, gap - o.radius());
    }
    if (!close(*p.clearance, clearance)) return "clearance\n" + described(vertices, obstacles);
    if (inside) earliest = 0;
    const bool right = p.first ? close(p.first->contact.time, earliest) : earliest > 5;
    return right ? "" : "first contact\n" + described(vertices, obstacles);
  });
}

TEST(FootprintLaw, TheWindingChangesOnlyTheNumbers) {
  forEachCase("reversed winding", kLaw, [](Random& random) -> std::string {
    const std::vector<Vec2> vertices = anyFootprint(random);
    const std::vector<Vec2> reversed(vertices.rbegin(), vertices.rend());
    const std::vector<Obstacle> obstacles{anyObstacle(random), anyObstacle(random)};
    const Twist twist{random.uniform(0, 2) * random.direction(), 0};
    const Prediction a = predict(Polygon(vertices), twist, obstacles, 5);
    const Prediction b = predict(Polygon(reversed), twist, obstacles, 5);

    const std::size_t n = vertices.size();
    bool same = a.first.has_value() == b.first.has_value() && close(*a.clearance, *b.clearance);
    if (same && a.first) same = close(a.first->contact.time, b.first->contact.time);
    for (std::size_t i = 0; i < n; ++i) {  // segment i of one is segment n - 2 - i of the other
      const auto& one = a.segments.at(i);
      const auto& other = b.segments.at((2 * n - 2 - i) % n);
      same = same && one.has_value() == other.has_value();
      if (same && one) same = close(one->contact.time, other->contact.time);
    }
    return same ? "" : described(vertices, obstacles);
  });
}

}  // namespace
}  // namespace footprint_collision_predictor::test
