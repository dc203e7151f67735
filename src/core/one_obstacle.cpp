// A footprint and a single obstacle. Most obstacles cannot touch it, and nothing is set up for
// those.
#include <vector>

#include "broad_phase.hpp"
#include "chord.hpp"
#include "footprint_collision_predictor/predictor.hpp"
#include "narrow_phase.hpp"
#include "path.hpp"
#include "rounding.hpp"
#include "shape.hpp"
#include "swept_footprint.hpp"

namespace footprint_collision_predictor::core {
namespace {

/// Whether nothing turns, accelerates or grows.
bool isStraight(const Twist& twist, const Disc& disc) {
  return twist.angular == 0 && disc.motion.acceleration.x() == 0 &&
         disc.motion.acceleration.y() == 0 && disc.radius_rate == 0;
}

bool mayTouchStraight(const Polygon& footprint, const Twist& twist, const Obstacle& obstacle,
                      double horizon) {
  const Vec2 p = obstacle.motion().position - footprint.centroid();
  const Vec2 v = obstacle.motion().velocity - twist.linear;
  const double reach = obstacle.boundingRadius() + footprint.boundingRadius();
  return mayTouch(Chord<double>{p.x(), p.y(), v.x(), v.y(), reach}, horizon);
}

/// By a single window.
bool mayTouch(const Polygon& footprint, const Twist& twist, const Obstacle& obstacle,
              double horizon) {
  const Motion& m = obstacle.motion();
  const Vec2 p = m.position - footprint.centroid();
  Vec2 own = twist.linear;
  double acceleration = m.acceleration.lpNorm<1>();
  double rounding = kGenerous * footprint.boundingRadius();
  if (twist.angular != 0) {
    own = atPoint(footprint.centroid(), twist).linear;
    acceleration += std::abs(twist.angular) * own.norm();
    own = Turn(twist.angular * horizon).displacement(own);
    rounding += kGenerous * std::abs(twist.angular) * horizon * footprint.centroid().lpNorm<1>() +
                kGenerous * horizon * own.norm() + kTurningTolerance;
  }
  const Vec2 v = m.velocity - own + 0.5 * horizon * m.acceleration;
  const double bulge = 0.125 * horizon * horizon * acceleration;
  const double reach = obstacle.boundingRadius() + footprint.boundingRadius() + bulge + rounding;
  const Chord<double> chord{p.x(), p.y(), v.x(), v.y(), reach};
  return mayTouch(chord, obstacle.disc().radius_rate, horizon);
}

/// With an obstacle that may touch.
std::optional<FootprintContact> firstContactOf(const Polygon& footprint, const Twist& twist,
                                               const Shape& shape, double bounding_radius,
                                               double horizon) {
  if (mayComeWithin(0, footprint, shape.disc, bounding_radius)) {
    const Nearest nearest = nearestNow(footprint, shape);
    if (nearest.gap <= 0) return contactNow(footprint, twist, shape, nearest);
  }
  if (!footprint.isConvex() || shape.outline.size > 0) {
    // Segment by segment takes long; circles before a convex footprint have their own quick look.
    const double acceleration = shape.disc.motion.acceleration.norm();
    const SweptFootprint swept(footprint, twist, horizon, acceleration);
    if (!mayComeWithin(0, swept, shape.disc, bounding_radius)) return std::nullopt;
  }
  const auto touch = firstTouch(footprint, twist, shape, horizon, horizon);
  if (!touch) return std::nullopt;
  return contactLater(footprint, twist, shape, *touch);
}

/// Apart, so that those that cannot touch are soon done with.
[[gnu::noinline]] std::optional<FootprintContact> firstContactOf(const Polygon& footprint,
                                                                 const Twist& twist,
                                                                 const Obstacle& obstacle,
                                                                 double horizon) {
  const double bounding_radius = obstacle.boundingRadius();
  if (obstacle.outline().empty())
    return firstContactOf(footprint, twist, Shape{obstacle.disc(), {}}, bounding_radius, horizon);
  std::vector<Edge> edges;
  appendOutline(obstacle, &edges);
  const Shape shape{obstacle.disc(), {edges.data(), edges.size()}};
  return firstContactOf(footprint, twist, shape, bounding_radius, horizon);
}

[[gnu::noinline]] std::optional<FootprintContact> firstContactBent(const Polygon& footprint,
                                                                   const Twist& twist,
                                                                   const Obstacle& obstacle,
                                                                   double horizon) {
  if (!mayTouch(footprint, twist, obstacle, horizon)) return std::nullopt;
  return firstContactOf(footprint, twist, obstacle, horizon);
}

}  // namespace

std::optional<FootprintContact> firstContact(const Polygon& footprint, const Twist& twist,
                                             const Obstacle& obstacle, double horizon) {
  if (!isStraight(twist, obstacle.disc()))
    return firstContactBent(footprint, twist, obstacle, horizon);
  if (!mayTouchStraight(footprint, twist, obstacle, horizon)) return std::nullopt;
  return firstContactOf(footprint, twist, obstacle, horizon);
}

}  // namespace footprint_collision_predictor::core
