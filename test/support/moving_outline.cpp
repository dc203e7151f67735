#include "moving_outline.hpp"

namespace footprint_collision_predictor::test {
namespace {

Point point(const Vec2& v) { return {v.x(), v.y()}; }
Point left(const Point& v) { return {-v.y, v.x}; }
Point turned(const Point& v, Real cosine, Real sine) { return cosine * v + sine * left(v); }

}  // namespace

MovingOutline::MovingOutline(const FootprintCase& c, const Point& origin)
    : velocity_(point(c.disc.motion.velocity)),
      acceleration_(point(c.disc.motion.acceleration)),
      driving_(point(c.twist.linear)),
      turning_(c.twist.angular),
      radius_(c.disc.radius),
      radius_rate_(c.disc.radius_rate),
      pull_(norm(acceleration_) + std::abs(turning_) * norm(driving_)) {
  const Point centre = point(c.disc.motion.position) - origin;
  for (const Vec2& v : c.outline) vertices_.push_back(centre + point(v));
  if (c.outline.empty()) vertices_.push_back(centre);
}

/// The way of the footprint's origin over ground.
Point MovingOutline::travelled(Real t) const {
  if (turning_ == 0) return t * driving_;
  const Real half = std::sin(turning_ * t / 2);
  return (std::sin(turning_ * t) / turning_) * driving_ +
         (2 * half * half / turning_) * left(driving_);
}

OutlineNow MovingOutline::at(Real t) const {
  const Real cosine = std::cos(turning_ * t);
  const Real sine = std::sin(turning_ * t);
  const Point way = t * velocity_ + (t * t / 2) * acceleration_ - travelled(t);
  const Point velocity = turned(velocity_ + t * acceleration_, cosine, -sine) - driving_;
  OutlineNow now{{}, velocity, radius_ + t * radius_rate_};
  for (const Point& v : vertices_) now.vertices.push_back(turned(v + way, cosine, -sine));
  return now;
}

Point MovingOutline::seenFromFootprint(const Point& vertex, const Point& velocity) const {
  return velocity - turning_ * left(vertex);
}

Real MovingOutline::bendSeenFromFootprint(const Point& vertex, const Point& velocity,
                                          Real dt) const {
  const Real w = std::abs(turning_);
  const Real top_speed = norm(velocity) + dt * pull_;
  return pull_ + w * (2 * top_speed + w * (norm(vertex) + dt * top_speed));
}

Point MovingOutline::seenFromGround(const Point& of_footprint, const Point& velocity) const {
  return velocity - turning_ * left(of_footprint);
}

Real MovingOutline::bendSeenFromGround(const Point& of_footprint) const {
  return pull_ + turning_ * turning_ * norm(of_footprint);
}

}  // namespace footprint_collision_predictor::test
