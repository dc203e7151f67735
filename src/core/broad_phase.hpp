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
// leave out what no obstacle needs. It computes in single precision, which goes twice as fast: what
// that may err by is added to the reach, and positions are told from the first obstacle, so that it
// is little wherever they all are. All sets give the same bits: no operation is reordered or
// contracted.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "footprint_collision_predictor/obstacle_batch.hpp"
#include "footprint_collision_predictor/polygon.hpp"
#include "instruction_set.hpp"
#include "swept_footprint.hpp"

namespace footprint_collision_predictor::core {

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

/// For a single one now.
bool mayComeWithin(double gap, const Polygon& footprint, const Disc& disc, double bounding_radius);

}  // namespace footprint_collision_predictor::core
