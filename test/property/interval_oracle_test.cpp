// The two oracles against each other, and the core against what intervals prove.
#include "interval_oracle.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>

#include "growing_generators.hpp"
#include "guarantee.hpp"
#include "oracle.hpp"
#include "turning_generators.hpp"

namespace footprint_collision_predictor::test {
namespace {

struct Count {
  std::size_t cases = 0;
  std::size_t free = 0;
  std::size_t contact = 0;
  std::size_t undecided = 0;

  void add(const Proof& proof) {
    ++cases;
    ++(proof.free ? free : proof.isBracketed() ? contact : undecided);
  }
  void print(const char* suite) const {
    std::printf("%-28s %7zu cases %7zu proven free, %zu contact, %zu undecided\n", suite, cases,
                free, contact, undecided);
  }
};

/// Half of them as common as they come, half of every kind of trouble there is.
Case ofEveryKind(Random& random) {
  using Make = Case (*)(Random&);
  static const std::array<Make, 6> kTrouble{grazingEnd, osculating,  touchingNow,
                                            braking,    awayAndBack, boomerang};
  if (random.chance(0.5)) return anyCase(random);
  return kTrouble[static_cast<std::size_t>(random.integer(0, 5))](random);
}

/// The quartic of an end is the square of a distance, which leaves half of the 113 bits to the
/// distance itself: a point that passes an end by less than that is said to meet it.
bool isNearlyARoot(const Case& c, Quad t) {
  const Quad gap = trueGap(c, t);
  const double size = sizeOfCoordinates(c, static_cast<double>(t));
  return gap > Quad(1e-28 * size) && gap <= Quad(1e-16 * size);
}

/// The 113-bit oracle must lie within whatever is proven.
std::string disagreement(const Case& c, const Proof& proof) {
  const std::optional<Quad> t = trueContact(c);
  if (!t) return proof.contact_at ? "the proven contact has no root\n" + asCode(c) : "";
  const Quad rounding = Quad(1e-15) * (Quad(1) + *t);
  const bool too_early = proof.free || *t < Quad(proof.free_until) - rounding;
  if (too_early && !isNearlyARoot(c, *t)) return "a root where all is proven free\n" + asCode(c);
  const bool too_late = proof.contact_at && *t > Quad(*proof.contact_at) + rounding;
  return too_late ? "the proven contact is before the root\n" + asCode(c) : "";
}

/// The guarantee, as far as it is proven to be broken.
std::string provenWrong(const Case& c, const Proof& proof) {
  const std::optional<core::Contact> contact = ask(c);
  const double latest = proof.contact_at ? *proof.contact_at + 1e-9 : c.horizon;
  if (proof.contact_at && !contact) return "missed\n" + asCode(c);
  if (!contact) return "";
  if (!(contact->time >= 0 && contact->time <= c.horizon)) return "not a time\n" + asCode(c);
  if (contact->time > latest * (1 + 1e-9)) return "late\n" + asCode(c);
  const double tolerance = 2 * contactTolerance(c.segment, c.disc(), contact->time);
  return isProvenApart(c, contact->time, tolerance) ? "invented\n" + asCode(c) : "";
}

void expectProven(const char* suite, const SuiteSize& size, double most_undecided,
                  const std::function<Case(Random&)>& make) {
  Count count;
  forEachCase(suite, size, [&](Random& random) {
    const Case c = make(random);
    const Proof proof = prove(c);
    count.add(proof);
    return disagreement(c, proof) + provenWrong(c, proof);
  });
  count.print(suite);
  EXPECT_LE(static_cast<double>(count.undecided),
            3 + most_undecided * static_cast<double>(count.cases));
}

TEST(IntervalOracle, AgreesAndProvesTheGuarantee) {
  expectProven("intervals, every kind", kProven, 0.06, ofEveryKind);
}

TEST(IntervalOracle, DecidesWhatIsNoGraze) {
  expectProven("intervals, uniform", kProven, 4e-3, anyCase);
}

TEST(IntervalOracle, AgreesInGrazes) {
  expectProven("intervals, grazing", {10000, 500000}, 0.08, grazingEnd);
}

TEST(IntervalOracle, AgreesFarFromTheOrigin) {
  expectProven("intervals, far origin", {10000, 500000}, 4e-3, [](Random& random) {
    return translated(anyCase(random), random.logUniform(1e3, 1e6) * random.direction());
  });
}

TEST(IntervalOracle, AgreesOnAGrowingRadius) {
  expectProven("intervals, growing", {10000, 500000}, 4e-3, growingCase);
  expectProven("intervals, growing, grazing", {5000, 200000}, 0.1, growingGraze);
}

/// A point, or almost one, was on the other side of the segment's line, or on it, a moment before.
bool hasJustCrossed(const Case& c, double time) {
  const Quad now = trueSide(c, time);
  Quad before = 0x1p-40;
  for (; before < Quad(time); before *= 2)
    if (trueSide(c, time - before) * now <= 0) return true;
  return trueSide(c, 0) * now <= 0;
}

/// What is proven of a segment that turns, by the gap in 113 bits at any time before, and then.
std::string wrongProof(const Case& c, const Proof& proof, Random& random) {
  const Quad rounding = Quad(1e-25 * sizeOfCoordinates(c, c.horizon));
  // An unbracketed contact may be proven by a crossing long before.
  if (proof.isBracketed() && trueGap(c, *proof.contact_at) > rounding &&
      !(c.radius == 0 && hasJustCrossed(c, *proof.contact_at)))
    return "a gap where contact is proven\n" + asCode(c);
  for (int i = 0; i < 10 && proof.free_until > 0; ++i) {
    const double t = proof.free_until * (1 - random.logUniform(1e-12, 1));
    if (trueGap(c, t) < -rounding) return "touches where all is proven free\n" + asCode(c);
  }
  return "";
}

TEST(IntervalOracle, AgreesOnTurning) {
  Count count;
  forEachCase("intervals, turning", {10000, 500000}, [&](Random& random) {
    const Case c = random.chance(0.5) ? turningOfEveryKind(random) : turningAndGrowing(random);
    const Proof proof = prove(c);
    count.add(proof);
    return wrongProof(c, proof, random);
  });
  count.print("intervals, turning");
}

}  // namespace
}  // namespace footprint_collision_predictor::test
