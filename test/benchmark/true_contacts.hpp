// When contacts truly are: by the 113-bit oracle where polynomials tell it (discs seen from a
// footprint that does not turn), else by that of whole footprints.
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "scene.hpp"

namespace footprint_collision_predictor::bench {

/// "No contact within the horizon", so that answers are plain numbers.
constexpr double kNever = std::numeric_limits<double>::infinity();

/// The first contact: not before `free_until`, and no later than `contact_at`, either of which may
/// be kNever. The same to 1e-10 s, but for a graze of which nobody can tell.
struct Truth {
  double free_until = kNever;
  double contact_at = kNever;
};

/// The first of two.
Truth first(const Truth& a, const Truth& b);

/// Places in a list: [begin, end).
struct Range {
  std::size_t begin;
  std::size_t end;
};

/// When do any of these obstacles first touch any of these segments? One segment or all of them.
struct Question {
  const Scene* scene;
  Range segments;
  Range obstacles;
};

/// The first contact within the horizon when all radii are grown by `growth` [m].
Truth truth(const Question& question, double growth = 0);

/// A scene's true answers. Of its first kInputs obstacles they are remembered one by one, since
/// they are asked for in lists of many sizes.
class SceneTruths {
 public:
  explicit SceneTruths(const Scene& scene);

  /// The first contact of each segment with any of these obstacles.
  std::vector<Truth> ofSegments(const Range& obstacles) const;
  /// Of the whole footprint.
  Truth ofFootprint(const Range& obstacles) const;

 private:
  const Scene& scene_;
  std::vector<std::vector<Truth>>
      known_;  // of each obstacle, of each segment; none if none touches
};

}  // namespace footprint_collision_predictor::bench
