#include "gap_search.hpp"

#include <algorithm>
#include <cmath>

namespace footprint_collision_predictor::test {
namespace {

constexpr Real kFinest = 0x1p-35L;     // [s] 2.9e-11: such steps bracket a contact
constexpr Real kCoarser = 1.0L / 32;   // of the time since the first step that stayed undecided
constexpr Real kGapPrecision = 5e-8L;  // [m]
constexpr Real kShort = 1e-6L;         // of the lengths beside it

/// A segment of the footprint and an edge of the outline.
struct Pair {
  std::size_t segment;
  std::size_t edge;
};
using Pairs = std::vector<Pair>;

/// Of a pair around one time.
struct GapAround {
  Real now;
  Real least;  ///< it is no smaller than so within the interval
};

class Search {
 public:
  Search(const std::vector<Line>& segments, const MovingOutline& outline, Real horizon)
      : segments_(segments), outline_(outline), horizon_(horizon) {}

  Pairs allPairs() const {
    Pairs pairs;
    for (std::size_t i = 0; i < segments_.size(); ++i)
      for (std::size_t j = 0; j < outline_.at(0).edges(); ++j) pairs.push_back({i, j});
    return pairs;
  }

  Real gapAt(Real t, const Pairs& pairs) const {
    const OutlineNow now = outline_.at(t);
    Real least = HUGE_VALL;
    for (const Pair& p : pairs)
      least = std::min(least, length(shortestLine(segments_[p.segment], now.edge(p.edge))));
    return least - now.radius;
  }

 protected:
  /// The pair's gap now, and the least it can be until `dt` before and after. The two are apart at
  /// least as far as along the way that is shortest now. Where that is so short beside the two that
  /// rounding turns it, the directions across them are better.
  GapAround gapAround(const Pair& p, const OutlineNow& now, Real dt) const {
    const Line& segment = segments_[p.segment];
    const Line edge = now.edge(p.edge);
    const Line way = shortestLine(segment, edge);
    const Real distance = length(way);
    if (distance == 0) return {-now.radius, -HUGE_VALL};
    Real least = leastAlong((1 / distance) * (way.end - way.start), p, now, dt);
    if (distance < kShort * (length(segment) + length(edge)))
      for (const Line& line : {segment, edge}) {
        const Real l = length(line);
        if (l == 0) continue;
        const Point across{(line.start.y - line.end.y) / l, (line.end.x - line.start.x) / l};
        least = std::max(least, leastAlong(across, p, now, dt));
        least = std::max(least, leastAlong(-1 * across, p, now, dt));
      }
    return {distance - now.radius, least};
  }

  /// How far the two stay apart along a direction at least, whether that turns with the footprint
  /// (which is good for its faces) or not (for those of the outline).
  Real leastAlong(const Point& direction, const Pair& p, const OutlineNow& now, Real dt) const {
    Real turning = HUGE_VALL;
    Real fixed = HUGE_VALL;
    for (const Point& v : {now.vertices[p.edge], now.vertices[now.endOf(p.edge)]})
      for (const Point& f : {segments_[p.segment].start, segments_[p.segment].end}) {
        const Real gap = dot(direction, v - f) - now.radius;
        const auto least = [&](const Point& velocity, Real bend) {
          const Real approach = std::abs(dot(direction, velocity) - outline_.radiusRate());
          return gap - dt * (approach + dt * bend / 2);
        };
        turning = std::min(turning, least(outline_.seenFromFootprint(v, now.velocity),
                                          outline_.bendSeenFromFootprint(v, now.velocity, dt)));
        fixed = std::min(
            fixed, least(outline_.seenFromGround(f, now.velocity), outline_.bendSeenFromGround(f)));
      }
    return std::max(turning, fixed);
  }

  const std::vector<Line>& segments_;
  const MovingOutline& outline_;
  Real horizon_;
};

class TouchSearch : public Search {
 public:
  using Search::Search;

  FirstTouch run() {
    const Pairs pairs = allPairs();
    if (gapAt(0, pairs) <= 0) return {0, 0};
    if (!explore(0, horizon_, pairs) && gapAt(horizon_, pairs) <= 0) contact_ = horizon_;
    return {blocked_.value_or(contact_.value_or(horizon_)), contact_};
  }

 private:
  /// From left to right. True once a contact is found.
  bool explore(Real low, Real high, const Pairs& pairs) {
    const Real middle = low + (high - low) / 2;
    const OutlineNow now = outline_.at(middle);
    Pairs near;
    bool touching = false;
    for (const Pair& p : pairs) {
      const GapAround gap = gapAround(p, now, high - middle);
      if (gap.least <= 0) near.push_back(p);
      touching = touching || gap.now <= 0;
    }
    if (near.empty()) return false;
    if (high - low <= std::max(kFinest, kCoarser * (low - blocked_.value_or(low))))
      return decide(low, touching ? middle : high, near);
    if (explore(low, middle, near)) return true;
    if (touching) contact_ = middle;
    return touching || explore(middle, high, near);
  }

