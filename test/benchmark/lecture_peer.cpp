#include "lecture_peer.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <unsupported/Eigen/Polynomials>

namespace footprint_collision_predictor::bench {
namespace {

/// Earliest root in [0, horizon]; what is not a root is NaN or infinite.
template <typename Roots>
double earliest(const Roots& roots) {
  double first = kNever;
  for (const double t : roots)
    if (t >= 0 && t <= kHorizon) first = std::min(first, t);
  return first;
}

/// Real roots of c + b t + a t^2.
std::array<double, 2> quadratic(double a, double b, double c) {
  const double q = -0.5 * (b + std::copysign(std::sqrt(b * b - 4 * a * c), b));
  return {q / a, c / q};
}

double quarticEnd(const Vec2& p, const Vec2& v, const Vec2& a, double radius) {
  Eigen::Matrix<double, 5, 1> coefficients;
  coefficients << p.squaredNorm() - radius * radius, 2 * p.dot(v), v.squaredNorm() + p.dot(a),
      v.dot(a), 0.25 * a.squaredNorm();
  const Eigen::PolynomialSolver<double, 4> solver(coefficients);
  std::vector<double> roots;
  roots.reserve(4);
  // Nearly double roots come out as a pair with a small imaginary part.
  solver.realRoots(roots, 1e-9);
  return earliest(roots);
}

double timeToEnd(const Vec2& end, const core::Motion& m, double radius) {
  const Vec2 p = m.position - end;
  if (p.squaredNorm() <= radius * radius) return 0;
  if (!m.acceleration.isZero(0)) return quarticEnd(p, m.velocity, m.acceleration, radius);
  return earliest(quadratic(m.velocity.squaredNorm(), 2 * p.dot(m.velocity),
                            p.squaredNorm() - radius * radius));
}

double timeToInside(const Segment& segment, const core::Motion& m, double radius) {
  const Vec2 along = segment.end - segment.start;
  const double angle = std::atan2(along.y(), along.x());
  const double c = std::cos(angle), s = std::sin(angle);
  const auto turned = [&](const Vec2& v) {
    return Vec2{c * v.x() + s * v.y(), c * v.y() - s * v.x()};
  };
  const double length = turned(along).x();
  const core::Motion local{turned(m.position - segment.start), turned(m.velocity),
                           turned(m.acceleration)};
  const auto is_inside = [&](double x) { return x >= 0 && x <= length; };
  if (is_inside(local.position.x()) && std::abs(local.position.y()) <= radius) return 0;
  double first = kNever;
  for (const double side : {radius, -radius})
    for (const double t :
         quadratic(0.5 * local.acceleration.y(), local.velocity.y(), local.position.y() - side))
      if (t >= 0 && t <= std::min(first, kHorizon) && is_inside(local.positionAt(t).x())) first = t;
  return first;
}

}  // namespace

LecturePeer::LecturePeer(std::vector<Segment> segments) : segments_(std::move(segments)) {}

double LecturePeer::firstContact(const Disc& disc) const {
  const core::Motion& circle = disc.motion;
  const double radius = disc.radius;
  double first = kNever;
  for (const Segment& segment : segments_)
    first = std::min(
        {first, timeToEnd(segment.start, circle, radius), timeToInside(segment, circle, radius)});
  if (segments_.back().end != segments_.front().start)
    first = std::min(first, timeToEnd(segments_.back().end, circle, radius));
  return first;
}

}  // namespace footprint_collision_predictor::bench
