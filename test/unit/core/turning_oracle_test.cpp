// The oracles for a segment that turns against closed forms. Under a constant twist a pillar moves
// on a circle about the centre of rotation, as seen from the body; it touches an end by the law of
// cosines, and the inside where that circle meets a line beside the segment.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "guarantee.hpp"
#include "interval_oracle.hpp"
#include "oracle.hpp"
#include "turning_generators.hpp"

namespace footprint_collision_predictor::test {
namespace {

/// The pillar as seen from the centre of rotation: it runs clockwise where the body turns left.
struct Orbit {
  Vec2 centre;
  double radius;
  double angle;  // at t = 0
  double yaw_rate;

  /// The first t >= 0 at which the pillar is at that angle.
  double timeOf(double at) const {
    const double way = std::fmod((yaw_rate > 0 ? angle - at : at - angle) + 8 * M_PI, 2 * M_PI);
    return way / std::abs(yaw_rate);
  }
};

Orbit orbitOf(const Case& c) {
  const Vec2 centre = core::leftNormal(c.twist.linear) / c.twist.angular;
  const Vec2 from_centre = c.circle.position - centre;
  return {centre, from_centre.norm(), std::atan2(from_centre.y(), from_centre.x()),
          c.twist.angular};
}

double angleOf(const Vec2& v) { return std::atan2(v.y(), v.x()); }

std::vector<double> contactsWithEnd(const Orbit& orbit, const Vec2& end, double radius) {
  const Vec2 to_end = end - orbit.centre;
  const double cosine = (to_end.squaredNorm() + orbit.radius * orbit.radius - radius * radius) /
                        (2 * orbit.radius * to_end.norm());
  if (std::abs(cosine) > 1) return {};
  return {orbit.timeOf(angleOf(to_end) - std::acos(cosine)),
          orbit.timeOf(angleOf(to_end) + std::acos(cosine))};
}

std::vector<double> contactsWithInside(const Orbit& orbit, const Segment& s, double radius) {
  const Vec2 along = (s.end - s.start).normalized();
  const Vec2 to_start = s.start - orbit.centre;
  std::vector<double> times;
  for (const double side : {radius, -radius}) {
    const double height = core::cross(along, to_start) + side;  // of the line, over the centre
    const double half_chord = std::sqrt(orbit.radius * orbit.radius - height * height);
    for (const double x : {half_chord, -half_chord}) {  // NaN where they do not meet
      const double on_segment = x - along.dot(to_start);
      if (on_segment >= 0 && on_segment <= (s.end - s.start).norm())
        times.push_back(orbit.timeOf(angleOf(x * along + height * core::leftNormal(along))));
    }
  }
  return times;
}

std::optional<double> closedForm(const Case& c) {
  if (core::distance(c.segment, c.circle.position) <= c.radius) return 0;
  const Orbit orbit = orbitOf(c);
  std::vector<double> times = contactsWithInside(orbit, c.segment, c.radius);
  for (const Vec2& end : {c.segment.start, c.segment.end})
    for (const double t : contactsWithEnd(orbit, end, c.radius)) times.push_back(t);
  const auto first = std::min_element(times.begin(), times.end());
  if (first == times.end() || *first > c.horizon) return std::nullopt;
  return *first;
}

/// Of metres, and with turns that a double can tell apart.
Case anyPillar(Random& random) {
  const Segment s{random.uniform(0, 3) * random.direction(),
                  random.uniform(0, 3) * random.direction()};
  const Twist twist{random.uniform(0, 3) * random.direction(),
                    random.sign() * random.logUniform(1e-2, 10)};
  return {s,
          {random.uniform(0, 8) * random.direction(), {0, 0}, {0, 0}},
          random.chance(0.1) ? 0 : random.uniform(0, 2),
          random.uniform(0.1, 3) * 2 * M_PI / std::abs(twist.angular),
          0,
          twist};
}

TEST(TurningOracle, AgreesWithTheClosedFormOfAPillar) {
  std::size_t hits = 0;
  forEachCase("pillar in closed form", {5000, 200000}, [&](Random& random) -> std::string {
    const Case c = anyPillar(random);
    const std::optional<double> expected = closedForm(c);
    const Proof proof = prove(c);
    if (expected) ++hits;
    if (proof.isUndecided()) return "";
    const double rounding = 1e-7;  // of the closed form, in grazes
    const bool fine = expected
                          ? proof.contact_at && std::abs(*proof.contact_at - *expected) < rounding
                          : proof.free;
    if (fine) return "";
    // Where it grazes, the closed form decides by rounding.
    const Quad gap = trueGap(c, expected.value_or(proof.free_until));
    return absolute(gap) < Quad(1e-13) ? "" : "they differ\n" + asCode(c);
  });
  EXPECT_GT(hits, scaled({5000, 200000}) / 3);
}

TEST(TurningOracle, AgreesWithBisection) {
  forEachCase("turning by bisection", {100, 3000}, [](Random& random) -> std::string {
    Case c = random.chance(0.5) ? turningCase(random) : pillar(random);
    c.radius_rate = random.uniform(0, 1e-2);
    c.horizon = std::min(c.horizon, 2.0);
    const Proof proof = prove(c);
    if (proof.isUndecided()) return "";
    const std::optional<Quad> slow = contactByBisection(c, 1e-7);
    if (!slow) return proof.contact_at ? "bisection sees none\n" + asCode(c) : "";
    if (proof.free || *slow < Quad(proof.free_until) - Quad(2e-7))  // a graze, but for a hair
      return trueGap(c, *slow) < Quad(1e-4) ? "" : "bisection is early\n" + asCode(c);
    return *slow <= Quad(*proof.contact_at) + Quad(2e-7) ? "" : "bisection is late\n" + asCode(c);
  });
}

TEST(TurningOracle, SeesTheSameFromAnyFrameOfTheBody) {
  forEachCase("gap from any frame", {3000, 100000}, [](Random& random) -> std::string {
    const Case c = turningAndGrowing(random);
    Eigen::Matrix2d turn;  // exact
    turn << 0, -1, 1, 0;
    if (random.chance(0.5)) turn.col(0) = -turn.col(0);
    const Case other = fromOtherFrame(c, turn, random.uniform(0, 10) * random.direction());
    const double t = random.uniform(0, 1) * c.horizon;
    const Quad difference = absolute(trueGap(c, t) - trueGap(other, t));
    // The positions are rounded, and so is the velocity.
    const double rounding = 1e-14 * (sizeOfCoordinates(c, t) + sizeOfCoordinates(other, t) + 100);
    return difference <= Quad(rounding) ? "" : "another gap\n" + asCode(c);
  });
}

TEST(TurningOracle, ThePolynomialsAreNotAskedToTurn) {
  const Case c{{{0, 0}, {1, 0}}, {{0, 3}, {0, 0}, {0, 0}}, 1, 10, 0, {{0, 0}, 1}};
  EXPECT_THROW(trueContact(c), std::invalid_argument);
}

}  // namespace
}  // namespace footprint_collision_predictor::test
