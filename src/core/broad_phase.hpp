// The broad phase: which obstacles may touch at all? Most cannot, and are thrown away by a bound
// that is never wrong, without a branch.
//
// The footprint lies in a circle about its centroid, an obstacle in one about its position. Within
// a window of time both move along their chords, but for a bulge of at most |acceleration| T^2 / 8.
// Two circles that move along chords are a point and a disc: what decides is how far apart they are
// when they are nearest, or, when the disc grows, the sign of a quadratic. Long windows are cut
// where the bulges get large.
//
// One loop over a structure of arrays, compiled for several instruction sets, in four versions that
// leave out what no obstacle needs. All sets give the same bits: no operation is reordered or
// contracted.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "footprint_collision_predictor/obstacle_batch.hpp"
#include "footprint_collision_predictor/polygon.hpp"

namespace footprint_collision_predictor::core {

enum class InstructionSet { kBaseline, kAvx2, kAvx512 };

bool isSupported(InstructionSet set);
/// The widest that this processor supports.
InstructionSet widestInstructionSet();

/// The circle around a footprint, on its way.
class SweptFootprint {
 public:
  static constexpr std::size_t kMostWindows = 8;

  /// \param obstacle_acceleration [m/s^2] the largest of any obstacle it is held against
  SweptFootprint(const Polygon& footprint, const Twist& twist, double horizon,
                 double obstacle_acceleration);

  /// [m] in the footprint's frame; everything else is relative to it, so that nothing is lost far
  /// from the frame's origin.
  const Vec2& centroid() const { return centroid_; }
  bool turns() const { return turns_; }
  /// A stretch of time in which the circle moves along a chord.
  struct Window {
    double start;     ///< [s]
    double duration;  ///< [s]
    Vec2 centre;      ///< [m] at the start, relative to the centroid now
    Vec2 velocity;    ///< [m/s] along the chord
    double radius;    ///< [m] with what the path leaves the chord by, and for rounding
  };
  /// [s]
  double horizon() const { return horizon_; }
  const Window* begin() const { return windows_.data(); }
  const Window* end() const { return windows_.data() + count_; }

 private:
  Vec2 centroid_;
  std::array<Window, kMostWindows> windows_;
  std::size_t count_;
  double horizon_;
  bool turns_;
};

constexpr std::size_t kBlock = 256;

/// Finds the obstacles of [begin, end), at most kBlock of them, that may come within `gap` [m] of
/// the footprint; the others certainly do not.
/// \param candidates their indices, in order
/// \return how many there are
std::size_t findCandidates(const ObstacleBatch& obstacles, std::size_t begin, std::size_t end,
                           const SweptFootprint& footprint, double gap, InstructionSet set,
                           std::array<std::size_t, kBlock>* candidates);

/// The same question for a single one.
bool mayComeWithin(double gap, const SweptFootprint& footprint, const Disc& disc,
                   double bounding_radius);

/// Whether a single obstacle may touch the footprint.
bool mayTouch(const Polygon& footprint, const Twist& twist, const Disc& disc,
              double bounding_radius, double horizon);

/// The same question for now alone.
bool mayComeWithin(double gap, const Polygon& footprint, const Disc& disc, double bounding_radius);

}  // namespace footprint_collision_predictor::core
