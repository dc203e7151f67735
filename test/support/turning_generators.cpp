#include "turning_generators.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "growing_generators.hpp"

namespace footprint_collision_predictor::test {
namespace {

/// Who meets: the rest is when, where and how.
struct Setting {
  Segment segment;
  Twist twist;
  double radius;
  double radius_rate;
};

using Kind = Case (*)(const Setting&, Random&);

Vec2 velocityOf(const Vec2& point, const Twist& twist) {
  return twist.linear + twist.angular * core::leftNormal(point);
}

/// In the body's frame; far away without a yaw rate.
Vec2 centreOfRotation(const Twist& twist) {
  const double w = twist.angular;
  return core::leftNormal(twist.linear) / (w == 0 ? 1e-300 : w);
}

Twist turningAbout(const Vec2& centre, double yaw_rate) {
  return {-yaw_rate * core::leftNormal(centre), yaw_rate};
}

Twist anyTwist(const Segment& s, Random& random) {
  const double w = anyYawRate(random);
  const double kind = random.uniform(0, 1);
  if (kind < 0.15) return turningAbout(pointOn(s, random), w);
  if (kind < 0.3) return turningAbout(s.start + random.uniform(0, 3) * random.direction(), w);
  if (kind < 0.4) return {{0, 0}, w};
  return {random.logUniform(1e-3, 10) * random.direction(), w};
}

Setting anySetting(Random& random) {
  const Segment s = anySegment(random);
  return {s, anyTwist(s, random), anyRadius(random), 0};
}

double horizonFor(const Twist& twist, Random& random) {
  const double w = std::abs(twist.angular);
  const double turns = random.uniform(0.1, 6);
  const double most =
      w == 0 ? core::kMaxHorizon : std::min(core::kMaxHorizon, 2 * M_PI * turns / w);
  return random.chance(0.5) && most <= 100 ? most : std::min(most, random.logUniform(0.1, 100));
}

/// At `time` the disc is at that place in the body's frame, and moves so over ground, along the
/// body's axes then.
Case meeting(const Setting& of, const Vec2& place, double time, const Vec2& velocity,
             const Vec2& acceleration, double horizon) {
  const double angle = of.twist.angular * time;
  const Motion motion = leadingTo(carried(place, of.twist, time), time, turned(velocity, angle),
                                  turned(acceleration, angle));
  return {of.segment, motion, of.radius, horizon, of.radius_rate, of.twist};
}

double radiusAt(const Setting& of, double time) { return of.radius + time * of.radius_rate; }

/// A point is led between the ends: that it meets one is left to grazing().
Vec2 anyPlaceInTheWay(const Setting& of, double time, Random& random) {
  const Segment& s = of.segment;
  if (of.radius == 0) return s.start + random.uniform(0, 1) * (s.end - s.start);
  return pointOn(s, random) + random.uniform(0, 1.3) * radiusAt(of, time) * random.direction();
}

Case aimed(const Setting& of, Random& random) {
  const double horizon = horizonFor(of.twist, random);
  const double time = random.uniform(0, 1) * horizon;
  const Vec2 place = anyPlaceInTheWay(of, time, random);
  const Vec2 velocity = random.logUniform(1e-2, 1e2) * random.direction();
  return meeting(of, place, time, velocity, anyVector(random, 1e-6, 10), horizon);
}

Case standing(const Setting& of, Random& random) {
  const double horizon = horizonFor(of.twist, random);
  const double time = random.uniform(0, 1) * horizon;
  return meeting(of, anyPlaceInTheWay(of, time, random), time, {0, 0}, {0, 0}, horizon);
}

/// The way of a pillar is a circle about the centre of rotation: the point of the segment nearest
/// to that is grazed from within or from without.
Case grazingPillar(const Setting& of, Random& random) {
  const Vec2 centre = centreOfRotation(of.twist);
  const Vec2 point = core::closestPoint(of.segment, centre);
  const Vec2 away = point == centre ? random.direction() : (point - centre).normalized();
  const double horizon = horizonFor(of.twist, random);
  const double time = random.uniform(0, 1) * horizon;
  const double reach = almost(radiusAt(of, time), random);
  return meeting(of, point + random.sign() * reach * away, time, {0, 0}, {0, 0}, horizon);
}

Case grazing(const Setting& of, Random& random) {
  if (of.twist.angular != 0 && random.chance(0.5)) return grazingPillar(of, random);
  const Touch touch = anyTouch(of.segment, random);
  const double horizon = horizonFor(of.twist, random);
  const double time = random.uniform(0, 1) * horizon;
  const Vec2 place = touch.point + almost(radiusAt(of, time), random) * touch.outwards;
  const Vec2 alongside =
      random.sign() * random.logUniform(1e-3, 1e2) * core::leftNormal(touch.outwards);
  const Vec2 velocity = velocityOf(place, of.twist) + alongside + of.radius_rate * touch.outwards;
  return meeting(of, place, time, velocity, anyVector(random, 1e-9, 10), horizon);
}

Case sinkingIn(const Setting& of, Random& random) {
  const Segment& s = of.segment;
  const Vec2 outwards = random.sign() * core::leftNormal((s.end - s.start).normalized());
  const Sinking way = anySinking(s, outwards, random);
  const double horizon = horizonFor(of.twist, random);
  const double time = random.uniform(0, 1) * horizon;
  const Vec2 place = way.point + radiusAt(of, time) * outwards;
  const Vec2 velocity = velocityOf(place, of.twist) + of.radius_rate * outwards +
                        random.logUniform(1e-3, 1e2) * way.direction;
  return meeting(of, place, time, velocity, anyVector(random, 1e-9, 10), horizon);
}

Case now(const Setting& of, Random& random) {
  const Touch touch = anyTouch(of.segment, random);
  const double gap = random.chance(0.2) ? 0 : random.sign() * random.logUniform(1e-16, 1e-6);
  const Vec2 place = touch.point + (of.radius + gap) * touch.outwards;
  const Vec2 side = random.sign() * core::leftNormal(touch.outwards);
  const double outwards =
      random.chance(0.5) ? random.uniform(-1, 1) : random.sign() * random.logUniform(1e-16, 1e-1);
  const Vec2 relative = random.logUniform(1e-6, 1e2) * (side + outwards * touch.outwards);
  const Vec2 velocity = velocityOf(place, of.twist) + relative + of.radius_rate * touch.outwards;
  return meeting(of, place, 0, velocity, anyVector(random, 1e-9, 10), horizonFor(of.twist, random));
}

Kind anyKind(Random& random) {
  static const std::array<Kind, 5> kKinds{aimed, standing, grazing, sinkingIn, now};
  return kKinds[static_cast<std::size_t>(random.integer(0, 4))];
}

}  // namespace

Vec2 carried(const Vec2& point, const Twist& twist, double t) {
  const double half = 0.5 * twist.angular * t;
  const double chord = std::abs(half) < 1e-8 ? t : t * std::sin(half) / half;
  return chord * turned(twist.linear, half) + turned(point, 2 * half);
}

Vec2 turned(const Vec2& vector, double angle) {
  return std::cos(angle) * vector + std::sin(angle) * core::leftNormal(vector);
}

double anyYawRate(Random& random) {
  if (random.chance(0.05)) return 0;
  return random.sign() * random.logUniform(random.chance(0.5) ? 1e-12 : 1e-2, 10);
}

Case turningCase(Random& random) { return aimed(anySetting(random), random); }
Case pillar(Random& random) { return standing(anySetting(random), random); }
Case turningGraze(Random& random) { return grazing(anySetting(random), random); }
Case turningSinking(Random& random) {
  Setting setting = anySetting(random);
  if (random.chance(0.5)) setting.radius = 0;
  return sinkingIn(setting, random);
}
Case turningNow(Random& random) { return now(anySetting(random), random); }

Case turningOfEveryKind(Random& random) {
  const Setting setting = anySetting(random);
  return anyKind(random)(setting, random);
}

Case turningAndGrowing(Random& random) {
  Setting setting = anySetting(random);
  setting.radius_rate = anyRadiusRate(random);
  return anyKind(random)(setting, random);
}

Case turningFarFromOrigin(Random& random) {
  double away = random.logUniform(1e3, 1e6);
  if (random.chance(0.5)) {
    const Case c = turningOfEveryKind(random);
    away = std::min(away, core::kMaxRate / std::abs(c.twist.angular));
    return fromOtherFrame(c, Eigen::Matrix2d::Identity(), away * random.direction());
  }
  const Vec2 by = away * random.direction();
  Setting setting = anySetting(random);
  setting.segment = {setting.segment.start + by, setting.segment.end + by};
  setting.twist = {random.uniform(0, 10) * random.direction(),
                   random.sign() * random.logUniform(1e-12, 1e2) / away};
  return anyKind(random)(setting, random);
}

Case fromOtherFrame(const Case& c, const Eigen::Matrix2d& turn, const Vec2& by) {
  Case other = c;
  other.segment = {turn * c.segment.start + by, turn * c.segment.end + by};
  other.circle = {turn * c.circle.position + by, turn * c.circle.velocity,
                  turn * c.circle.acceleration};
  other.twist.angular =
      core::cross(turn.col(0), turn.col(1)) < 0 ? -c.twist.angular : c.twist.angular;
  other.twist.linear = turn * c.twist.linear - other.twist.angular * core::leftNormal(by);
  return other;
}

}  // namespace footprint_collision_predictor::test
