#include "shape.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "edge_contact.hpp"
#include "rounding.hpp"

namespace footprint_collision_predictor::core {
namespace {

bool areOnBothSides(const Edge& edge, const Vec2& p, const Vec2& q) {
  return orientation(edge.start, edge.end, p) * orientation(edge.start, edge.end, q) < 0;
}

/// Whether two edges cross, each between its ends, beyond doubt: edges in line do not.
bool doCross(const Edge& a, const Edge& b) {
  return areOnBothSides(a, b.start, b.end) && areOnBothSides(b, a.start, a.end);
}

/// Of edges that cross. Those nearly in line leave open where, so it may be off their ends.
Vec2 crossing(const Edge& a, const Edge& b) {
  const Vec2 other = b.end - b.start;
  const double left = cross(other, a.start - b.start), right = cross(other, a.end - b.start);
  return a.start + left / (left - right) * (a.end - a.start);
}

/// The point of `edge` that is nearest to another edge.
Vec2 nearestPoint(const Edge& edge, const Edge& other, bool do_cross) {
  Vec2 nearest = edge.start;
  double smallest = distance(other, edge.start);
  const auto take = [&](const Vec2& p, double d) {
    if (d < smallest) {
      nearest = p;
      smallest = d;
    }
  };
  take(edge.end, distance(other, edge.end));
  for (const Vec2& p : {other.start, other.end}) take(closestPoint(edge, p), distance(edge, p));
  if (!do_cross) return nearest;
  const Vec2 p = crossing(edge, other);
  take(p, distance(other, p));
  return nearest;
}

/// Whether a point lies within closed edges: counts those to the right of it (Haines, "Point in
/// Polygon Strategies", 1994).
/// \param from Vec2(const Vec2& vertex): where a vertex of them lies to the point
template <typename From>
bool contains(const Outline& edges, const From& from) {
  bool inside = false;
  for (const Edge& edge : edges) {
    const Vec2 start = from(edge.start), end = from(edge.end);
    if ((start.y() > 0) == (end.y() > 0)) continue;
    const bool upwards = end.y() > start.y();
    const bool left_of_edge = cross(start, edge.end - edge.start) > 0;
    if (left_of_edge == upwards) inside = !inside;
  }
  return inside;
}

bool areNested(const Polygon& footprint, const Shape& shape) {
  const Vec2& centre = shape.disc.motion.position;
  if (shape.outline.size == 0) return footprint.contains(centre);
  // One from the other, so that nothing is lost where they are nearly on each other's edges.
  const auto fromOutline = [&](const Vec2& vertex) -> Vec2 {
    return -vertexFrom(vertex, centre, shape.outline.first->start);
  };
  const auto fromFootprint = [&](const Vec2& vertex) {
    return vertexFrom(footprint.vertices().front(), centre, vertex);
  };
  return contains({&footprint.segment(0), footprint.size()}, fromOutline) ||
         (shape.outline.isClosed() && contains(shape.outline, fromFootprint));
}

/// The point of the edge that is nearest to the obstacle's centre or outline, and how far off it
/// is.
struct Near {
  Vec2 point;
  double distance;
};

Near nearTo(const Edge& edge, const Shape& shape) {
  const Vec2& centre = shape.disc.motion.position;
  if (shape.outline.size == 0) return {closestPoint(edge, centre), distance(edge, centre)};
  // From the edge's start, so that nothing is lost far from the origin.
  const Edge local = fromStart(edge);
  std::optional<Near> nearest;
  for (const Edge& of_outline : shape.outline) {
    Edge other = of_outline;
    other.start = vertexFrom(edge.start, centre, of_outline.start);
    other.end = vertexFrom(edge.start, centre, of_outline.end);
    const bool do_cross = doCross(local, other);
    const Vec2 point = nearestPoint(local, other, do_cross);
    const double d = do_cross ? 0 : distance(other, point);
    if (nearest && nearest->distance <= d) continue;
    nearest = Near{point == local.end ? edge.end : Vec2(edge.start + point), d};
  }
  return *nearest;
}

}  // namespace

void appendOutline(const Obstacle& obstacle, std::vector<Edge>* edges) {
  const std::vector<Vec2>& vertices = obstacle.outline();
  if (vertices.size() < 2) return;
  for (std::size_t i = 1; i < vertices.size(); ++i)
    edges->emplace_back(Segment{vertices[i - 1], vertices[i]});
  if (vertices.size() > 2) edges->emplace_back(Segment{vertices.back(), vertices.front()});
}

Nearest nearestNow(const Polygon& footprint, const Shape& shape) {
  std::size_t segment = 0;
  Near nearest = nearTo(footprint.segment(0), shape);
  for (std::size_t i = 1; i < footprint.size(); ++i) {
    const Near near = nearTo(footprint.segment(i), shape);
    if (near.distance < nearest.distance) {
      nearest = near;
      segment = i;
    }
  }
  const double sign = nearest.distance > 0 && areNested(footprint, shape) ? -1 : 1;
  return {segment, nearest.point, sign * nearest.distance - shape.disc.radius};
}

double gapNow(const Edge& edge, const Shape& shape) {
  return nearTo(edge, shape).distance - shape.disc.radius;
}

std::optional<Vec2> touchNow(const Edge& edge, const Shape& shape) {
  const Near nearest = nearTo(edge, shape);
  double size = edge.length + shape.disc.radius;
  for (const Edge& other : shape.outline) size = std::max(size, other.length);
  const bool touches = nearest.distance <= shape.disc.radius + kRoundingAllowance * size;
  return touches ? std::make_optional(nearest.point) : std::nullopt;
}

Vec2 nearestToOrigin(const Outline& outline, const Turn& turn, const Vec2& centre,
                     std::optional<Vec2>* edge_direction) {
  // In the axes of the outline, about its centre.
  const Vec2 origin = turn(-centre);
  Vec2 nearest = outline.first->start;
  for (const Edge& edge : outline) {
    const Vec2 point = closestPoint(edge, origin);
    if ((point - origin).norm() > (nearest - origin).norm()) continue;
    nearest = point;
    *edge_direction = featureOf(edge, point) == Feature::kInside
                          ? std::make_optional(turn.back(edge.tangent))
                          : std::nullopt;
  }
  return centre + turn.back(nearest);
}

Feature featureOf(const Segment& segment, const Vec2& point) {
  if (point == segment.start) return Feature::kStart;
  return point == segment.end ? Feature::kEnd : Feature::kInside;
}

}  // namespace footprint_collision_predictor::core
