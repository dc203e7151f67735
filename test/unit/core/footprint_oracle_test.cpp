// The oracle of whole footprints against answers known by hand, and against plain sampling.
#include "footprint_oracle.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "footprint_generators.hpp"
#include "guarantee.hpp"
#include "oracle.hpp"
#include "truth.hpp"

namespace footprint_collision_predictor::test {
namespace {

// Segments: 0 below, 1 in front, 2 above, 3 behind.
const std::vector<Vec2> kBox{{-1, -0.5}, {1, -0.5}, {1, 0.5}, {-1, 0.5}};
const std::vector<Vec2> kWall{{0, -3}, {0, 3}};

FootprintCase moving(const Vec2& position, const Vec2& velocity, double radius,
                     const std::vector<Vec2>& outline = {}) {
  return {kBox, {}, {{position, velocity, {0, 0}}, radius, 0}, outline, 20};
}

void expectTouch(const FirstTouch& touch, double time) {
  EXPECT_NEAR(static_cast<double>(touch.contact_at.value_or(-1)), time, 1e-10);
  EXPECT_NEAR(static_cast<double>(touch.free_until), time, 1e-8);
}

void expectTouch(const FootprintCase& c, double time) {
  expectTouch(FootprintOracle(c).firstTouch(), time);
}

void expectFree(const FootprintCase& c) {
  const FirstTouch touch = FootprintOracle(c).firstTouch();
  EXPECT_FALSE(touch.contact_at);
  EXPECT_EQ(static_cast<double>(touch.free_until), c.horizon);
}

TEST(FootprintOracle, KnowsCircles) {
  expectTouch(moving({5, 0}, {-1, 0}, 0.25), 3.75);
  expectTouch(moving({7, 8.5}, {-3, -4}, 5), 1);  // 3-4-5 at the corner
  expectTouch(moving({5, 0}, {-1, 0}, 0), 4);     // a point crosses the front
  expectTouch(moving({0, 0}, {0, 0}, 0.1), 0);
  expectTouch(moving({0.8, 0}, {1, 0}, 0.05), 0);  // wholly inside
  expectFree(moving({5, 0.751}, {-1, 0}, 0.25));
}

TEST(FootprintOracle, KnowsLinesAndPolygons) {
  expectTouch(moving({5, 0}, {-2, 0}, 0.5, kWall), 1.75);          // face to face
  expectTouch(moving({5, 0}, {-2, 0}, 0, kWall), 2);               // without a radius, for a moment
  expectTouch(moving({0, 3}, {0, -1}, 0, {{0, 0}, {0, 2}}), 2.5);  // end into a side
  expectTouch(moving({4, 3.5}, {-1, -1}, 0, {{-2, 2}, {2, -2}}), 3);       // side onto a corner
  expectTouch(moving({9, 0}, {-1, 0}, 1, {{2, 2}, {2, -2}, {-2, 0}}), 5);  // a triangle's tip
  expectTouch(moving({0, 0}, {0, 0}, 0, {{-9, -9}, {9, -9}, {9, 9}, {-9, 9}}), 0);  // around
  expectFree(moving({5, 3.001}, {-1, 0}, 0, {{0, -2.5}, {0, 2.5}}));
}

TEST(FootprintOracle, KnowsOtherMotions) {
  FootprintCase falling = moving({5, 0}, {0, 0}, 0, kWall);
  falling.disc.motion.acceleration = {-2, 0};
  expectTouch(falling, 2);
  FootprintCase growing = moving({3, 0}, {0, 0}, 0.125, kWall);
  growing.disc.radius_rate = 0.25;
  expectTouch(growing, 7.5);
  FootprintCase driving = moving({5, 0}, {0, 0}, 0.5, kWall);
  driving.twist.linear = {0.5, 0};
  expectTouch(driving, 7);
}

TEST(FootprintOracle, KnowsACornerThatSweepsAWall) {
  FootprintCase c = moving({1.1, 0}, {0, 0}, 0, kWall);
  c.twist.angular = 1;
  expectTouch(c, std::atan(0.5) - std::acos(1.1 / std::hypot(1, 0.5)));
  c.twist.angular = -1;  // the other corner: the same by symmetry
  expectTouch(c, std::atan(0.5) - std::acos(1.1 / std::hypot(1, 0.5)));
  c.disc.motion.position = {1.1181, 0};  // the corners reach 1.1180 m
  expectFree(c);
}

TEST(FootprintOracle, KnowsAnArc) {
  // Along the circle with radius 2 about (0, 2), after half of it at (0, 4), heading back.
  FootprintCase c = moving({-3, 4}, {0, 0}, 0.25);
  c.twist = {{M_PI, 0}, M_PI / 2};
  c.horizon = 4;
  const FootprintOracle oracle(c);
  EXPECT_NEAR(static_cast<double>(oracle.gap(2)), 1.75, 1e-12);  // 3 - 1 - 0.25
  c.disc.motion.position = {0, 2};                               // where nothing moves
  EXPECT_NEAR(static_cast<double>(FootprintOracle(c).gap(1.234)), 1.25, 1e-12);
  EXPECT_NEAR(static_cast<double>(FootprintOracle(c).smallestGap().gap), 1.25, 1e-7);
}

TEST(FootprintOracle, KnowsEachSegment) {
  const FootprintOracle oracle(moving({5, 0}, {-1, 0}, 0.25));
  expectTouch(oracle.firstTouchOfSegment(1), 3.75);
  expectTouch(oracle.firstTouchOfSegment(3), 5.75);  // from inside
  EXPECT_FALSE(oracle.firstTouchOfSegment(0).contact_at);
  EXPECT_NEAR(static_cast<double>(oracle.gapOfSegment(3, 0)), 5.75, 1e-15);
  EXPECT_NEAR(static_cast<double>(oracle.gapOfPoint({1, 0.5}, 2)), std::hypot(2, 0.5) - 0.25,
              1e-15);
}

TEST(FootprintOracle, KnowsATinySegment) {
  // 7 nm long; a line that is nearly in line with it slides along it. The time was computed with
  // rational numbers.
  const FootprintCase c{
      {{0x1.ff8f3913056c5p-4, 0x1.27e8acdf18987p-5},
       {0x1.bf1d8b7057209p-5, 0x1.7ffcfc351e848p-4},
       {-0x1.7df54ec80bd81p-5, 0x1.c2fa1bc30d4eap-4},
       {-0x1.8f01a87dde36ap-4, 0x1.cc9c6d5aa47c1p-7},
       {-0x1.b584373095b35p-6, -0x1.0f602be136611p-6},
       {-0x1.b58435c6d7299p-6, -0x1.0f6033bd3a6e7p-6},
       {-0x1.a4de2704ac785p-8, -0x1.08f3d8844bbdbp-3},
       {0x1.2ba776e764c22p-5, -0x1.2e95a319a1635p-6}},
      {},
      {{{0x1.b5fb0ba03af8dp-3, -0x1.432aba449eee2p+0},
        {-0x1.634016a5364b6p-10, 0x1.edf962366b87bp-8},
        {0, 0}},
       0,
       0},
      {{-0x1.ecab91e7e8d9p-3, 0x1.3eed3926fa95ap+0}, {-0x1.ecab91963b42p-3, 0x1.3eed38ee313c2p+0}},
      3};
  expectTouch(FootprintOracle(c).firstTouchOfSegment(4), 3.1585339858348076e-06);
}

TEST(FootprintOracle, KnowsTheSmallestGap) {
  const SmallestGap passing = FootprintOracle(moving({5, 2}, {-1, 0}, 0.25)).smallestGap();
  EXPECT_NEAR(static_cast<double>(passing.gap), 1.25, 1e-7);
  EXPECT_GE(passing.time, 3.999);  // beside the box
  const SmallestGap crossing =
      FootprintOracle(moving({3, 3}, {-1, 1}, 0.5, {{-1, 0}, {1, 0}})).smallestGap();
  EXPECT_NEAR(static_cast<double>(crossing.gap), std::hypot(1, 2.5) - 0.5, 1e-7);  // at once
  EXPECT_EQ(FootprintOracle(moving({5, 0}, {-1, 0}, 0.25)).smallestGap().gap, 0);
}

TEST(FootprintOracle, KnowsTheSmallestGapBesideALongWall) {
  // Along (3, 4) / 5, past the lower front corner, which lies at 0.8 + 0.3 along its normal.
  const double at = 1.1 + 5e-6;
  const FootprintCase c =
      moving({0.8 * at, -0.6 * at}, {3, 4}, 0, {{-60000, -80000}, {60000, 80000}});
  EXPECT_NEAR(static_cast<double>(FootprintOracle(c).smallestGap().gap), 5e-6, 1e-7);
}

TEST(FootprintOracle, KnowsTheSignedClearance) {
  const auto clearance = [](const FootprintCase& c) {
    return static_cast<double>(FootprintOracle(c).clearance());
  };
  EXPECT_NEAR(clearance(moving({0.8, 0}, {0, 0}, 0.05)), -0.25, 1e-15);
  EXPECT_NEAR(clearance(moving({3, 0}, {0, 0}, 0.5, kWall)), 1.5, 1e-15);
  EXPECT_NEAR(clearance(moving({0, 0}, {0, 0}, 0.5, kWall)), -0.5, 1e-15);  // across
  const std::vector<Vec2> square{{-9, -9}, {9, -9}, {9, 9}, {-9, 9}};
  EXPECT_NEAR(clearance(moving({1, 0}, {0, 0}, 0.5, square)), -7.5, 1e-15);
  EXPECT_NEAR(clearance(moving({0, 0.25}, {0, 0}, 0, {{0, 0}, {0.1, 0}})), -0.25, 1e-15);
}

/// Many small steps of the footprint's pose over ground, instead of a formula.
Vec2 seenAfter(const FootprintCase& c, double t, int steps) {
  Vec2 origin{0, 0};
  const double dt = t / steps;
  for (int i = 0; i < steps; ++i) {
    const double heading = c.twist.angular * dt * (i + 0.5);
    origin +=
        dt * Vec2{std::cos(heading) * c.twist.linear.x() - std::sin(heading) * c.twist.linear.y(),
                  std::sin(heading) * c.twist.linear.x() + std::cos(heading) * c.twist.linear.y()};
  }
  const Vec2 d = c.disc.motion.positionAt(t) - origin;
  const double heading = c.twist.angular * t;
  return {std::cos(heading) * d.x() + std::sin(heading) * d.y(),
          std::cos(heading) * d.y() - std::sin(heading) * d.x()};
}

TEST(FootprintOracle, MovesAsSmallStepsDo) {
  for (const double w : {0.0, 1e-12, 1e-3, -0.7, 5.0}) {
    FootprintCase c = moving({4, -3}, {-0.5, 1}, 0.5);
    c.disc.motion.acceleration = {0.25, -0.125};
    c.twist = {{1.5, -0.25}, w};
    const Point q = MovingOutline(c).at(2.5).vertices[0];
    const Vec2 stepped = seenAfter(c, 2.5, 20000);
    EXPECT_NEAR(static_cast<double>(q.x), stepped.x(), 1e-6) << w;
    EXPECT_NEAR(static_cast<double>(q.y), stepped.y(), 1e-6) << w;
  }
}

std::string sampled(const FootprintCase& c) {
  const FootprintOracle oracle(c);
  const FirstTouch touch = oracle.firstTouch();
  const SmallestGap smallest = oracle.smallestGap();
  Real least = HUGE_VALL;
  for (int i = 0; i <= 100; ++i) {
    const Real t = c.horizon * static_cast<Real>(i) / 100;
    const Real gap = oracle.gap(t);
    least = std::min(least, gap);
    if (gap <= 0 && !(touch.contact_at && *touch.contact_at <= t + 1e-10L))
      return "later than a sample\n" + asCode(c);
    if (gap <= 0 && t < touch.free_until) return "not free\n" + asCode(c);
  }
  if (smallest.gap > std::max(least, Real(0)) + 6e-8L) return "smaller sample\n" + asCode(c);
  if (touch.contact_at && smallest.gap > 6e-8L) return "a contact with a gap\n" + asCode(c);
  return "";
}

TEST(FootprintOracle, IsNeverPastASample) {
  for (int kind = 0; kind < 16; ++kind) {
    const Moves moves{(kind & 1) > 0, (kind & 2) > 0, (kind & 4) > 0, (kind & 8) > 0};
    forEachCase("oracle against samples, " + std::to_string(kind), {60, 10000},
                [&](Random& random) -> std::string {
                  return sampled(random.chance(0.5) ? anyFootprintCase(random, moves)
                                                    : grazingFootprint(random, moves));
                });
  }
}

/// By what knows segments and circles only.
std::string otherwiseTold(const FootprintCase& c, std::size_t i) {
  const Vec2& end = c.footprint[(i + 1) % c.footprint.size()];
  const Case one{{c.footprint[i], end}, c.disc.motion, c.disc.radius, c.horizon,
                 c.disc.radius_rate,    c.twist};
  const Truth truth = truthOf(one);
  const FirstTouch touch = FootprintOracle(c).firstTouchOfSegment(i);
  if (!truth.is_decided) return "";
  const Quad until = touch.free_until;
  const Quad from = touch.contact_at.value_or(2 * core::kMaxHorizon);
  const Quad precision = 1e-9;
  if (truth.contact ? until <= *truth.contact + precision && *truth.contact <= from + precision
                    : !touch.contact_at)
    return "";
  const Quad least = trueGap(one, truth.contact ? *truth.contact : from);
  return absolute(least) < Quad(1e-15) ? "" : "they differ\n" + asCode(one);
}

TEST(FootprintOracle, AgreesWithTheOraclesOfSegments) {
  for (int kind = 0; kind < 8; ++kind) {
    const Moves moves{(kind & 1) > 0, (kind & 2) > 0, (kind & 4) > 0, false};
    forEachCase("oracles, " + std::to_string(kind), {200, 10000},
                [&](Random& random) -> std::string {
                  const FootprintCase c = random.chance(0.5) ? anyFootprintCase(random, moves)
                                                             : grazingFootprint(random, moves);
                  return otherwiseTold(c, random.next() % c.footprint.size());
                });
  }
}

}  // namespace
}  // namespace footprint_collision_predictor::test
