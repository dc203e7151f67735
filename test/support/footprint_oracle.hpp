// What is true of a whole footprint and one obstacle, in 64-bit precision, for every motion and
// every outline.
#pragma once

#include <cstddef>
#include <vector>

#include "footprint_case.hpp"
#include "gap_search.hpp"

namespace footprint_collision_predictor::test {

class FootprintOracle {
 public:
  explicit FootprintOracle(const FootprintCase& c);

  /// Distance of the boundaries (of a line: the line) minus the radius [m].
  Real gap(Real t) const;
  Real gapOfSegment(std::size_t segment, Real t) const;
  /// Distance from a point in the footprint's frame to the obstacle's boundary minus the radius.
  Real gapOfPoint(const Vec2& p, Real t) const;
  /// From the footprint to the obstacle's edges where they are nearest.
  Line shortestLine(Real t) const;
  /// Whether now one is wholly within the other; both are solid, lines and points have no inside.
  bool isWithinNow() const;
  /// Signed gap now: negative where one is inside the other.
  Real clearance() const;

  /// Of one segment with the obstacle's boundary.
  FirstTouch firstTouchOfSegment(std::size_t segment) const;
  std::vector<FirstTouch> firstTouchOfEachSegment() const;
  /// Of the solid footprint.
  FirstTouch firstTouch() const { return firstTouch(firstTouchOfEachSegment()); }
  /// The same where those of the segments are known.
  FirstTouch firstTouch(const std::vector<FirstTouch>& of_segments) const;
  SmallestGap smallestGap() const;

 private:
  FootprintCase case_;
  Point origin_;  // far from the frame's origin even 64 bits would be short
  std::vector<Line> segments_;
  MovingOutline outline_;
};

}  // namespace footprint_collision_predictor::test
