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

[[noreturn]] void fail(const std::string& wrong, const std::string& code) {
  std::fprintf(stderr, "WRONG ANSWER: %s\n%s\n", wrong.c_str(), code.c_str());
  std::abort();
}

void checkAnswer(const Case& c, const std::optional<core::Contact>& contact) {
  const std::string wrong = wrongBySampling(c, contact);
  if (!wrong.empty()) fail(wrong, asCode(c));
}

Motion motionFrom(Bytes& bytes) {
  const Vec2 position = bytes.vector(core::kMaxCoordinate);
  const Vec2 velocity = bytes.vector(core::kMaxRate);
  return {position, velocity, bytes.vector(core::kMaxRate)};
}

void fuzzSegment(Bytes& bytes) {
  const Vec2 start = bytes.vector(core::kMaxCoordinate);
  const Vec2 end = start + bytes.vector(core::kMaxFootprintExtent);
  const Motion motion = motionFrom(bytes);
  const double radius = bytes.notNegative(core::kMaxRadius);
  const Case c{{start, end}, motion, radius, bytes.notNegative(core::kMaxHorizon)};
  checkAnswer(c, ask(c));
}

std::string described(const Polygon& footprint, const std::vector<Obstacle>& obstacles,
                      double horizon) {
  std::string text = "// for each segment and obstacle\n";
  for (std::size_t i = 0; i < footprint.size(); ++i)
    for (const Obstacle& o : obstacles)
      text += asCode({footprint.segment(i), o.motion(), o.radius(), horizon}) + "\n";
  return text;
}

/// The footprint's answers must be those of its segments, each asked alone, but for shared
/// vertices.
std::string wrongPrediction(const Polygon& footprint, const core::Twist& twist,
                            const std::vector<Obstacle>& obstacles, double horizon,
                            const Prediction& prediction) {
  double earliest = HUGE_VAL;
  for (std::size_t i = 0; i < footprint.size(); ++i) {
    double alone = HUGE_VAL;
    for (const Obstacle& o : obstacles) {
      const Case c{footprint.segment(i), relativeMotion(o.motion(), twist), o.radius(), horizon};
      const std::optional<core::Contact> contact = ask(c);
      checkAnswer(c, contact);
      if (contact) alone = std::min(alone, contact->time);
    }
    const auto& together = prediction.segments.at(i);
    const double time = together ? together->contact.time : HUGE_VAL;
    // A touch of a vertex is also one of the neighbour, which may see it a rounding later, or not.
    const bool is_shared = together && together->contact.feature != core::Feature::kInside;
    if (time != alone && !(is_shared && time < alone)) return "segment differs alone";
    alone = time;
    earliest = std::min(earliest, alone);
  }
  const double first = prediction.first ? prediction.first->contact.time : HUGE_VAL;
  const bool by_being_solid = first == 0 && prediction.clearance.value_or(1) <= 0;
  if (first != earliest && !by_being_solid) return "the first contact is not that of a segment";
  if (prediction.first && !(prediction.first->closing_speed >= 0)) return "closing speed";
  return std::isfinite(prediction.clearance.value_or(0)) ? "" : "clearance";
}

void fuzzFootprint(Bytes& bytes) {
  std::vector<Vec2> vertices(3 + bytes.byte() % 6);
  for (Vec2& vertex : vertices) vertex = bytes.vector(2 * core::kMaxCoordinate);
  const core::Twist twist{bytes.vector(core::kMaxRate), 0};
  std::vector<Obstacle> obstacles;
  for (int i = bytes.byte() % 4; i > 0; --i) {
    const Motion motion = motionFrom(bytes);
    obstacles.emplace_back(motion, bytes.notNegative(core::kMaxRadius));
  }
  const double horizon = bytes.notNegative(core::kMaxHorizon);
  try {
    const Polygon footprint(vertices);
    if (!(footprint.area() >= 0 && footprint.centroid().allFinite()))
      fail("area or centroid", described(footprint, {{{{0, 0}, {0, 0}, {0, 0}}, 0}}, 0));
    const Prediction prediction = predict(footprint, twist, obstacles, horizon);
    const std::string wrong = wrongPrediction(footprint, twist, obstacles, horizon, prediction);
    if (!wrong.empty()) fail(wrong, described(footprint, obstacles, horizon));
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
