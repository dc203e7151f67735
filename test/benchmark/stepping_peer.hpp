// Time stepping, as collision monitors do: the disc's distance to the solid footprint at each step.
#pragma once

#include <vector>

#include "score.hpp"

namespace footprint_collision_predictor::bench {

/// Written to be quick: edges prepared once, squared distances, no division, ends at the first hit.
class SteppingPeer {
 public:
  SteppingPeer(const Polygon& footprint, double step);

  /// Late by up to a step is what it promises; a touch between two steps is a miss all the same.
  Tolerance tolerance() const { return {0, 1e-9, step_}; }
  double firstContact(const Motion& circle, double radius) const;

 private:
  struct Edge {
    Vec2 start;
    Vec2 direction;
    double per_length_squared;
  };

  bool touches(const Vec2& centre, double radius_squared) const;

  std::vector<Edge> edges_;
  double step_;
};

}  // namespace footprint_collision_predictor::bench
