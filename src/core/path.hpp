// How one point moves as seen from another body, for what follows a path step by step. Each kind of
// path can tell where the point is and bound how hard it may be bent towards something.
#pragma once

#include <algorithm>
#include <cmath>

#include "footprint_collision_predictor/motion.hpp"

namespace footprint_collision_predictor::core {

/// The state of a moving point at one moment.
struct PathState {
  Vec2 position;      ///< [m]
  Vec2 velocity;      ///< [m/s]
  Vec2 acceleration;  ///< [m/s^2]
};

/// A turn about the origin by an angle [rad], for several vectors.
class Turn {
 public:
  explicit Turn(double angle) : half_(0.5 * angle) {
    if (angle == 0) return;
    // Both of the half angle: the displacement needs them too.
    half_sine_ = std::sin(half_);
    half_cosine_ = std::cos(half_);
    sine_ = 2 * half_sine_ * half_cosine_;
    cosine_ = 1 - 2 * half_sine_ * half_sine_;
  }

  Vec2 operator()(const Vec2& v) const {
    if (half_ == 0) return v;
    return {cosine_ * v.x() - sine_ * v.y(), sine_ * v.x() + cosine_ * v.y()};
  }
  Vec2 back(const Vec2& v) const {
    if (half_ == 0) return v;
    return {cosine_ * v.x() + sine_ * v.y(), cosine_ * v.y() - sine_ * v.x()};
  }
  /// Where something comes that moves on by `way` [m] while it makes this turn evenly. The mean
  /// direction is that of half the turn, and the chord is shorter than the arc by sin(x) / x: no
  /// difference of near numbers, however small the turn.
  Vec2 displacement(const Vec2& way) const {
    if (half_ == 0) return way;
    const double shortening = half_sine_ / half_;
    return {shortening * (half_cosine_ * way.x() - half_sine_ * way.y()),
            shortening * (half_sine_ * way.x() + half_cosine_ * way.y())};
  }

 private:
  double half_;
  double half_sine_ = 0, half_cosine_ = 1;
  double sine_ = 0, cosine_ = 1;
};

/// No less than how far [m] from its start a point with that twist, which turns, gets until t.
inline double longestChord(const Twist& twist, double t) {
  return std::min(t, 2 / std::abs(twist.angular)) * twist.linear.lpNorm<1>();
}

/// Constant acceleration, held for ever: as seen from a body that does not turn.
class StraightPath {
 public:
  explicit StraightPath(const Motion& motion) : motion_(motion) {}

  PathState at(double t) const {
    return {motion_.positionAt(t), motion_.velocityAt(t), motion_.acceleration};
  }
  /// [m] all that is added up until t, for the allowance for rounding.
  double sizeAt(double t) const {
    return motion_.position.lpNorm<1>() +
           t * (motion_.velocity.lpNorm<1>() + 0.5 * t * motion_.acceleration.lpNorm<1>());
  }
  /// Largest a [m/s^2] of which is certain that for s in [0, window] the point gets at least as far
  /// along the direction as direction.(position + s velocity) + a s^2 / 2.
  double lowestAcceleration(const PathState&, const Vec2& direction, double /*window*/) const {
    return direction.dot(motion_.acceleration);
  }
  /// A direction fixed to the body is one fixed over ground.
  static constexpr bool kBodyTurns = false;

 private:
  Motion motion_;
};

/// A point that moves over ground with constant acceleration, as seen from a body that turns: with
/// p(t) the point and s(t) the body over ground, q(t) = R(-w t) (p(t) - s(t)).
class PathSeenFromTurningBody {
 public:
  /// \param motion over ground, in the body's frame at t = 0
  /// \param body twist of the body's origin
  PathSeenFromTurningBody(const Motion& motion, const Twist& body)
      : motion_(motion),
        body_(body),
        acceleration_(motion.acceleration.norm()),
        body_speed_(body.linear.norm()) {}

