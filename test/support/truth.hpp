// When the first contact truly is, by whichever oracle can tell.
#pragma once

#include <optional>

#include "case.hpp"
#include "quad.hpp"

namespace footprint_collision_predictor::test {

/// The first contact, and whether that is for certain.
struct Truth {
  /// A moment at which the disc touches, and the first one if is_decided.
  std::optional<Quad> contact;
  /// False for a graze, of a segment that turns, which intervals of 64 bits cannot tell from a
  /// miss.
  bool is_decided;
};

/// To some 1e-28 s where polynomials tell it, to 1e-12 s (relative for large times) where the
/// segment turns and intervals prove it.
Truth truthOf(const Case& c);

}  // namespace footprint_collision_predictor::test
