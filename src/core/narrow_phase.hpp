// The narrow phase: the exact answer for one obstacle that the broad phase has let through.
#pragma once

#include <cstddef>
#include <optional>

#include "footprint_collision_predictor/predictor.hpp"
#include "shape.hpp"

namespace footprint_collision_predictor::core {

/// One obstacle beside the footprint.
class NarrowPhase {
 public:
  /// The arguments must outlive it.
  NarrowPhase(const Polygon& footprint, const Twist& twist, const Shape& shape, double horizon);

  /// First contact of segment i within the horizon. It may be left out when it is later than
  /// `until`.
  std::optional<Contact> contactOf(std::size_t i, double until) const;

 private:
  bool staysAway(const Edge& edge, double until) const;
  std::optional<Contact> contactWithOutline(const Edge& edge) const;

  const Polygon& footprint_;
  const Twist& twist_;
  const Shape& shape_;
  double horizon_;
  Disc relative_;    ///< the motion as seen from the footprint, as long as that does not turn
  double rounding_;  ///< [m] more than any gap can be off
};

/// The first contact of a footprint, and the segment.
struct FirstTouch {
  Contact contact;
  std::size_t segment;
};

/// First contact with an obstacle that does not overlap the footprint now. It may be left out when
/// it is later than `until`.
std::optional<FirstTouch> firstTouch(const Polygon& footprint, const Twist& twist,
                                     const Shape& shape, double horizon, double until);

/// The contact at 0 with an obstacle that overlaps the solid footprint at its nearest place.
FootprintContact contactNow(const Polygon& footprint, const Twist& twist, const Shape& shape,
                            const Nearest& nearest);

/// A first touch told for the footprint: on a corner for the lower index.
FootprintContact contactLater(const Polygon& footprint, const Twist& twist, const Shape& shape,
                              const FirstTouch& touch);

/// The other segment at the vertex that a contact names; the same one when it is inside of it.
std::size_t neighbourAt(const Polygon& footprint, Feature feature, std::size_t segment);

}  // namespace footprint_collision_predictor::core
