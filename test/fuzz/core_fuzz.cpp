// libFuzzer's door to the core: one question to timeToCollision, or a footprint among obstacles.
// A wrong answer is printed as code for a regression test, and ends the program.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "bytes.hpp"
#include "footprint_collision_predictor/predictor.hpp"
#include "sampling.hpp"

namespace footprint_collision_predictor::test {
namespace {

using core::Obstacle;
using core::Polygon;
using core::Prediction;

constexpr double kMaxYawRate = 16;  // [rad/s]
constexpr double kMostTurned =
    200;  // [rad] within the horizon; each turn costs the same time again

[[noreturn]] void fail(const std::string& wrong, const std::string& code) {
  std::fprintf(stderr, "WRONG ANSWER: %s\n%s\n", wrong.c_str(), code.c_str());
  std::abort();
}

void expectNothing(const std::string& wrong, const Case& c) {
  if (!wrong.empty()) fail(wrong, asCode(c));
}

Disc discFrom(Bytes& bytes) {
  const Vec2 position = bytes.vector(core::kMaxCoordinate);
  const Vec2 velocity = bytes.vector(core::kMaxRate);
  const Vec2 acceleration = bytes.vector(core::kMaxRate);
  const double radius = bytes.notNegative(core::kMaxRadius);
  return {{position, velocity, acceleration}, radius, bytes.notNegative(core::kMaxRate)};
}

Twist twistFrom(Bytes& bytes) {
  const Vec2 linear = bytes.vector(core::kMaxRate);
  return {linear, bytes.number(kMaxYawRate)};
}

double horizonFrom(Bytes& bytes, const Twist& twist) {
  const double horizon = bytes.notNegative(core::kMaxHorizon);
  const double w = std::abs(twist.angular);
  return w * horizon <= kMostTurned ? horizon : kMostTurned / w;
}

void fuzzSegment(Bytes& bytes) {
  const Vec2 start = bytes.vector(core::kMaxCoordinate);
  const Vec2 end = start + bytes.vector(core::kMaxFootprintExtent);
  const Disc disc = discFrom(bytes);
  const Twist twist = twistFrom(bytes);
  const double horizon = horizonFrom(bytes, twist);
  const Case c{{start, end}, disc.motion, disc.radius, horizon, disc.radius_rate, twist};
  expectNothing(wrongBySampling(c, ask(c)), c);
}

/// A footprint among obstacles, and what was said of it.
struct Scene {
  Polygon footprint;
  Twist twist;
  std::vector<Obstacle> obstacles;
  double horizon;
  Prediction prediction;

  Case of(std::size_t segment, const Obstacle& o, const Vec2& vertex = {0, 0}) const {
    Motion motion = o.motion();
    motion.position += vertex;
    return {footprint.segment(segment), motion, o.radius(), horizon, o.disc().radius_rate, twist};
  }
};

/// Whatever a part touches is touched by the whole: no vertex of an outline, which is a disc that
/// moves along, may overlap before.
void checkNotMissed(const Scene& s, std::size_t segment, const Obstacle& o,
                    const std::optional<core::Contact>& contact) {
  const std::vector<Vec2> centre{{0, 0}};
  for (const Vec2& vertex : o.outline().empty() ? centre : o.outline()) {
    const Case c = s.of(segment, o, vertex);
    expectNothing(missedBySampling(c, contact), c);
  }
}

void checkNotInvented(const Scene& s, std::size_t segment, const Obstacle& o,
                      const core::Contact& contact) {
  const Case c = s.of(segment, o);
  if (o.outline().empty()) expectNothing(inventedBySampling(c, contact), c);
}

void checkSegments(const Scene& s) {
  for (std::size_t i = 0; i < s.footprint.size(); ++i) {
    const auto& touched = s.prediction.segments.at(i);
    const auto contact = touched ? std::optional(touched->contact) : std::nullopt;
    for (const Obstacle& o : s.obstacles) checkNotMissed(s, i, o, contact);
    if (touched) checkNotInvented(s, i, s.obstacles.at(touched->obstacle), touched->contact);
  }
}

std::string described(const Scene& s) {
  std::string text = "// for each segment and obstacle\n";
  for (std::size_t i = 0; i < s.footprint.size(); ++i)
    for (const Obstacle& o : s.obstacles) text += asCode(s.of(i, o)) + "\n";
  return text;
}

/// Later than one of the segments' only where that is early by what the guarantee allows.
void checkNotLater(const Scene& s, const std::optional<core::Contact>& first) {
  for (const auto& touched : s.prediction.segments) {
    if (!touched) continue;
    const double t = touched->contact.time;
    if (first && first->time <= t + 1e-9 * std::max(1.0, t)) continue;
    for (std::size_t i = 0; i < s.footprint.size(); ++i)
      checkNotMissed(s, i, s.obstacles.at(touched->obstacle), first);
  }
}

void checkFirst(const Scene& s) {
  const auto& first = s.prediction.first;
  checkNotLater(s, first ? std::optional(first->contact) : std::nullopt);
  if (!first) return;
  if (!(first->closing_speed >= 0)) fail("closing speed", described(s));
  const bool by_being_solid = first->contact.time == 0 && s.prediction.clearance.value_or(1) <= 0;
  if (!by_being_solid)
    checkNotInvented(s, first->segment, s.obstacles.at(first->obstacle), first->contact);
}

void checkGaps(const Scene& s) {
  if (!std::isfinite(s.prediction.clearance.value_or(0))) fail("clearance", described(s));
  const auto& closest = s.prediction.closest;
  const bool fine = !closest || (closest->distance >= 0 && std::isfinite(closest->distance) &&
                                 closest->time >= 0 && closest->time <= s.horizon);
  if (!fine) fail("closest approach", described(s));
}

Obstacle obstacleFrom(Bytes& bytes) {
  const Disc disc = discFrom(bytes);
  const int kind = bytes.byte() % 8;
  std::vector<Vec2> outline(kind < 2 || kind > 4 ? 0 : static_cast<std::size_t>(kind));
  for (Vec2& vertex : outline) vertex = bytes.vector(core::kMaxFootprintExtent);
  return {disc.motion, disc.radius, disc.radius_rate, outline};
}

void fuzzFootprint(Bytes& bytes) {
  std::vector<Vec2> vertices(3 + bytes.byte() % 6);
  for (Vec2& vertex : vertices) vertex = bytes.vector(2 * core::kMaxCoordinate);
  const Twist twist = twistFrom(bytes);
  std::vector<Obstacle> obstacles;
  for (int i = bytes.byte() % 4; i > 0; --i) obstacles.push_back(obstacleFrom(bytes));
  const double horizon = horizonFrom(bytes, twist);
  try {
    const Polygon footprint(vertices);
    const Scene scene{footprint, twist, obstacles, horizon,
                      predict(footprint, twist, obstacles, horizon)};
    if (!(footprint.area() >= 0 && footprint.centroid().allFinite()))
      fail("area or centroid", described(scene));
    checkSegments(scene);
    checkFirst(scene);
    checkGaps(scene);
  } catch (const core::InvalidPolygon&) {
    return;  // refused, which is an answer
  }
}

}  // namespace
}  // namespace footprint_collision_predictor::test

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace footprint_collision_predictor::test;
  Bytes bytes(data, size);
  bytes.byte() % 2 == 0 ? fuzzSegment(bytes) : fuzzFootprint(bytes);
  return 0;
}
