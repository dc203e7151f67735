#include "footprint_generators.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "footprint_oracle.hpp"
#include "generators.hpp"

namespace footprint_collision_predictor::test {
namespace {

std::vector<Vec2> anyCorners(Random& random, double size) {
  const int corners = random.integer(3, 8);
  const double smallest = random.chance(0.5) ? 0.8 : 0.1;  // of the size: round, or a star
  std::vector<Vec2> vertices;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * M_PI * (i + random.uniform(0, 0.5)) / corners;
    vertices.push_back(size * random.uniform(smallest, 1) * Vec2{std::cos(angle), std::sin(angle)});
  }
  if (random.chance(0.5)) std::reverse(vertices.begin(), vertices.end());
  return vertices;
}

std::vector<Vec2> anyRectangle(Random& random, double size) {
  const double x = random.uniform(0.3, 1) * size;
  const double y = random.uniform(0.3, 1) * size;
  return {{-x, -y}, {x, -y}, {x, y}, {-x, y}};
}

/// Some 9 to 40 corners on an ellipse.
std::vector<Vec2> anyRound(Random& random, double size) {
  const int corners = random.integer(9, 40);
  const double width = random.uniform(0.3, 1);
  std::vector<Vec2> vertices;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * M_PI * (i + random.uniform(0, 0.5)) / corners;
    vertices.push_back(size * Vec2{std::cos(angle), width * std::sin(angle)});
  }
  return vertices;
}

/// A triangle that is as acute as 1e-6 rad.
std::vector<Vec2> anySliver(Random& random, double size) {
  const double angle = random.angle();
  const double apex = random.logUniform(1e-6, 1e-1);
  return {{0, 0},
          size * Vec2{std::cos(angle), std::sin(angle)},
          random.uniform(0.5, 1) * size * Vec2{std::cos(angle + apex), std::sin(angle + apex)}};
}

/// One more vertex, in the middle of a side or very near to a corner: straight, but for rounding.
void splitSide(std::vector<Vec2>* vertices, Random& random) {
  const int last = static_cast<int>(vertices->size()) - 1;
  const auto i = static_cast<std::size_t>(random.integer(0, last));
  const double share = random.chance(0.5) ? 0.5 : random.logUniform(1e-9, 1e-2);
  const Vec2 start = (*vertices)[i], end = (*vertices)[(i + 1) % vertices->size()];
  vertices->insert(vertices->begin() + static_cast<std::ptrdiff_t>(i) + 1,
                   start + share * (end - start));
}

Vec2 vec(const Point& p) { return {static_cast<double>(p.x), static_cast<double>(p.y)}; }
Vec2 turned(const Vec2& v, double angle) { return Eigen::Rotation2Dd(angle) * v; }

/// Of the footprint's origin over ground.
Vec2 travelled(const core::Twist& twist, double t) {
  const double w = twist.angular;
  if (w == 0) return t * twist.linear;
  const double half = std::sin(w * t / 2);
  return std::sin(w * t) / w * twist.linear + 2 * half * half / w * core::leftNormal(twist.linear);
}

/// How an obstacle moves that is at `place` at time t, with `point` of it passing with `velocity`:
/// all as seen from the footprint, in its frame.
core::Motion motionThrough(const Vec2& place, const Vec2& point, const Vec2& velocity, double t,
                           const core::Twist& twist, const Vec2& acceleration) {
  const double angle = twist.angular * t;
  const Vec2 carried = twist.linear + twist.angular * core::leftNormal(point);
  const Vec2 then = turned(velocity + carried, angle);  // over ground
  const Vec2 position = travelled(twist, t) + turned(place, angle);
  return {position - t * (then - (0.5 * t) * acceleration), then - t * acceleration, acceleration};
}

double anyRadius(Random& random, bool needed) {
  return random.chance(needed ? 0.1 : 0.4) ? 0 : random.logUniform(1e-2, 5);
}

struct Side {
  core::Edge edge;
  Vec2 outwards;
};

Side anySide(const std::vector<Vec2>& vertices, Random& random) {
  const core::Polygon footprint(vertices);
  const int last = static_cast<int>(footprint.size()) - 1;
  const core::Edge& edge = footprint.segment(static_cast<std::size_t>(random.integer(0, last)));
  const Vec2 left = core::leftNormal(edge.tangent);
  return {edge, footprint.isCounterClockwise() ? Vec2(-left) : left};
}

Vec2 anyAcceleration(Random& random) { return random.logUniform(1e-6, 5) * random.direction(); }

