// The interval oracle against answers known by hand, and its arithmetic against 113 bits.
#include "interval_oracle.hpp"

#include <gtest/gtest.h>

#include "guarantee.hpp"
#include "quad.hpp"
#include "time_to_collision_cases.hpp"

namespace footprint_collision_predictor::test {
namespace {

const Segment kLine{{0, 0}, {4, 0}};

void expectBracket(const Proof& proof, double time) {
  EXPECT_TRUE(proof.isBracketed());
  EXPECT_LE(proof.free_until, time);
  EXPECT_GE(proof.contact_at.value_or(-1), time);
}

[[gnu::noinline]] Interval productOf(double a, double b, double c) {
  return (Interval(a) * Interval(b) - Interval(c)) * (Interval(a) + Interval(c));
}

TEST(Interval, EnclosesWhatIsTrue) {
  Random random(suiteSeed());
  for (int i = 0; i < 10000; ++i) {
    const double a = random.sign() * random.logUniform(1e-6, 1e6);
    const double b = random.sign() * random.logUniform(1e-6, 1e6);
    const double c = random.chance(0.5) ? a * b : random.uniform(-1e6, 1e6);
    const RoundingUpwards rounding;
    const Interval got = productOf(a, b, c);
    const Quad truth = (Quad(a) * Quad(b) - Quad(c)) * (Quad(a) + Quad(c));
    ASSERT_TRUE(Quad(got.lower()) <= truth && truth <= Quad(got.upper())) << a << " " << b;
  }
}

TEST(Interval, IsRoundedOutwardsWhereAResultIsNotExact) {
  const RoundingUpwards rounding;
  const Interval got = productOf(0.1, 0.1, 0.2);
  EXPECT_LT(got.lower(), got.upper());
  EXPECT_LT(width(got), 1e-18L);
}

TEST(IntervalOracle, ProvesTheTable) {
  for (const NamedCase& named : namedCases()) {
    SCOPED_TRACE(named.name);
    const Proof proof = prove(named.question);
    if (named.graze) {  // at the very end of what is proven to be free
      EXPECT_TRUE(!named.time || proof.free_until <= *named.time);
    } else if (named.time) {
      expectBracket(proof, *named.time);
    } else {
      EXPECT_TRUE(proof.free);
      EXPECT_EQ(proof.free_until, named.question.horizon);
    }
  }
}

TEST(IntervalOracle, CannotDecideAGrazeByLessThanRounding) {
  // A radius of 0.1 is no binary fraction, and its square is rounded.
  const Case c{kLine, {{-2, 2.5}, {1, 0}, {0, -1}}, 0.1, 10};  // passes somewhere: decided
  EXPECT_FALSE(prove(c).isUndecided());
  const Case graze{kLine, {{-3, 0.1}, {1, 0}, {0, 0}}, 0.1, 10};  // slides on at its radius
  const Proof proof = prove(graze);
  EXPECT_TRUE(proof.isUndecided());
  EXPECT_LE(proof.free_until, 3);
  EXPECT_NEAR(proof.free_until, 3, 1e-6);
}

TEST(IntervalOracle, TellsWhatIsApartAtOneTime) {
  const Case c{kLine, {{2, 5}, {0, -2}, {0, 0}}, 1, 10};  // gap 4 - 2 t
  EXPECT_TRUE(isProvenApart(c, 1, 1.999));
  EXPECT_FALSE(isProvenApart(c, 1, 2));
  EXPECT_FALSE(isProvenApart(c, 2, 0));
  EXPECT_TRUE(isProvenApart(c, 2 - 0x1p-40, 0));
}

TEST(IntervalOracle, TakesAGrowingRadius) {
  const auto growing = [](const Jet& t) -> DiscOverTime {
    return {constant(-3), constant(4), constant(1) + Interval(0.5) * t};
  };
  expectBracket(prove(kLine, growing, 20), 8);  // 3-4-5 at the start, when the radius is 5
  EXPECT_TRUE(prove(kLine, growing, 7.999).free);
}

TEST(IntervalOracle, TakesAnyOtherPath) {
  const auto cubic = [](const Jet& t) -> DiscOverTime {
    return {constant(2), constant(9) - t * t * t, constant(1)};
  };
  expectBracket(prove(kLine, cubic, 20), 2);  // 9 - 8 = 1
}

}  // namespace
}  // namespace footprint_collision_predictor::test
