#include "footprint_collision_predictor/polygon.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace footprint_collision_predictor::core {
namespace {

bool overlap(double a, double b, double c, double d) {
  return std::max(a, b) >= std::min(c, d) && std::max(c, d) >= std::min(a, b);
}

bool meet(const Segment& s, const Segment& t) {
  return overlap(s.start.x(), s.end.x(), t.start.x(), t.end.x()) &&
         overlap(s.start.y(), s.end.y(), t.start.y(), t.end.y()) &&
         orientation(s.start, s.end, t.start) * orientation(s.start, s.end, t.end) <= 0 &&
         orientation(t.start, t.end, s.start) * orientation(t.start, t.end, s.end) <= 0;
}

bool foldsBack(const Vec2& before, const Vec2& vertex, const Vec2& after) {
  return orientation(after, before, vertex) == 0 && (before - vertex).dot(after - vertex) > 0;
}

template <typename... Parts>
[[noreturn]] void refuse(const Parts&... parts) {
  std::ostringstream text;
  (text << ... << parts);
  throw InvalidPolygon(text.str());
}

std::string describe(const std::vector<Vec2>& vertices, std::size_t i) {
  std::ostringstream text;
  text << "vertex " << i << " (" << vertices[i].x() << ", " << vertices[i].y() << ")";
  return text.str();
}

void requireUsableNumbers(const std::vector<Vec2>& vertices) {
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    if (!vertices[i].allFinite()) refuse(describe(vertices, i), " is not finite");
    if (vertices[i].lpNorm<Eigen::Infinity>() > kMaxCoordinate)
      refuse(describe(vertices, i), " lies beyond the limit of ", kMaxCoordinate, " m");
  }
  Vec2 low = vertices[0], high = vertices[0];
  for (const Vec2& vertex : vertices) {
    low = low.cwiseMin(vertex);
    high = high.cwiseMax(vertex);
  }
  if ((high - low).maxCoeff() > kMaxFootprintExtent)
    refuse("the footprint is ", (high - low).maxCoeff(), " m wide; allowed are ",
           kMaxFootprintExtent, " m");
}

void requireDistinctNeighbours(const std::vector<Vec2>& vertices) {
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const std::size_t next = (i + 1) % vertices.size();
    if (vertices[i] == vertices[next])
      refuse(describe(vertices, i), " is repeated as vertex ", next,
             next == 0 ? "; the last segment closes the footprint by itself, so leave it out" : "");
  }
}

void requireArea(const std::vector<Vec2>& vertices) {
  const auto farther = [&](const Vec2& a, const Vec2& b) {
    return (a - vertices[0]).squaredNorm() < (b - vertices[0]).squaredNorm();
  };
  const Vec2 farthest = *std::max_element(vertices.begin(), vertices.end(), farther);
  const auto on_line = [&](const Vec2& v) { return orientation(vertices[0], farthest, v) == 0; };
  if (std::all_of(vertices.begin(), vertices.end(), on_line))
    refuse("the footprint has no area: all ", vertices.size(), " vertices lie on one line");
}

void requireSimple(const std::vector<Vec2>& vertices) {
  const std::size_t n = vertices.size();
  const auto segment = [&](std::size_t i) { return Segment{vertices[i], vertices[(i + 1) % n]}; };
  for (std::size_t i = 0; i < n; ++i) {
    if (foldsBack(vertices[i], vertices[(i + 1) % n], vertices[(i + 2) % n]))
      refuse("segments ", i, " and ", (i + 1) % n, " fold back on each other at ",
             describe(vertices, (i + 1) % n));
    for (std::size_t j = i + 2; j < n; ++j) {
      if (i == 0 && j == n - 1) continue;  // neighbours round the corner
      if (meet(segment(i), segment(j)))
        refuse("segments ", i, " and ", j, " cross or touch; they start at ", describe(vertices, i),
               " and ", describe(vertices, j));
    }
  }
}

