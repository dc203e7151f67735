// Enclosures of sine, cosine and their integrals, against values from a program for arbitrary
// precision and against 113 bits.
#include "interval_turning.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "quad.hpp"
#include "random.hpp"

namespace footprint_collision_predictor::test {
namespace {

// Sum of two doubles: 106 bits.
struct Known {
  double angle;
  Quad sine;
  Quad cosine;
};

const std::vector<Known>& knownTurns() {
  static const std::vector<Known> kKnown{
      {0, 0, 1},
      {1e-3, Quad(0x1.0624da5218a62p-10) + 0x1.ac761c3704423p-68,
       Quad(0x1.ffffef390876cp-1) - 0x1.20ee49f228c2cp-57},
      {1, Quad(0x1.aed548f090ceep-1) + 0x1.06374f484e288p-59,
       Quad(0x1.14a280fb5068cp-1) - 0x1.b71edcc9344bcp-55},
      {-22.5, Quad(0x1.f2dde019d9bc7p-2) + 0x1.d4756c085cc8fp-59,
       Quad(-0x1.bf21c9294b1c4p-1) - 0x1.01a19e3d60f62p-56},
      {36000.5, Quad(-0x1.abfbf4110096dp-1) - 0x1.e1092491a8ac0p-57,
       Quad(-0x1.1905b529ff297p-1) + 0x1.4aa03750b8eaep-55},
      {123456, Quad(-0x1.7b066ed06d1ddp-1) - 0x1.212e0c60ae214p-55,
       Quad(-0x1.583708e3f768bp-1) - 0x1.fe1b22e9067bap-55}};
  return kKnown;
}

// Arithmetic of intervals lies in functions called after rounding has been set: see interval.hpp.
[[gnu::noinline]] SineAndCosine turnedBy(double low, double high) {
  const Turning turning = turningWithin(Interval(low, high), 1);
  return {turning.sine.value, turning.cosine.value};
}
[[gnu::noinline]] Turning turningFrom(double low, double high, double w) {
  return turningWithin(Interval(low, high), w);
}

bool encloses(const Interval& got, Quad truth) {
  return Quad(got.lower()) <= truth && truth <= Quad(got.upper());
}

double widthOf(const Interval& i) { return static_cast<double>(i.upper() - i.lower()); }

TEST(QuadTurn, HasTheKnownValues) {
  for (const Known& known : knownTurns()) {
    const QuadTurn turn = sineAndCosine(Quad(known.angle));
    const double tolerance = 1e-31 + 1e-33 * std::abs(known.angle);
    EXPECT_LT(static_cast<double>(absolute(turn.sine - known.sine)), tolerance) << known.angle;
    EXPECT_LT(static_cast<double>(absolute(turn.cosine - known.cosine)), tolerance) << known.angle;
  }
}

TEST(QuadTurn, KeepsAllBitsOfASmallSine) {
  const Quad angle = Quad(1e-200) / 3;
  EXPECT_TRUE(sineAndCosine(angle).sine == angle);
  EXPECT_TRUE(sineAndCosine(angle).cosine == 1);
}

TEST(IntervalTurning, EnclosesTheKnownValuesTightly) {
  const RoundingUpwards rounding;
  for (const Known& known : knownTurns()) {
    const SineAndCosine got = turnedBy(known.angle, known.angle);
    EXPECT_TRUE(encloses(got.sine, known.sine)) << known.angle;
    EXPECT_TRUE(encloses(got.cosine, known.cosine)) << known.angle;
    EXPECT_LT(std::max(widthOf(got.sine), widthOf(got.cosine)), 2e-18) << known.angle;
  }
}

// The angles are drawn within the interval, and at both of its ends.
TEST(IntervalTurning, EnclosesEveryAngleOfAnInterval) {
  Random random(1);
  for (int i = 0; i < 20000; ++i) {
    const double low = random.sign() * random.logUniform(1e-12, 4e4);
    const double width = random.chance(0.2) ? 0 : random.logUniform(1e-15, 10);
    const double high = low + width;
    const double where = random.uniform(0, 1);
    const double angle = where < 0.1   ? low
                         : where < 0.2 ? high
                                       : std::clamp(random.uniform(low, high), low, high);
    const QuadTurn truth = sineAndCosine(Quad(angle));
    const RoundingUpwards rounding;
    const SineAndCosine got = turnedBy(low, high);
    ASSERT_TRUE(encloses(got.sine, truth.sine)) << low << " " << high << " " << angle;
    ASSERT_TRUE(encloses(got.cosine, truth.cosine)) << low << " " << high << " " << angle;
    ASSERT_LT(widthOf(got.sine), 1e-17 + 2 * width) << low << " " << high;
    ASSERT_LE(std::max(got.sine.upper(), -got.sine.lower()), 1.0L);
  }
}

Quad forwardAt(double t, double w) {
  return w == 0 ? Quad(t) : sineAndCosine(Quad(w) * t).sine / w;
}

Quad sidewaysAt(double t, double w) {
  const Quad half = sineAndCosine(Quad(w) * t / 2).sine;
  return w == 0 ? Quad(0) : 2 * half * half / w;
}

double anyRate(Random& random) {
  if (random.chance(0.1)) return 0;
  return random.sign() * random.logUniform(random.chance(0.2) ? 1e-300 : 1e-12, 10);
}

TEST(IntervalTurning, EnclosesTheIntegralsAlsoWhereTheYawRateVanishes) {
  Random random(2);
  for (int i = 0; i < 20000; ++i) {
    const double w = anyRate(random);
    const double low = random.chance(0.1) ? 0 : random.logUniform(1e-9, 3600);
    const double width = random.chance(0.3) ? 0 : random.logUniform(1e-12, 10);
    const double t = std::clamp(low + random.uniform(0, 1) * width, low, low + width);
    const Quad forward = forwardAt(t, w);
    const Quad sideways = sidewaysAt(t, w);
    const RoundingUpwards rounding;
    const Turning got = turningFrom(low, low + width, w);
    ASSERT_TRUE(encloses(got.forward.value, forward)) << low << " " << width << " " << w;
    ASSERT_TRUE(encloses(got.sideways.value, sideways)) << low << " " << width << " " << w;
    ASSERT_LT(widthOf(got.forward.value), 3 * width + 1e-18 * (1 + low)) << low << " " << w;
    ASSERT_LT(widthOf(got.sideways.value), 3 * width + 1e-18 * (1 + low)) << low << " " << w;
  }
}

// Mean values: from one end to the other a function changes by what its slopes make of it.
void expectSlope(const Jet& jet, const Interval& before, const Interval& after, double low,
                 double high, double w) {
  const Interval dt(static_cast<long double>(high) - static_cast<long double>(low));
  const Interval change = after - before;
  const Interval allowed = dt * jet.slope;
  ASSERT_TRUE(change.upper() >= allowed.lower() && change.lower() <= allowed.upper())
      << low << " " << high << " " << w;
}

[[gnu::noinline]] void expectSlopes(double low, double high, double w) {
  const Turning all = turningFrom(low, high, w);
  const Turning before = turningFrom(low, low, w);
  const Turning after = turningFrom(high, high, w);
  for (const auto f : {&Turning::sine, &Turning::cosine, &Turning::forward, &Turning::sideways}) {
    const Jet& jet = all.*f;
    expectSlope(jet, (before.*f).value, (after.*f).value, low, high, w);
    // The slopes themselves, by the second derivative.
    expectSlope({jet.slope, jet.curvature, Interval(0)}, (before.*f).slope, (after.*f).slope, low,
                high, w);
  }
}

TEST(IntervalTurning, SlopesAndCurvaturesAreThoseOfTheValues) {
  Random random(3);
  for (int i = 0; i < 5000 && !testing::Test::HasFatalFailure(); ++i) {
    const double low = random.uniform(0, 100);
    const double w = anyRate(random);
    const double high = low + random.logUniform(1e-4, 1e-1);
    const RoundingUpwards rounding;
    expectSlopes(low, high, w);
  }
}

}  // namespace
}  // namespace footprint_collision_predictor::test
