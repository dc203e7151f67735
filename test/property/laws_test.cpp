// What must hold between two questions, whatever the answers are.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "generators.hpp"
#include "guarantee.hpp"
#include "oracle.hpp"

namespace footprint_collision_predictor::test {
namespace {

using Answer = std::optional<core::Contact>;

Case mixedCase(Random& random) {
  const double kind = random.uniform(0, 1);
  if (kind < 0.5) return anyCase(random);
  return kind < 0.75 ? grazingEnd(random) : touchingNow(random);
}

bool notLater(const Answer& answer, double time) {
  return answer && answer->time <= time + 1e-9 * std::max(1.0, time);
}

/// The other case reported contact at `time`; this one did so later, or not at all. That is right
/// only in a graze: nothing touches yet, but by a hair.
bool hairIsLeft(const Case& c, double time) {
  const Quad gap = trueGap(c, time);
  return gap > 0 && gap <= Quad(1e-9 * std::max(1.0, sizeOfCoordinates(c, time)));
}

/// Both touch at the same time or neither does, within the guarantee.
std::string disagreement(const Case& one, const Answer& a, const Case& other, const Answer& b) {
  if (!a && !b) return "";
  const bool fine = (!a || notLater(b, a->time) || hairIsLeft(other, a->time)) &&
                    (!b || notLater(a, b->time) || hairIsLeft(one, b->time));
  return fine ? "" : asCode(one) + "\nand\n" + asCode(other);
}

std::string disagreement(const Case& one, const Case& other) {
  return disagreement(one, ask(one), other, ask(other));
}

Case moved(const Case& c, const Eigen::Matrix2d& turn, const Vec2& by) {
  const Motion& m = c.circle;
  return {{turn * c.segment.start + by, turn * c.segment.end + by},
          {turn * m.position + by, turn * m.velocity, turn * m.acceleration},
          c.radius,
          c.horizon};
}

TEST(Law, RigidMotionsAndMirrorsChangeNothing) {
  forEachCase("rigid motion", kLaw, [](Random& random) {
    const Case c = mixedCase(random);
    Eigen::Matrix2d turn = Eigen::Rotation2Dd(random.angle()).toRotationMatrix();
    if (random.chance(0.5)) turn.col(0) = -turn.col(0);
    return disagreement(c, moved(c, turn, random.uniform(0, 10) * random.direction()));
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
    // The nearest point moves no faster than the centre.
    const double later = std::max(a->time, b->time);
    const double speed = c.circle.velocity.norm() + later * c.circle.acceleration.norm();
    const double moved_by = speed * std::abs(a->time - b->time);
    const double rounding = 2e-9 * std::max(1.0, sizeOfCoordinates(c, later));
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
      if (part && !notLater(whole, part->time) && !hairIsLeft(c, part->time))
        return "whole\n" + asCode(c) + "\nfirst part\n" + asCode(first);
    if (!whole || notLater(a, whole->time) || notLater(b, whole->time)) return std::string();
    const bool hair = hairIsLeft(first, whole->time) || hairIsLeft(second, whole->time);
    return hair ? "" : "parts\n" + asCode(first) + "\nand\n" + asCode(second);
  });
}

TEST(Law, ALargerCircleIsNeverLater) {
  forEachCase("larger radius", kLaw, [](Random& random) -> std::string {
    const Case c = mixedCase(random);
    Case larger = c;
    larger.radius += random.chance(0.2) ? 0 : random.logUniform(1e-16, 1e2);
    const Answer a = ask(c);
    if (!a || notLater(ask(larger), a->time) || hairIsLeft(larger, a->time)) return "";
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
