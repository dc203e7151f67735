// An edge whose body may turn: conservative advancement along the path of the disc's centre as seen
// from the edge's start, or, with the roles swapped, of the edge's start as seen from an outline.
#include <algorithm>
#include <cmath>
#include <cstddef>

#include "advancement.hpp"
#include "edge_contact.hpp"
#include "path.hpp"
#include "rounding.hpp"

namespace footprint_collision_predictor::core {
namespace {

// Turning takes some 3 steps, or some 10 for each full turn within the horizon. Where a gap of less
// than a micrometre lasts while the body turns about that very place, a step is as short as 1e-4
// rad.
constexpr std::size_t kMostSteps = 10000000;

/// How near counts as touching at a time, for an edge that turns.
template <typename Path>
auto toleranceOf(const Path& path, const Edge& edge, const Disc& disc) {
  return [&path, &disc, length = edge.length](double t) {
    return kTurningTolerance + kRoundingAllowance * (path.sizeAt(t) + length + disc.radiusAt(t));
  };
}

template <typename Path, typename Tolerance>
std::optional<double> timeToTouchTurning(const Edge& edge, const Path& path, const Disc& disc,
                                         double horizon, const Tolerance& tolerance) {
  const EdgeBody body{edge};
  const Advance advance = advanceToContact(body, path, disc, 0, horizon, tolerance, kMostSteps);
  // Undecided is never later than the contact.
  return advance.outcome == Advance::kNoContact ? std::nullopt : std::make_optional(advance.time);
}

}  // namespace

std::optional<Contact> timeToCollision(const Segment& segment, const Twist& twist, const Disc& disc,
                                       double horizon) {
  return timeToCollision(Edge(segment), twist, disc, horizon);
}

std::optional<Contact> timeToCollision(const Edge& edge, const Twist& twist, const Disc& disc,
                                       double horizon) {
  if (twist.angular == 0) {
    const Disc relative{relativeMotion(disc.motion, twist), disc.radius, disc.radius_rate};
    return timeToCollision(edge, relative, horizon);
  }
  const Disc local = relativeTo(edge.start, disc);
  const PathSeenFromTurningBody path(local.motion, atPoint(edge.start, twist));
  const auto tolerance = toleranceOf(path, edge, disc);
  const auto time = timeToTouchTurning(fromStart(edge), path, local, horizon, tolerance);
  if (!time) return std::nullopt;
  return contactAt(edge, edge.tangent.dot(path.at(*time).position), *time, tolerance(*time));
}

std::optional<double> timeToTouchPoint(const Vec2& point, const Twist& twist, const Edge& edge,
                                       const Disc& carrier, double horizon) {
  const Twist of_point = atPoint(point, twist);
  const Motion seen_from{vertexFrom(point, carrier.motion.position, edge.start),
                         carrier.motion.velocity, carrier.motion.acceleration};
  Disc disc{{-seen_from.position, of_point.linear - seen_from.velocity, -seen_from.acceleration},
            carrier.radius,
            carrier.radius_rate};
  const Edge local = fromStart(edge);
  if (twist.angular == 0) {
    const auto contact = timeToCollision(local, disc, horizon);
    return contact ? std::make_optional(contact->time) : std::nullopt;
  }
  const PathOfTurningPoint path(seen_from, of_point);
  return timeToTouchTurning(local, path, disc, horizon, toleranceOf(path, edge, disc));
}

}  // namespace footprint_collision_predictor::core