/// Without the disc's motion.
FootprintCase anyShapes(Random& random, const Moves& moves) {
  FootprintCase c;
  c.footprint = anyFootprint(random);
  c.twist = anyTwist(random, moves.turns);
  if (moves.has_outline) c.outline = anyOutline(random);
  c.disc = {{{0, 0}, {0, 0}, {0, 0}}, anyRadius(random, !moves.has_outline), 0};
  if (moves.grows) c.disc.radius_rate = random.logUniform(1e-4, 1);
  c.horizon = random.logUniform(0.1, 20);
  if (std::abs(c.twist.angular) > 1) c.horizon = std::min(c.horizon, 10 / c.twist.angular);
  c.horizon = std::abs(c.horizon);
  return c;
}

/// The two as they stand when the obstacle is there.
FootprintOracle standing(FootprintCase c, const Vec2& place) {
  c.twist = {{0, 0}, 0};
  c.disc = {{place, {0, 0}, {0, 0}}, c.disc.radius, 0};
  return FootprintOracle(c);
}

/// Comes from afar in a straight line until the gap is as wanted.
Vec2 placeWithGap(const FootprintCase& c, double wanted, Random& random) {
  const Vec2 from = random.direction();
  const Vec2 aim = random.uniform(0, 1) * random.direction();
  double away = 60 + c.disc.radius;
  for (int i = 0; i < 40; ++i) {
    const double more = static_cast<double>(standing(c, aim + away * from).gap(0)) - wanted;
    away -= more;
    if (std::abs(more) < 1e-16 * away || away < 0) break;  // there, or past it
  }
  return aim + away * from;
}

double anyHair(Random& random) {
  return random.chance(0.1) ? 0 : random.sign() * random.logUniform(1e-15, 1e-3);
}

}  // namespace

std::vector<Vec2> anyFootprint(Random& random) {
  const double size = random.logUniform(0.1, 3);
  const double kind = random.uniform(0, 1);
  std::vector<Vec2> vertices = kind < 0.3    ? anyRectangle(random, size)
                               : kind < 0.35 ? anyRound(random, size)
                               : kind < 0.45 ? anySliver(random, size)
                                             : anyCorners(random, size);
  if (random.chance(0.2)) splitSide(&vertices, random);
  const Vec2 middle =
      random.chance(0.5) ? Vec2(0, 0) : Vec2(random.uniform(0, 3) * random.direction());
  for (Vec2& v : vertices) v += middle;
  return vertices;
}

std::vector<Vec2> anyOutline(Random& random) {
  const double size = random.logUniform(1e-2, 20);
  const double kind = random.uniform(0, 1);
  std::vector<Vec2> vertices;
  if (kind < 0.4) {
    const Vec2 half = size * random.direction();
    vertices = {-half, half};
  } else {
    vertices = kind < 0.6 ? anyRectangle(random, size) : anyCorners(random, size);
  }
  const bool axis_aligned = random.chance(0.3);
  const double angle = axis_aligned ? 0 : random.angle();
  const Vec2 off =
      random.chance(0.5) ? Vec2(0, 0) : Vec2(random.uniform(0, 5) * random.direction());
  for (Vec2& v : vertices) v = turned(v, angle) + off;
  return vertices;
}

core::Twist anyTwist(Random& random, bool turns) {
  const Vec2 linear =
      random.chance(0.2) ? Vec2(0, 0) : Vec2(random.logUniform(1e-3, 5) * random.direction());
  return {linear, turns ? random.sign() * random.logUniform(1e-4, 10) : 0};
}

FootprintCase anyFootprintCase(Random& random, const Moves& moves) {
  FootprintCase c = anyShapes(random, moves);
  const Vec2 acceleration = moves.accelerates ? anyAcceleration(random) : Vec2(0, 0);
  const double when = random.uniform(0, 1.2) * c.horizon;
  const Vec2 aim = random.uniform(0, random.chance(0.8) ? 2 : 20) * random.direction();
  // Mostly so fast that at t = 0 it was elsewhere.
  const double speed = random.chance(0.7) ? random.uniform(2, 40) / std::max(when, 0.1)
                                          : random.logUniform(1e-3, 10);
  const Vec2 velocity = random.chance(0.05) ? Vec2(0, 0) : Vec2(speed * random.direction());
  c.disc.motion = motionThrough(aim, aim, velocity, when, c.twist, acceleration);
  return c;
}

FootprintCase grazingFootprint(Random& random, const Moves& moves) {
  FootprintCase c = anyShapes(random, moves);
  const Vec2 acceleration = moves.accelerates ? anyAcceleration(random) : Vec2(0, 0);
  const double when = random.uniform(0, 1) * c.horizon;
  FootprintCase then = c;
  then.disc.radius = c.disc.radiusAt(when);
  const Vec2 place = placeWithGap(then, anyHair(random), random);
  const Line way = standing(then, place).shortestLine(0);
  const Vec2 outwards = vec(way.end - way.start).normalized();
  const double inwards = random.chance(0.4) ? 0 : random.sign() * random.logUniform(1e-12, 1);
  const Vec2 velocity = random.logUniform(1e-3, 10) *
                        (random.sign() * core::leftNormal(outwards) - inwards * outwards);
  c.disc.motion = motionThrough(place, vec(way.end), velocity, when, c.twist, acceleration);
  return c;
}

