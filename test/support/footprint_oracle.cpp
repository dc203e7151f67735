#include "footprint_oracle.hpp"

#include <algorithm>

namespace footprint_collision_predictor::test {
namespace {

Point point(const Vec2& v) { return {v.x(), v.y()}; }

/// Whether a ray from p leaves through an odd number of edges.
bool isInside(const std::vector<Line>& edges, const Point& p) {
  bool inside = false;
  for (const Line& e : edges) {
    if ((e.start.y > p.y) == (e.end.y > p.y)) continue;
    if ((side(e, p) > 0) == (e.end.y > e.start.y)) inside = !inside;
  }
  return inside;
}

std::vector<Line> edgesOf(const OutlineNow& now) {
  std::vector<Line> edges;
  for (std::size_t i = 0; i < now.edges(); ++i) edges.push_back(now.edge(i));
  return edges;
}

std::vector<Line> segmentsOf(const std::vector<Vec2>& vertices, const Point& origin) {
  std::vector<Line> segments;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Point end = point(vertices[(i + 1) % vertices.size()]);
    segments.push_back({point(vertices[i]) - origin, end - origin});
  }
  return segments;
}

}  // namespace

FootprintOracle::FootprintOracle(const FootprintCase& c)
    : case_(c),
      origin_(c.twist.angular == 0 ? point(c.footprint[0]) : Point{0, 0}),
      segments_(segmentsOf(c.footprint, origin_)),
      outline_(c, origin_) {}

Real FootprintOracle::gap(Real t) const { return gapAt(t, segments_, outline_); }

Real FootprintOracle::gapOfSegment(std::size_t segment, Real t) const {
  return gapAt(t, {segments_[segment]}, outline_);
}

Real FootprintOracle::gapOfPoint(const Vec2& p, Real t) const {
  const Point there = point(p) - origin_;
  return gapAt(t, {{there, there}}, outline_);
}

Line FootprintOracle::shortestLine(Real t) const {
  Line shortest{{0, 0}, {HUGE_VALL, 0}};
  for (const Line& edge : edgesOf(outline_.at(t)))
    for (const Line& segment : segments_) {
      const Line line = test::shortestLine(segment, edge);
      if (length(line) < length(shortest)) shortest = line;
    }
  return {shortest.start + origin_, shortest.end + origin_};
}

bool FootprintOracle::isWithinNow() const {
  const OutlineNow now = outline_.at(0);
  if (gap(0) + now.radius <= 0) return false;  // the boundaries meet
  const bool around = now.vertices.size() > 2 && isInside(edgesOf(now), segments_[0].start);
  return around || isInside(segments_, now.vertices[0]);
}

Real FootprintOracle::clearance() const {
  const Real radius = outline_.at(0).radius;
  const Real distance = gap(0) + radius;
  return (isWithinNow() ? -distance : distance) - radius;
}

FirstTouch FootprintOracle::firstTouchOfSegment(std::size_t segment) const {
  const Line& line = segments_[segment];
  if (case_.twist.angular != 0) return findFirstTouch({line}, outline_, case_.horizon);
  // From its own start: where a tiny segment hardly moves, 64 bits from another one's are short.
  const Line from_start{{0, 0}, line.end - line.start};
  const MovingOutline outline(case_, line.start + origin_);
  return findFirstTouch({from_start}, outline, case_.horizon);
}

std::vector<FirstTouch> FootprintOracle::firstTouchOfEachSegment() const {
  std::vector<FirstTouch> touches;
  for (std::size_t i = 0; i < segments_.size(); ++i) touches.push_back(firstTouchOfSegment(i));
  return touches;
}

FirstTouch FootprintOracle::firstTouch(const std::vector<FirstTouch>& of_segments) const {
  if (isWithinNow()) return {0, 0};
  FirstTouch first{case_.horizon, std::nullopt};
  for (const FirstTouch& touch : of_segments) {
    first.free_until = std::min(first.free_until, touch.free_until);
    if (touch.contact_at)
      first.contact_at = std::min(first.contact_at.value_or(case_.horizon), *touch.contact_at);
  }
  return first;
}

SmallestGap FootprintOracle::smallestGap() const {
  if (isWithinNow()) return {0, 0};
  const SmallestGap found = findSmallestGap(segments_, outline_, case_.horizon);
  return {std::max(Real(0), found.gap), found.time};
}

}  // namespace footprint_collision_predictor::test