double farthestFrom(const Vec2& p, const std::vector<Vec2>& vertices) {
  double farthest = 0;
  for (const Vec2& vertex : vertices) farthest = std::max(farthest, (vertex - p).norm());
  return farthest;
}

std::vector<Vec2> validated(std::vector<Vec2> vertices) {
  if (vertices.size() < 3)
    refuse("a footprint needs at least 3 vertices; there are ", vertices.size());
  requireUsableNumbers(vertices);
  requireDistinctNeighbours(vertices);
  requireArea(vertices);
  requireSimple(vertices);
  return vertices;
}

std::vector<Edge> edgesOf(const std::vector<Vec2>& vertices) {
  std::vector<Edge> edges;
  for (std::size_t i = 0; i < vertices.size(); ++i)
    edges.emplace_back(Segment{vertices[i], vertices[(i + 1) % vertices.size()]});
  return edges;
}

bool turnsOneWay(const std::vector<Vec2>& vertices, int way) {
  const std::size_t n = vertices.size();
  for (std::size_t i = 0; i < n; ++i)
    if (orientation(vertices[(i + 2) % n], vertices[i], vertices[(i + 1) % n]) == -way)
      return false;
  return true;
}

Sides sidesOf(const std::vector<Edge>& edges, const Vec2& centroid, double winding) {
  Sides sides;
  sides.winding = winding;
  for (const Edge& edge : edges) {
    const Vec2 start = edge.start - centroid;
    const Vec2 normal = -winding * leftNormal(edge.tangent);
    sides.normal_x.push_back(normal.x());
    sides.normal_y.push_back(normal.y());
    sides.offset.push_back(normal.dot(start));
    sides.start.push_back(edge.tangent.dot(start));
    sides.length.push_back(edge.length);
  }
  return sides;
}

}  // namespace

double signedArea(const std::vector<Vec2>& vertices) {
  double twice = 0;
  for (std::size_t i = 2; i < vertices.size(); ++i)
    twice += cross(vertices[i - 1] - vertices[0], vertices[i] - vertices[0]);
  return twice / 2;
}

Vec2 centroid(const std::vector<Vec2>& vertices) {
  const double area = signedArea(vertices);
  if (area == 0) refuse("a polygon without area has no centroid");
  Vec2 moment = Vec2::Zero();
  for (std::size_t i = 2; i < vertices.size(); ++i) {
    const Vec2 p = vertices[i - 1] - vertices[0];
    const Vec2 q = vertices[i] - vertices[0];
    moment += cross(p, q) * (p + q);
  }
  return vertices[0] + moment / (6 * area);
}

Polygon::Polygon(std::vector<Vec2> vertices)
    : vertices_(validated(std::move(vertices))),
      edges_(edgesOf(vertices_)),
      signed_area_(core::signedArea(vertices_)),
      centroid_(core::centroid(vertices_)),
      bounding_radius_(farthestFrom(centroid_, vertices_)),
      is_convex_(turnsOneWay(vertices_, signed_area_ > 0 ? 1 : -1)),
      sides_(sidesOf(edges_, centroid_, signed_area_ > 0 ? 1 : -1)) {}

double Polygon::area() const { return std::abs(signed_area_); }

bool Polygon::contains(const Vec2& p) const {
  // Counts the edges to the right of p (Haines, "Point in Polygon Strategies", 1994).
  bool inside = false;
  for (std::size_t i = 0; i < size(); ++i) {
    const Segment& edge = edges_[i];
    if ((edge.start.y() > p.y()) == (edge.end.y() > p.y())) continue;
    const bool upwards = edge.end.y() > edge.start.y();
    const bool left_of_edge = cross(edge.end - edge.start, p - edge.start) > 0;
    if (left_of_edge == upwards) inside = !inside;
  }
  return inside;
}

}  // namespace footprint_collision_predictor::core
