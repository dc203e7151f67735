// The lecture's way with its mistakes mended: each segment is turned onto the x axis by
// trigonometry, both its sides are asked, every root is tried in order, and an overlap at once is
// 0.
#pragma once

#include <vector>

#include "score.hpp"

namespace footprint_collision_predictor::bench {

/// Straight motion: a quadratic for each end and for each side. Accelerating: a quartic for each
/// end, by Eigen's PolynomialSolver (the eigenvalues of the companion matrix).
class LecturePeer {
 public:
  explicit LecturePeer(std::vector<Segment> segments);

  /// First contact with any of the segments. An end that two neighbours share is asked once.
  double firstContact(const Disc& disc) const;

 private:
  std::vector<Segment> segments_;
};

}  // namespace footprint_collision_predictor::bench
