// The narrow phase: the exact answer for one obstacle that the broad phase has let through.
#pragma once

#include <optional>

#include "footprint_collision_predictor/predictor.hpp"
#include "shape.hpp"

namespace footprint_collision_predictor::core {

/// First contact of segment i of the footprint.
std::optional<Contact> contactOf(const Polygon& footprint, std::size_t i, const Twist& twist,
                                 const Shape& shape, double horizon);

/// The contact at 0 with an obstacle that overlaps the solid footprint at its nearest place.
FootprintContact contactNow(const Polygon& footprint, const Twist& twist, const Shape& shape,
                            const Nearest& nearest);

/// A contact of segment i told for the footprint: on a corner for the lower index.
FootprintContact contactLater(const Polygon& footprint, const Twist& twist, const Shape& shape,
                              const Contact& contact, std::size_t i);

/// A touch of a vertex is one of both segments that meet there, at the same time; each has found it
/// by itself, but for rounding. The index of the other one; nothing when the touch is inside.
std::optional<std::size_t> neighbourAt(Feature feature, std::size_t segment, std::size_t size);

}  // namespace footprint_collision_predictor::core