FootprintCase sinkingFootprint(Random& random, const Moves& moves) {
  FootprintCase c = anyShapes(random, moves);
  c.outline.clear();
  if (random.chance(0.5)) c.disc.radius = 0;
  const Vec2 acceleration = moves.accelerates ? anyAcceleration(random) : Vec2(0, 0);
  const double when = random.uniform(0, 1) * c.horizon;
  const auto [side, outwards] = anySide(c.footprint, random);
  const Sinking way = anySinking(side, outwards, random);
  const Vec2 velocity = random.logUniform(1e-3, 10) * way.direction + c.disc.radius_rate * outwards;
  c.disc.motion = motionThrough(way.point + c.disc.radiusAt(when) * outwards, way.point, velocity,
                                when, c.twist, acceleration);
  return c;
}

FootprintCase touchingSideNow(Random& random) {
  FootprintCase c = anyShapes(random, {false, random.chance(0.2), random.chance(0.6), false});
  if (random.chance(0.5)) c.footprint = anySliver(random, random.logUniform(1e-2, 10));
  if (random.chance(0.6)) c.disc.radius = 0;
  const auto [side, outwards] = anySide(c.footprint, random);
  const double beside = random.chance(0.3) ? 0 : random.sign() * random.logUniform(1e-20, 1e-12);
  const Vec2 place =
      side.start + random.uniform(0, 1) * side.length * side.tangent + beside * outwards;
  if (random.chance(0.5)) {
    const Vec2 from_position = random.uniform(0, 1) * random.direction();
    const Vec2 way = random.logUniform(1e-3, 3) * (outwards + random.uniform(-2, 2) * side.tangent);
    c.outline = {from_position, from_position + way};
  }
  const Vec2 position =
      place + c.disc.radius * outwards - (c.outline.empty() ? Vec2(0, 0) : c.outline.front());
  if (random.chance(0.5)) c.twist.linear.setZero();
  const Vec2 velocity = random.chance(0.5) ? Vec2(0, 0) : anyAcceleration(random);
  c.disc.motion = {position, velocity, random.chance(0.5) ? Vec2(0, 0) : anyAcceleration(random)};
  return c;
}

FootprintCase inLineWithASide(Random& random) {
  FootprintCase c = anyShapes(random, {});
  if (random.chance(0.7)) c.disc.radius = 0;
  const core::Edge side = anySide(c.footprint, random).edge;
  const auto onLine = [&](double share) {
    return Vec2(side.start + share * side.length * side.tangent);
  };
  const double share = random.uniform(-4, 4);
  const Vec2 position = random.uniform(0, 3) * random.direction();
  c.outline = {onLine(share) - position, onLine(share + random.uniform(0.1, 3)) - position};
  if (random.chance(0.3)) c.outline.push_back(random.uniform(1, 3) * random.direction());
  const double speed = random.chance(0.5) ? 0 : random.sign() * random.logUniform(1e-3, 1);
  c.twist.linear.setZero();
  c.disc.motion = {position, speed * side.tangent, {0, 0}};
  return c;
}

bool isFootprint(const std::vector<Vec2>& vertices) {
  try {
    core::Polygon{vertices};
    return true;
  } catch (const core::InvalidPolygon&) {
    return false;
  }
}

FootprintCase outlineToldFromAfar(const FootprintCase& c, const Vec2& by) {
  FootprintCase other = c;
  other.disc.motion.position += by;
  for (Vec2& v : other.outline) v -= by;
  return other;
}

FootprintCase scaled(const FootprintCase& c, double length, double time) {
  FootprintCase other = c;
  for (Vec2& v : other.footprint) v *= length;
  for (Vec2& v : other.outline) v *= length;
  const double speed = length / time;
  other.twist = {speed * c.twist.linear, c.twist.angular / time};
  const core::Motion& m = c.disc.motion;
  other.disc = {{length * m.position, speed * m.velocity, speed / time * m.acceleration},
                length * c.disc.radius,
                speed * c.disc.radius_rate};
  other.horizon = std::min(core::kMaxHorizon, time * c.horizon);
  return other;
}

FootprintCase translated(const FootprintCase& c, const Vec2& by) {
  FootprintCase other = c;
  for (Vec2& v : other.footprint) v += by;
  other.disc.motion.position += by;
  return other;
}

}  // namespace footprint_collision_predictor::test