  PathState at(double t) const {
    const double w = body_.angular;
    const Turn turn(w * t);
    PathState state;
    state.position = turn.back(motion_.positionAt(t) - turn.displacement(t * body_.linear));
    const Vec2 velocity = turn.back(motion_.velocityAt(t));  // over ground
    state.velocity = velocity - body_.linear - w * leftNormal(state.position);
    state.acceleration =
        turn.back(motion_.acceleration) - w * leftNormal(velocity + state.velocity);
    return state;
  }
  double sizeAt(double t) const {
    const double path =
        motion_.position.lpNorm<1>() +
        t * (motion_.velocity.lpNorm<1>() + 0.5 * t * motion_.acceleration.lpNorm<1>()) +
        longestChord(body_, t);
    return path * (1 + std::abs(body_.angular) * t);  // the angle itself is rounded
  }
  /// From the state's own acceleration and a bound on how fast it changes, or from a bound on the
  /// acceleration itself, whichever says more.
  double lowestAcceleration(const PathState& state, const Vec2& direction, double window) const {
    const double w = std::abs(body_.angular);
    const double a = acceleration_, travel = body_speed_;
    // Largest values within the window.
    const double now = (state.velocity + body_.linear + body_.angular * leftNormal(state.position))
                           .norm();  // speed over ground
    const double speed = now + a * window;
    const double distance = state.position.norm() + window * (now + travel + 0.5 * a * window);
    const double acceleration = a + w * (2 * speed + travel + w * distance);
    const double jerk = w * (3 * a + w * (3 * speed + travel + w * distance));
    return std::max(-acceleration, direction.dot(state.acceleration) - jerk * window / 3);
  }

  static constexpr bool kBodyTurns = true;
  /// [s] that the body takes to turn by this angle [rad]
  double timeToTurn(double angle) const { return angle / std::abs(body_.angular); }
  /// The same as lowestAcceleration() from a point of the body and along a direction that is fixed
  /// over ground: that leaves only how the point of the body is carried round, however far away the
  /// other is. \param from [m] the point of the body, \param direction along the body's axes now
  double lowestAccelerationOverGround(const Vec2& from, const PathState& state,
                                      const Vec2& direction, double window) const {
    const double w = body_.angular;
    const Vec2 velocity = body_.linear + w * leftNormal(from);
    const double bend = std::abs(w) * velocity.norm();
    const Vec2 over_ground = state.acceleration + w * leftNormal(2 * state.velocity + body_.linear +
                                                                 w * leftNormal(state.position));
    return std::max(
        direction.dot(over_ground) - bend,
        direction.dot(over_ground - w * leftNormal(velocity)) - std::abs(w) * bend * window / 3);
  }

 private:
  Motion motion_;
  Twist body_;
  double acceleration_;  ///< [m/s^2] over ground
  double body_speed_;    ///< [m/s]
};

/// A point fixed on a body that turns, as seen from something that moves over ground with constant
/// acceleration and does not turn.
class PathOfTurningPoint {
 public:
  /// \param seen_from motion over ground relative to where the point is at t = 0
  /// \param point twist of the body at the point
  PathOfTurningPoint(const Motion& seen_from, const Twist& point)
      : seen_from_(seen_from),
        point_(point),
        bend_(std::abs(point.angular) * point.linear.norm()) {}

  PathState at(double t) const {
    const double w = point_.angular;
    const Turn turn(w * t);
    const Vec2 velocity = turn(point_.linear);
    return {turn.displacement(t * point_.linear) - seen_from_.positionAt(t),
            velocity - seen_from_.velocityAt(t),
            w * leftNormal(velocity) - seen_from_.acceleration};
  }
  double sizeAt(double t) const {
    return seen_from_.position.lpNorm<1>() +
           t * (seen_from_.velocity.lpNorm<1>() + 0.5 * t * seen_from_.acceleration.lpNorm<1>()) +
           longestChord(point_, t) * (1 + std::abs(point_.angular) * t);
  }
  double lowestAcceleration(const PathState& state, const Vec2& direction, double window) const {
    const double jerk = std::abs(point_.angular) * bend_;
    return std::max(-direction.dot(seen_from_.acceleration) - bend_,
                    direction.dot(state.acceleration) - jerk * window / 3);
  }
  static constexpr bool kBodyTurns = false;

 private:
  Motion seen_from_;
  Twist point_;
  double bend_;  ///< [m/s^2] towards the centre of rotation
};

}  // namespace footprint_collision_predictor::core
