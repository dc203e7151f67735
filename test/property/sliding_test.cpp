// Moving along the segment: parallel at about the radius, and end-on in its line.
#include <gtest/gtest.h>

#include "generators.hpp"
#include "guarantee.hpp"

namespace footprint_collision_predictor::test {
namespace {

/// A motion along the segment's line, `across` away from it.
Case alongTheLine(Random& random, double radius, double across) {
  const Segment s = anySegment(random);
  const Vec2 along = (s.end - s.start).normalized();
  const double length = (s.end - s.start).norm();
  const double from = random.uniform(-3, 4) * length;
  const Vec2 position = s.start + from * along + across * core::leftNormal(along);
  const double speed = random.sign() * random.logUniform(1e-6, 1e2);
  const double acceleration = random.chance(0.5) ? 0 : random.logUniform(1e-9, 10);
  return {s,
          {position, speed * along, random.sign() * acceleration * along},
          radius,
          random.logUniform(0.1, core::kMaxHorizon)};
}

TEST(Sliding, ParallelHoldsTheGuarantee) {
  runSuite("parallel sliding", kSpecial, [](Random& random) {
    const double radius = random.chance(0.1) ? 0 : random.logUniform(1e-2, 1e2);
    const double across = random.chance(0.5)
                              ? ulpsAway(radius, random.integer(-4, 4))
                              : radius + random.sign() * random.logUniform(1e-16, 1e-3);
    return alongTheLine(random, radius, random.sign() * across);
  });
}

TEST(Sliding, EndOnHoldsTheGuarantee) {
  runSuite("collinear, end-on", kSpecial, [](Random& random) {
    const double radius = random.chance(0.3) ? 0 : random.logUniform(1e-6, 1e1);
    const double across = random.chance(0.5) ? 0 : random.logUniform(1e-17, 1e-9);
    return alongTheLine(random, radius, across);
  });
}

}  // namespace
}  // namespace footprint_collision_predictor::test
