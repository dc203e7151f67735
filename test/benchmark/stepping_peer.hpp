// Time stepping, as collision monitors do: the disc's distance to the solid footprint at each step.
#pragma once

#include <vector>

#include "score.hpp"

namespace footprint_collision_predictor::bench {

/// Written to be quick: edges prepared once, squared distances, no division, ends at the first hit.
/// A footprint that turns is carried along the exact arc: its pose at each step is known before, as
/// all obstacles share it, and the disc is brought into its frame.
class SteppingPeer {
 public:
  SteppingPeer(const Scene& scene, double step);

  /// Late by up to a step is what it promises; a touch between two steps is a miss all the same.
  Tolerance tolerance() const { return {0, 1e-9, step_}; }
  double firstContact(const Disc& disc) const;

 private:
  struct Edge {
    Vec2 start;
    Vec2 direction;
    double per_length_squared;
  };

  bool touches(const Vec2& centre, double radius_squared) const;

  Vec2 centreAt(const Disc& disc, std::size_t step) const;

  std::vector<Edge> edges_;
  std::vector<Pose> poses_;
  bool turns_;
  double step_;
};

}  // namespace footprint_collision_predictor::bench
