// Points and segments in 64-bit precision, for the oracle of whole footprints.
#pragma once

#include <cmath>

namespace footprint_collision_predictor::test {

using Real = long double;

struct Point {
  Real x;
  Real y;
};

inline Point operator+(const Point& a, const Point& b) { return {a.x + b.x, a.y + b.y}; }
inline Point operator-(const Point& a, const Point& b) { return {a.x - b.x, a.y - b.y}; }
inline Point operator*(Real k, const Point& a) { return {k * a.x, k * a.y}; }
inline Real dot(const Point& a, const Point& b) { return a.x * b.x + a.y * b.y; }
inline Real cross(const Point& a, const Point& b) { return a.x * b.y - a.y * b.x; }
inline Real norm(const Point& a) { return std::hypot(a.x, a.y); }

/// From start to end; they may be the same point.
struct Line {
  Point start;
  Point end;
};

/// Which side of the line's whole length p lies on: positive to the left.
inline Real side(const Line& line, const Point& p) {
  return cross(line.end - line.start, p - line.start);
}

inline Point nearestPoint(const Line& line, const Point& p) {
  const Point way = line.end - line.start;
  const Real along = dot(way, p - line.start);
  if (!(along > 0)) return line.start;
  if (along >= dot(way, way)) return line.end;
  return line.start + (along / dot(way, way)) * way;
}

inline bool isCrossing(const Line& a, const Line& b) {
  return side(a, b.start) * side(a, b.end) < 0 && side(b, a.start) * side(b, a.end) < 0;
}

inline Real length(const Line& line) { return norm(line.end - line.start); }

/// From a's point nearest to b to b's point nearest to a. Without length where they cross.
inline Line shortestLine(const Line& a, const Line& b) {
  if (isCrossing(a, b)) return {a.start, a.start};
  const Line lines[] = {{nearestPoint(a, b.start), b.start},
                        {nearestPoint(a, b.end), b.end},
                        {a.start, nearestPoint(b, a.start)},
                        {a.end, nearestPoint(b, a.end)}};
  Line shortest = lines[0];
  for (const Line& line : lines)
    if (length(line) < length(shortest)) shortest = line;
  return shortest;
}

}  // namespace footprint_collision_predictor::test
