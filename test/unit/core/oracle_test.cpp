// The oracle against answers known by hand, and against bisection that knows no polynomials.
#include "oracle.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "generators.hpp"
#include "guarantee.hpp"
#include "polynomial.hpp"

namespace footprint_collision_predictor::test {
namespace {

const Segment kLine{{0, 0}, {4, 0}};

double contactTime(const Case& c) {
  const std::optional<Quad> t = trueContact(c);
  return t ? static_cast<double>(*t) : -1;
}

TEST(Quad, RootsOfSquaresAreExact) {
  EXPECT_TRUE(squareRoot(Quad(1e17) * Quad(1e17)) == Quad(1e17));
  EXPECT_TRUE(squareRoot(0) == 0);
  const Quad error = squareRoot(2) * squareRoot(2) - 2;
  EXPECT_LT(static_cast<double>(absolute(error)), 1e-33);
  EXPECT_TRUE(squareRoot(Quad(0x1p-900) * Quad(0x1p-900)) == Quad(0x1p-900));
}

TEST(Polynomial, FindsEveryRootInOrder) {
  // (t - 1)(t - 2)(t - 3)(t - 4) = 24 - 50 t + 35 t^2 - 10 t^3 + t^4
  const Polynomial p{{24, -50, 35, -10, 1}};
  const std::vector<Quad> roots = rootsBetween(p, 0, 10);
  ASSERT_EQ(roots.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_NEAR(static_cast<double>(roots[i]), static_cast<double>(i + 1), 1e-30);
  EXPECT_EQ(rootsBetween(p, 1.5, 3.5).size(), 2u);
  EXPECT_EQ(static_cast<double>(*firstNotPositive(p, 1.5, 10)), 1.5);  // negative there
  EXPECT_EQ(static_cast<double>(*firstNotPositive(p, 2.5, 10)), 3);
}

TEST(Polynomial, FindsADoubleRootThatOnlyTouches) {
  const std::optional<Quad> t = firstNotPositive({{4, -4, 1, 0, 0}}, 0, 10);
  ASSERT_TRUE(t);
  EXPECT_EQ(static_cast<double>(*t), 2);
}

TEST(Oracle, KnowsTheHandCases) {
  EXPECT_EQ(contactTime({kLine, {{2, 5}, {0, -2}, {0, 0}}, 1, 10}), 2);   // onto the inside
  EXPECT_EQ(contactTime({kLine, {{2, -5}, {0, 2}, {0, 0}}, 1, 10}), 2);   // from the other side
  EXPECT_EQ(contactTime({kLine, {{10, 0}, {-1, 0}, {0, 0}}, 1, 10}), 5);  // end-on
  EXPECT_EQ(contactTime({kLine, {{-6, 4}, {1, 0}, {0, 0}}, 5, 10}), 3);   // 3-4-5 at the start
  EXPECT_EQ(contactTime({kLine, {{2, 5}, {0, 0}, {0, -2}}, 1, 10}), 2);   // falling 4 m
  EXPECT_EQ(contactTime({kLine, {{2, 5}, {0, -4}, {0, 2}}, 1, 10}), 2);   // stops in contact
  EXPECT_EQ(contactTime({kLine, {{-3, 1}, {1, 0}, {0, 0}}, 1, 10}), 3);   // slides on
  EXPECT_EQ(contactTime({kLine, {{2, 1}, {0, 1}, {0, 0}}, 1, 10}), 0);    // touches, leaves
  EXPECT_EQ(contactTime({kLine, {{2, 5}, {0, -2}, {0, 0}}, 1, 2}), 2);    // at the horizon
  EXPECT_EQ(contactTime({kLine, {{2, 5}, {0, -2}, {0, 0}}, 1, 1.99}), -1);
  EXPECT_EQ(contactTime({kLine, {{-6, 4}, {1, 0}, {0, 0}}, 3.99, 20}), -1);
  EXPECT_EQ(contactTime({kLine, {{2, 5}, {0, -3.99}, {0, 2}}, 1, 10}), -1);
  EXPECT_EQ(contactTime({kLine, {{9, 9}, {0, 0}, {0, 0}}, 1, 10}), -1);
}

TEST(Oracle, MeasuresTheGapExactly) {
  const Case c{kLine, {{-6, 0}, {1, 0}, {0, 2}}, 5, 10};  // at t = 2: (-4, 4), at t = 3: (-3, 9)
  EXPECT_EQ(static_cast<double>(trueGap(c, 0)), 1);
  EXPECT_NEAR(static_cast<double>(trueGap(c, 2)), std::sqrt(32.0) - 5, 1e-15);
  EXPECT_EQ(static_cast<double>(trueGap({kLine, {{2, 7}, {0, 0}, {0, 0}}, 2, 1}, 0)), 5);
  EXPECT_EQ(static_cast<double>(distanceFromNearest(c, 0, {3, 4})), 5);
}

TEST(Oracle, LeavesNoGapAtContactAndAGapBefore) {
  forEachCase("oracle is on the boundary", {2000, 100000}, [](Random& random) -> std::string {
    const Case c = anyCase(random);
    const std::optional<Quad> t = trueContact(c);
    if (!t || *t == 0) return "";
    const double gap = static_cast<double>(absolute(trueGap(c, *t)));
    const bool early = trueGap(c, *t * Quad(0.5)) > 0;
    return gap < 1e-24 && early ? "" : "gap " + std::to_string(gap) + "\n" + asCode(c);
  });
}

TEST(Oracle, AgreesWithBisection) {
  std::size_t hits = 0;
  forEachCase("oracle against bisection", {3000, 100000}, [&hits](Random& random) -> std::string {
    Case c = anyCase(random);
    c.horizon = std::min(c.horizon, 20.0);
    const std::optional<Quad> exact = trueContact(c);
    const std::optional<Quad> slow = contactByBisection(c, 1e-12);
    if (exact) ++hits;
    if (exact && slow && absolute(*exact - *slow) <= Quad(1e-11)) return "";
    // In a graze bisection may see contact where a hair is left.
    if (slow && (!exact || *slow < *exact) && trueGap(c, *slow) < Quad(1e-9)) return "";
    return exact || slow ? "they differ\n" + asCode(c) : "";
  });
  EXPECT_GT(hits, scaled({3000, 100000}) / 6);
}

}  // namespace
}  // namespace footprint_collision_predictor::test
