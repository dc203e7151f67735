// How obstacles and the footprint move.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <vector>

#include "footprint_collision_predictor/polygon.hpp"

namespace footprint_collision_predictor::core {

/// Largest radius of an obstacle [m].
constexpr double kMaxRadius = 1e6;
/// Largest component of a velocity [m/s] or acceleration [m/s^2].
constexpr double kMaxRate = 1e6;
/// Longest time to look ahead [s].
constexpr double kMaxHorizon = 3600;

/// A point moving with constant acceleration, held for ever, also through a stop.
struct Motion {
  Vec2 position;      ///< [m] at t = 0
  Vec2 velocity;      ///< [m/s] at t = 0
  Vec2 acceleration;  ///< [m/s^2]

  Vec2 positionAt(double t) const { return position + t * (velocity + (0.5 * t) * acceleration); }
  Vec2 velocityAt(double t) const { return velocity + t * acceleration; }
};

/// Planar velocity of a footprint over ground, constant as felt on board.
struct Twist {
  Vec2 linear{0, 0};   ///< [m/s] of the frame's origin, along the axes of the footprint's frame
  double angular = 0;  ///< yaw rate [rad/s], counter-clockwise positive
};

/// Thrown for obstacle values that are refused; what() names the field, the value and the limit.
class InvalidObstacle : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

/// A circle that moves and may grow: its radius is radius + radius_rate t.
struct Disc {
  Motion motion;           ///< of the centre
  double radius;           ///< [m] >= 0 at t = 0
  double radius_rate = 0;  ///< [m/s] >= 0

  double radiusAt(double t) const { return radius + radius_rate * t; }
};

/// A valid obstacle: a disc, or a line or polygon (its outline) rounded by the disc's radius.
class Obstacle {
 public:
  /// \param motion of the centre over ground, in the footprint's frame at t = 0
  /// \param radius [m] >= 0 at t = 0; 0 is a point
  /// \param radius_rate [m/s] >= 0, by which the radius grows
  /// \param outline [m] relative to the centre, moving with it without turning: empty for a circle,
  ///     2 vertices for a line, more for a closed polygon in either winding
  /// \throws InvalidObstacle for a value that is not finite or beyond kMaxCoordinate, kMaxRate or
  ///     kMaxRadius, for a negative radius or radius_rate, and for an outline of 1 vertex.
  Obstacle(const Motion& motion, double radius, double radius_rate = 0,
           std::vector<Vec2> outline = {});

  const Disc& disc() const { return disc_; }
  const Motion& motion() const { return disc_.motion; }
  double radius() const { return disc_.radius; }
  const std::vector<Vec2>& outline() const { return outline_; }
  /// [m] of the circle about the position that holds it all at t = 0
  double boundingRadius() const { return disc_.radius + farthest_vertex_; }
  /// The same obstacle `dt` [s] later, as seen from a footprint that has moved on for so long.
  Obstacle after(double dt, const Twist& footprint) const;

 private:
  Disc disc_;
  std::vector<Vec2> outline_;
  double farthest_vertex_ = 0;  ///< [m] from the position
};

/// Where the frame's origin is `dt` [s] later [m], in the axes of now: along a straight line or an
/// arc.
Vec2 displacement(const Twist& twist, double dt);

/// The same motion of the body, told for another of its points: the twist of a frame with its
/// origin there and the same axes.
Twist atPoint(const Vec2& point, const Twist& twist);

/// The obstacle's motion as seen from the footprint (S1): the footprint stands still, only the
/// obstacle moves. Exact while the footprint does not turn.
Motion relativeMotion(const Motion& obstacle, const Twist& footprint);

}  // namespace footprint_collision_predictor::core
