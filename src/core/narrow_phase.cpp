#include "narrow_phase.hpp"

#include <algorithm>
#include <cmath>

#include "convex.hpp"
#include "edge_contact.hpp"
#include "path.hpp"
#include "rounding.hpp"

namespace footprint_collision_predictor::core {
namespace {

void keepEarlier(const std::optional<Contact>& candidate, std::optional<Contact>* earliest) {
  if (candidate && (!*earliest || candidate->time < (*earliest)->time)) *earliest = candidate;
}

/// A point told from the start of the edge, in the edge's own frame; the ends exactly.
Vec2 pointOf(const Edge& edge, Feature feature, const Vec2& from_start) {
  if (feature == Feature::kStart) return edge.start;
  return feature == Feature::kEnd ? edge.end : Vec2(edge.start + from_start);
}

/// Speed [m/s] across a side into the footprint; 0 when it leads out.
double speedInwards(const Polygon& footprint, std::size_t segment, const Vec2& velocity) {
  const Vec2 left = leftNormal(footprint.segment(segment).tangent);
  return std::max(0.0, velocity.dot(left) * (footprint.isCounterClockwise() ? 1 : -1));
}

/// Speed at which the gap shrinks at the contact [m/s], but for the radius' growth.
double closingSpeed(const Polygon& footprint, const Twist& twist, const Shape& shape,
                    const FootprintContact& first, bool is_nested) {
  const Contact& contact = first.contact;
  const Twist at_contact = atPoint(contact.point, twist);
  const double t = contact.time;
  const Turn turn(twist.angular * t);
  const Vec2 velocity = turn.back(shape.disc.motion.velocityAt(t)) - at_contact.linear;
  const bool is_at_side = contact.feature == Feature::kInside;
  if (is_at_side && !is_nested) return speedInwards(footprint, first.segment, velocity);
  // From the contact, so that nothing is lost far from the origin.
  const Disc disc = relativeTo(contact.point, shape.disc);
  const Vec2 way = turn.displacement(t * at_contact.linear);
  const Vec2 centre = turn.back(disc.motion.positionAt(t) - way);
  std::optional<Vec2> outline_direction;
  const Vec2 away = shape.outline.size == 0
                        ? centre
                        : nearestToOrigin(shape.outline, turn, centre, &outline_direction);
  const StraightPath path(relativeMotion(disc.motion, at_contact));
  double size = 2 * footprint.boundingRadius();
  for (const Edge& edge : shape.outline)
    size = std::max(size, edge.start.lpNorm<1>() + edge.end.lpNorm<1>());
  const double rounding = kRoundingAllowance * (path.sizeAt(t) + size);
  const double nothing = 4 * rounding + (twist.angular != 0 ? 2 * kTurningTolerance : 0);
  const double distance = away.norm();
  if (distance > nothing)
    return std::max(0.0, velocity.dot(away) / (is_nested ? distance : -distance));
  // What has no radius touches with its centre or outline. An edge has its normal; a vertex has
  // many, of which the one against the velocity is the worst.
  if (is_at_side) return speedInwards(footprint, first.segment, velocity);
  if (outline_direction) return std::abs(cross(*outline_direction, velocity));
  return velocity.norm();
}

/// A lower bound in [0, duration] of c + b t + a t^2.
double lowerBound(double c, double b, double a, double duration) {
  return c + duration * (std::min(b, 0.0) + duration * std::min(a, 0.0));
}

}  // namespace

NarrowPhase::NarrowPhase(const Polygon& footprint, const Twist& twist, const Shape& shape,
                         double horizon)
    : footprint_(footprint),
      twist_(twist),
      shape_(shape),
      horizon_(horizon),
      relative_(shape.disc),
      rounding_(0) {
  relative_.motion = relativeMotion(shape.disc.motion, twist);
  const Motion& m = relative_.motion;
  const double path = horizon * (m.velocity.lpNorm<1>() + relative_.radius_rate +
                                 0.5 * horizon * m.acceleration.lpNorm<1>());
  rounding_ = kGenerous * ((m.position - footprint.centroid()).lpNorm<1>() + relative_.radius +
                           2 * footprint.boundingRadius() + path);
}

/// Whether a line separates the disc from the edge all the time: the edge's own, or one across an
/// end of it. Much quicker than the exact answer.
bool NarrowPhase::staysAway(const Edge& edge, double until) const {
  const Motion& m = relative_.motion;
  const Vec2 position = m.position - edge.start;
  const double reach = relative_.radius + relative_.radius_rate * until + rounding_;
  const double across = cross(edge.tangent, position);
  const double side = across < 0 ? -1 : 1;
  if (lowerBound(side * across, side * cross(edge.tangent, m.velocity),
                 0.5 * side * cross(edge.tangent, m.acceleration), until) > reach)
    return true;
  const double along = edge.tangent.dot(position);
  const double velocity = edge.tangent.dot(m.velocity);
  const double bend = 0.5 * edge.tangent.dot(m.acceleration);
  return lowerBound(-along, -velocity, -bend, until) > reach ||
         lowerBound(along - edge.length, velocity, bend, until) > reach;
}

std::optional<Contact> NarrowPhase::contactOf(std::size_t i, double until) const {
  const Edge& edge = footprint_.segment(i);
  if (shape_.outline.size > 0) return contactWithOutline(edge);
  if (twist_.angular != 0) {
    // Its last bits depend on how far ahead is looked; the answer must not depend on others.
    if (until < horizon_ && !timeToCollision(edge, twist_, shape_.disc, until)) return std::nullopt;
    return timeToCollision(edge, twist_, shape_.disc, horizon_);
  }
  if (staysAway(edge, until)) return std::nullopt;
  return timeToCollision(edge, relative_, horizon_);
}

/// The first contact of two chains always involves a vertex of one of them: the outline's against
/// the edge, or the edge's against the outline. Only chains that cross at once need neither.
std::optional<Contact> NarrowPhase::contactWithOutline(const Edge& edge) const {
  if (const auto point = touchNow(edge, shape_)) return Contact{0, featureOf(edge, *point), *point};
  std::optional<Contact> earliest;
  const auto touchOutline = [&](const Vec2& vertex, Feature feature, const Edge& other) {
    const auto time = timeToTouchPoint(vertex, twist_, other, shape_.disc, horizon_);
    if (time) keepEarlier(Contact{*time, feature, vertex}, &earliest);
  };
  // From the edge's start, so that nothing is lost far from the origin.
  const Edge local(Segment{{0, 0}, edge.end - edge.start});
  const Twist of_start = atPoint(edge.start, twist_);
  const auto touchVertex = [&](const Vec2& vertex) {
    Disc disc = shape_.disc;
    disc.motion.position = vertexFrom(edge.start, shape_.disc.motion.position, vertex);
    auto contact = timeToCollision(local, of_start, disc, horizon_);
    if (contact) contact->point = pointOf(edge, contact->feature, contact->point);
    keepEarlier(contact, &earliest);
  };
  for (const Edge& other : shape_.outline) {
    touchOutline(edge.start, Feature::kStart, other);
    touchOutline(edge.end, Feature::kEnd, other);
    touchVertex(other.start);
    if (!shape_.outline.isClosed()) touchVertex(other.end);
  }
  return earliest;
}

namespace {

/// A circle, or a vertex of an outline, against a convex footprint.
/// \param disc its position told from the centroid
ConvexAnswer askWhole(const Polygon& footprint, const Twist& twist, const Disc& disc,
                      double horizon, double until) {
  ConvexAnswer answer = firstTouchOfConvex(footprint, twist, disc, until);
  // Its last bits depend on how far ahead is looked; the answer must not depend on others.
  if (answer.touch && until < horizon) answer = firstTouchOfConvex(footprint, twist, disc, horizon);
  return answer;
}

/// The same against an outline: its vertices against the whole, and the footprint's against it.
ConvexAnswer askOutline(const Polygon& footprint, const Twist& twist, const Shape& shape,
                        double horizon, double until) {
  ConvexAnswer first{true, std::nullopt};
  const auto keep = [&](const std::optional<FirstTouch>& touch) {
    if (!touch || !(touch->contact.time <= until)) return;
    if (first.touch && touch->contact.time >= first.touch->contact.time) return;
    first.touch = touch;
    until = touch->contact.time;
  };
  const auto askVertex = [&](const Vec2& vertex) {
    Disc disc = shape.disc;
    disc.motion.position = vertexFrom(footprint.centroid(), shape.disc.motion.position, vertex);
    const ConvexAnswer answer = askWhole(footprint, twist, disc, horizon, until);
    first.is_certain = first.is_certain && answer.is_certain;
    keep(answer.touch);
  };
  for (const Edge& edge : shape.outline) {
    askVertex(edge.start);
    if (!shape.outline.isClosed()) askVertex(edge.end);
    for (std::size_t i = 0; first.is_certain && i < footprint.size(); ++i) {
      const Vec2& vertex = footprint.vertices()[i];
      const auto time = timeToTouchPoint(vertex, twist, edge, shape.disc, horizon);
      if (time) keep(FirstTouch{{*time, Feature::kStart, vertex}, i});
    }
    if (!first.is_certain) return first;
  }
  return first;
}

}  // namespace

std::optional<FirstTouch> firstTouch(const Polygon& footprint, const Twist& twist,
                                     const Shape& shape, double horizon, double until) {
  if (footprint.isConvex()) {
    const ConvexAnswer answer =
        shape.outline.size == 0
            ? askWhole(footprint, twist, relativeTo(footprint.centroid(), shape.disc), horizon,
                       until)
            : askOutline(footprint, twist, shape, horizon, until);
    if (answer.is_certain) return answer.touch;
  }
  const NarrowPhase narrow(footprint, twist, shape, horizon);
  std::optional<FirstTouch> first;
  for (std::size_t i = 0; i < footprint.size(); ++i) {
    const auto contact = narrow.contactOf(i, until);
    if (!contact || contact->time > until) continue;
    if (first && contact->time == until) continue;
    first = FirstTouch{*contact, i};
    until = contact->time;
  }
  return first;
}

FootprintContact contactNow(const Polygon& footprint, const Twist& twist, const Shape& shape,
                            const Nearest& nearest) {
  const Feature feature = featureOf(footprint.segment(nearest.segment), nearest.point);
  FootprintContact first =
      contactLater(footprint, twist, shape, {{0, feature, nearest.point}, nearest.segment});
  const bool is_nested = nearest.gap + shape.disc.radius < 0;
  if (is_nested) first.closing_speed = closingSpeed(footprint, twist, shape, first, true);
  return first;
}

FootprintContact contactLater(const Polygon& footprint, const Twist& twist, const Shape& shape,
                              const FirstTouch& touch) {
  FootprintContact first{touch.contact, touch.segment, 0, 0};
  const std::size_t neighbour = neighbourAt(footprint, touch.contact.feature, touch.segment);
  if (neighbour < touch.segment) {
    first.segment = neighbour;
    first.contact.feature = featureOf(footprint.segment(neighbour), touch.contact.point);
  }
  first.closing_speed = closingSpeed(footprint, twist, shape, first, false);
  return first;
}

std::size_t neighbourAt(const Polygon& footprint, Feature feature, std::size_t segment) {
  if (feature == Feature::kStart) return footprint.previous(segment);
  return feature == Feature::kEnd ? footprint.next(segment) : segment;
}

}  // namespace footprint_collision_predictor::core
