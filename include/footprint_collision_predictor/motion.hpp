// How obstacles and the footprint move.
#pragma once

#include <cstdint>
#include <stdexcept>

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

/// A valid circular obstacle.
class Obstacle {
 public:
  /// \param motion of the centre over ground, in the footprint's frame at t = 0
  /// \param radius [m] >= 0; 0 is a point
  /// \throws InvalidObstacle for a value that is not finite or beyond kMaxCoordinate, kMaxRate or
  ///     kMaxRadius, and for a negative radius.
  Obstacle(const Motion& motion, double radius);

  const Motion& motion() const { return motion_; }
  double radius() const { return radius_; }
  /// The same obstacle `dt` [s] later, relative to a footprint that has moved on without turning.
  Obstacle after(double dt, const Twist& footprint) const;

 private:
  Motion motion_;
  double radius_;
};

/// The obstacle's motion as seen from the footprint (S1): the footprint stands still, only the
/// obstacle moves. Exact while the footprint does not turn; see turningEffect.
Motion relativeMotion(const Motion& obstacle, const Twist& footprint);

/// How far [m] any point of the footprint can come, within the horizon [s], from where it would be
/// without the yaw rate: an upper bound. 0 for a twist without yaw rate.
double turningEffect(const Polygon& footprint, const Twist& twist, double horizon);

}  // namespace footprint_collision_predictor::core
