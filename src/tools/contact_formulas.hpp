// When a circle touches a segment, by formulas short enough to check by hand.
//
// None of this uses the solver of the core: a solver that is checked against itself is not checked.
//
// A circle of radius r touches a segment exactly while its centre is within r of it, that is in the
// union of two discs of radius r round the ends and the rectangle between them. As seen from the
// robot the centre moves on a line or on a circle; where that meets the border of each of the three
// is known in closed form.
#pragma once

#include <optional>

namespace footprint_collision_predictor::tools {

struct Point {
  double x;
  double y;
};

struct Line {
  Point start;
  Point end;
};

double distance(const Point& p, const Line& segment);

/// Time [s] from now to the first touch of a circle whose centre moves from `p` with velocity `v`
/// [m/s] and acceleration `a` [m/s^2], which must not work against v, nor across it, so that the
/// centre goes along a line and never turns back. 0 when touching now; nothing when never.
std::optional<double> straightContact(const Point& p, const Point& v, const Point& a, double radius,
                                      const Line& segment);

/// The same for a centre that goes round `about`, clockwise at `rate` [rad/s] > 0.
std::optional<double> roundContact(const Point& p, const Point& about, double rate, double radius,
                                   const Line& segment);

}  // namespace footprint_collision_predictor::tools
