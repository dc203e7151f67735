// What must hold between two questions, whatever the answers are.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "agreement.hpp"
#include "growing_generators.hpp"
#include "guarantee.hpp"
#include "turning_generators.hpp"

namespace footprint_collision_predictor::test {
namespace {

/// Straight or turning, and growing or not.
Case mixedCase(Random& random) {
  using Make = Case (*)(Random&);
  static const std::array<Make, 8> kKinds{
      anyCase,     anyCase,      grazingEnd,         touchingNow,
      growingCase, growingGraze, turningOfEveryKind, turningAndGrowing};
  return kKinds[static_cast<std::size_t>(random.integer(0, 7))](random);
}

/// Contact was reported at that time of what touches no earlier than this.
bool mayBeEarly(const Case& c, double time) { return hairIsLeft(c, time, allowedGap(c, time)); }

TEST(Law, RigidMotionsAndMirrorsChangeNothing) {
  forEachCase("rigid motion", kLaw, [](Random& random) {
    const Case c = mixedCase(random);
    Eigen::Matrix2d turn = Eigen::Rotation2Dd(random.angle()).toRotationMatrix();
    if (random.chance(0.5)) turn.col(0) = -turn.col(0);
    return disagreement(c, fromOtherFrame(c, turn, random.uniform(0, 10) * random.direction()));
  });
}

TEST(Law, SwappingTheEndsSwapsOnlyTheirNames) {
  forEachCase("swapped ends", kLaw, [](Random& random) -> std::string {
    const Case c = mixedCase(random);
    Case swapped = c;
    std::swap(swapped.segment.start, swapped.segment.end);
    const Answer a = ask(c);
    const Answer b = ask(swapped);
    const std::string differ = disagreement(c, a, swapped, b);
    if (!differ.empty() || !a || !b || !notLater(b, a->time) || !notLater(a, b->time))
      return differ;
    // The nearest point moves no faster than the centre, as seen from the body.
    const double later = std::max(a->time, b->time);
    const double reach = (c.segment.end - c.segment.start).norm() + c.disc().radiusAt(later);
    const double speed = c.circle.velocity.norm() + later * c.circle.acceleration.norm() +
                         startVelocity(c).norm() + std::abs(c.twist.angular) * reach;
    const double moved_by = speed * std::abs(a->time - b->time);
    const double rounding = 2 * allowedGap(c, later);
    return (a->point - b->point).norm() <= moved_by + rounding ? "" : "other point\n" + asCode(c);
  });
}

TEST(Law, ASplitSegmentIsTouchedWhenItsFirstPartIs) {
  forEachCase("split segment", kLaw, [](Random& random) {
    const Case c = mixedCase(random);
    const Vec2 middle = pointOn(c.segment, random);
    Case first = c;
    Case second = c;
    first.segment.end = middle;
    second.segment.start = middle;
    const Answer a = ask(first);
    const Answer b = ask(second);
    const Answer whole = ask(c);
    for (const Answer& part : {a, b})
      if (part && !notLater(whole, part->time) && !mayBeEarly(c, part->time))
        return "whole\n" + asCode(c) + "\nfirst part\n" + asCode(first);
    if (!whole || notLater(a, whole->time) || notLater(b, whole->time)) return std::string();
    const bool hair = mayBeEarly(first, whole->time) || mayBeEarly(second, whole->time);
    return hair ? "" : "parts\n" + asCode(first) + "\nand\n" + asCode(second);
  });
}

TEST(Law, ALargerCircleIsNeverLater) {
  forEachCase("larger radius", kLaw, [](Random& random) -> std::string {
    const Case c = mixedCase(random);
    Case larger = c;
    double& what = random.chance(0.5) ? larger.radius : larger.radius_rate;
    what += random.chance(0.2) ? 0 : random.logUniform(1e-16, 1e2);
    const Answer a = ask(c);
    if (!a || notLater(ask(larger), a->time) || mayBeEarly(larger, a->time)) return "";
    return asCode(c) + "\nand\n" + asCode(larger);
  });
}

TEST(Law, ALongerHorizonKeepsEarlierHits) {
  forEachCase("longer horizon", kLaw, [](Random& random) {
    const Case c = mixedCase(random);
    Case longer = c;
    longer.horizon = std::min(core::kMaxHorizon, c.horizon * random.logUniform(1, 1e3));
    const Answer a = ask(c);
    Answer b = ask(longer);
    if (b && b->time > c.horizon) b = std::nullopt;
    return disagreement(c, a, longer, b);
  });
}

TEST(Law, TheSameAnswerTwice) {
  forEachCase("repeatable", kLaw, [](Random& random) -> std::string {
    const Case c = mixedCase(random);
    const Answer a = ask(c);
    const Answer b = ask(c);
    const bool same = a ? b && a->time == b->time && a->point == b->point : !b;
    return same ? "" : asCode(c);
  });
}

}  // namespace
}  // namespace footprint_collision_predictor::test