  bool decide(Real low, Real high, const Pairs& near) {
    if (!blocked_) blocked_ = low;
    if (gapAt(high, near) <= 0)
      contact_ = narrowed(low, high, near);
    else if (isCrossed(low, high, near))
      contact_ = high;
    return contact_.has_value();
  }

  /// Touching at `high`: the same closer to `low`, where there is a gap.
  Real narrowed(Real low, Real high, const Pairs& near) const {
    while (high - low > kFinest) {
      const Real middle = low + (high - low) / 2;
      (gapAt(middle, near) <= 0 ? high : low) = middle;
    }
    return high;
  }

  bool isCrossed(Real low, Real high, const Pairs& near) const {
    const OutlineNow before = outline_.at(low);
    const OutlineNow after = outline_.at(high);
    return std::any_of(near.begin(), near.end(), [&](const Pair& p) {
      return isCrossed(segments_[p.segment], before, after, p.edge, high - low);
    });
  }

  /// Whether the edge got from one side of the segment to the other without ever leaving the strip
  /// beside it, which no sample need show: what has no radius touches for a moment only.
  bool isCrossed(const Line& segment, const OutlineNow& before, const OutlineNow& after,
                 std::size_t edge, Real dt) const {
    const Real length = norm(segment.end - segment.start);
    const Real sides[] = {
        side(segment, before.edge(edge).start), side(segment, before.edge(edge).end),
        -side(segment, after.edge(edge).start), -side(segment, after.edge(edge).end)};
    const bool all_left = std::all_of(sides, sides + 4, [](Real s) { return s > 0; });
    const bool all_right = std::all_of(sides, sides + 4, [](Real s) { return s < 0; });
    Real low = HUGE_VALL;
    Real high = -HUGE_VALL;
    for (const std::size_t i : {edge, before.endOf(edge)}) {
      const Real along =
          dot(segment.end - segment.start, before.vertices[i] - segment.start) / length;
      const Real bend = outline_.bendSeenFromFootprint(before.vertices[i], before.velocity, dt);
      const Point velocity = outline_.seenFromFootprint(before.vertices[i], before.velocity);
      const Real moved = dt * (norm(velocity) + dt * bend / 2);
      low = std::min(low, along + moved);
      high = std::max(high, along - moved);
    }
    return (all_left || all_right) && high > 0 && low < length;
  }

  std::optional<Real> blocked_;
  std::optional<Real> contact_;
};

class SmallestSearch : public Search {
 public:
  using Search::Search;

  SmallestGap run() {
    const Pairs pairs = allPairs();
    best_ = {gapAt(0, pairs), 0};
    take(gapAt(horizon_, pairs), horizon_);
    explore(0, horizon_, pairs);
    return best_;
  }

 private:
  void take(Real gap, Real time) {
    if (gap < best_.gap) best_ = {gap, time};
  }

  void explore(Real low, Real high, const Pairs& pairs) {
    const Real middle = low + (high - low) / 2;
    const OutlineNow now = outline_.at(middle);
    std::vector<GapAround> gaps;
    for (const Pair& p : pairs) {
      gaps.push_back(gapAround(p, now, high - middle));
      take(gaps.back().now, middle);
    }
    Pairs near;
    for (std::size_t i = 0; i < pairs.size(); ++i)
      if (gaps[i].least < best_.gap - kGapPrecision) near.push_back(pairs[i]);
    if (near.empty() || best_.gap <= kGapPrecision || high - low <= kFinest) return;
    const bool left_first =
        gapAt(low + (high - low) / 4, near) < gapAt(high - (high - low) / 4, near);
    if (left_first) explore(low, middle, near);
    explore(middle, high, near);
    if (!left_first) explore(low, middle, near);
  }

  SmallestGap best_{0, 0};
};

}  // namespace

Real gapAt(Real t, const std::vector<Line>& segments, const MovingOutline& outline) {
  const Search search(segments, outline, 0);
  return search.gapAt(t, search.allPairs());
}

FirstTouch findFirstTouch(const std::vector<Line>& segments, const MovingOutline& outline,
                          Real horizon) {
  return TouchSearch(segments, outline, horizon).run();
}

SmallestGap findSmallestGap(const std::vector<Line>& segments, const MovingOutline& outline,
                            Real horizon) {
  return SmallestSearch(segments, outline, horizon).run();
}

}  // namespace footprint_collision_predictor::test
