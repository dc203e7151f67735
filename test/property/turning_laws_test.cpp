// What turning must have in common with not turning.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "agreement.hpp"
#include "guarantee.hpp"
#include "turning_generators.hpp"

namespace footprint_collision_predictor::test {
namespace {

Case withYawRate(const Case& c, double yaw_rate) {
  Case other = c;
  other.twist.angular = yaw_rate;
  return other;
}

/// No point of the segment is further [m] from where it would be on a straight line.
double offTheLine(const Case& c, double t) {
  const double reach = std::max(c.segment.start.norm(), c.segment.end.norm());
  return std::abs(c.twist.angular) * t * (c.twist.linear.norm() * t / 2 + reach);
}

/// The arc and the straight line.
std::string step(const Case& c) {
  const Case straight = withYawRate(c, 0);
  const Answer a = ask(c);
  const Answer b = ask(straight);
  return disagreement(c, a, straight, b, a ? offTheLine(c, a->time) : 0,
                      b ? offTheLine(c, b->time) : 0);
}

TEST(TurningLaw, WithoutAYawRateItIsTheOtherOverload) {
  forEachCase("yaw rate 0", kLaw, [](Random& random) {
    const Case c = withYawRate(turningOfEveryKind(random), random.chance(0.5) ? 0.0 : -0.0);
    Case standing = c;
    standing.circle = relativeMotion(c.circle, c.twist);
    standing.twist = {};
    const Answer a = core::timeToCollision(c.segment, c.twist, c.disc(), c.horizon);
    return disagreement(c, a, standing, ask(standing));
  });
}

TEST(TurningLaw, AYawRateThatIsAlmostNoneChangesAlmostNothing) {
  forEachCase("yaw rate 1e-12", kLaw, [](Random& random) {
    return step(withYawRate(turningOfEveryKind(random), random.sign() * 1e-12));
  });
}

TEST(TurningLaw, ASmallYawRateChangesLittle) {
  forEachCase("yaw rate 1e-3", kLaw, [](Random& random) {
    return step(withYawRate(turningOfEveryKind(random), random.sign() * 1e-3));
  });
}

TEST(TurningLaw, AYawRateNextToAnotherChangesAlmostNothing) {
  forEachCase("neighbouring yaw rates", kLaw, [](Random& random) {
    const Case c = turningOfEveryKind(random);
    const double w = c.twist.angular;
    const Case next = withYawRate(c, random.chance(0.5) ? ulpsAway(w, 1) : w * (1 + 1e-12));
    const double difference = std::abs(next.twist.angular - w);
    const Answer a = ask(c);
    const Answer b = ask(next);
    // Nor does it depend on the rate by which anything is off.
    const auto off = [&](const Answer& answer) {
      return answer ? offTheLine(withYawRate(c, difference), answer->time) : 0;
    };
    return disagreement(c, a, next, b, off(a), off(b));
  });
}

TEST(TurningLaw, TheReferencePointOfTheTwistDoesNotMatter) {
  forEachCase("other reference point", kLaw, [](Random& random) {
    const Case c = turningOfEveryKind(random);
    const Vec2 by = random.logUniform(1e-2, 1e5) * random.direction();
    return disagreement(c, fromOtherFrame(c, Eigen::Matrix2d::Identity(), by));
  });
}

}  // namespace
}  // namespace footprint_collision_predictor::test
