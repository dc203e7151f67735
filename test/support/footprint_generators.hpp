// Random footprints among random obstacles, by the kind of trouble they make.
#pragma once

#include <vector>

#include "footprint_case.hpp"
#include "random.hpp"

namespace footprint_collision_predictor::test {

/// What the obstacles and the footprint of a suite do.
struct Moves {
  bool accelerates = false;
  bool grows = false;
  bool turns = false;
  bool has_outline = false;
};

/// 3 to 8 corners, convex or not, in either winding, around the origin or beside it.
std::vector<Vec2> anyFootprint(Random& random);

/// A line, or a polygon with 3 to 8 corners, convex or not, 1e-2 to 20 m large.
std::vector<Vec2> anyOutline(Random& random);

/// Up to 10 rad/s and 5 m/s, or standing still.
core::Twist anyTwist(Random& random, bool turns);

/// Everything drawn widely; most obstacles are aimed at the footprint.
FootprintCase anyFootprintCase(Random& random, const Moves& moves);

/// At some moment the gap is 0 but for 1e-15 .. 1e-3 m, and the nearest points of the two pass each
/// other: alongside, or closing or parting slowly.
FootprintCase grazingFootprint(Random& random, const Moves& moves);

/// A circle, or in one half a point, touches a side just beside a vertex, at a shallow angle. It
/// has no outline.
FootprintCase sinkingFootprint(Random& random, const Moves& moves);

/// A circle, a point or the end of a line is on a side now, but for up to 1e-12 m within or
/// without. Every other footprint is a sliver.
FootprintCase touchingSideNow(Random& random);

/// An edge of the outline is on one line with a side, but for rounding, and overlaps it or not; it
/// stands or slides along it.
FootprintCase inLineWithASide(Random& random);

/// Whether it is one that Polygon takes.
bool isFootprint(const std::vector<Vec2>& vertices);

/// What make() makes, the first that has a footprint: where its vertices are moved and rounded, a
/// tiny edge or the gap between two may be none any more.
template <typename Make>
auto withFootprint(const Make& make) {
  auto made = make();
  while (!isFootprint(made.footprint)) made = make();
  return made;
}

/// The same outline elsewhere in the obstacle's frame, and the obstacle's position so much off.
FootprintCase outlineToldFromAfar(const FootprintCase& c, const Vec2& by);

/// The same with lengths and times so many times as large, and what follows from these.
FootprintCase scaled(const FootprintCase& c, double length, double time);

/// The same elsewhere in the footprint's frame; the twist stays that of the frame's origin.
FootprintCase translated(const FootprintCase& c, const Vec2& by);

}  // namespace footprint_collision_predictor::test
