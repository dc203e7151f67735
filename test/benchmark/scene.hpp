// The inputs of the benchmark: one footprint and many obstacles, made from a seed. Many different
// ones, since a processor learns the branches of a short list by heart.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "footprint_collision_predictor/motion.hpp"

namespace footprint_collision_predictor::bench {

using core::Motion;
using core::Obstacle;
using core::Polygon;
using core::Segment;
using core::Twist;
using core::Vec2;

constexpr double kHorizon = 5;          // [s] the node's default
constexpr std::size_t kInputs = 65536;  // more than branch predictors remember
constexpr std::uint64_t kSeed = 20240229;

// Turning joins when the core has it: Box2D's sweep and time stepping can turn.
enum class MotionKind { kStraight, kAccelerating };

/// "straight" or "accelerating".
std::string nameOf(MotionKind kind);

/// One footprint and discs of 0.1 to 0.6 m as far away as 10 m, of which about one in ten hits
/// within the horizon and one in a hundred touches now. None starts wholly inside the footprint.
struct Scene {
  std::string name;  ///< of the footprint: its number of edges, or "concave"
  MotionKind kind;
  Polygon footprint;
  std::vector<Polygon> convex_parts;  ///< the same area, for engines that know convex shapes only
  Twist twist;
  std::vector<Obstacle> obstacles;  ///< over ground

  /// The same for everybody: nobody is spared the subtraction.
  Motion relative(std::size_t i) const {
    return core::relativeMotion(obstacles[i].motion(), twist);
  }
};

/// A robot of about 1 x 0.7 m: as many vertices on an ellipse, at uneven distances.
Scene convexScene(int edges, MotionKind kind, std::size_t obstacles);
/// A forklift seen from above: 8 edges, open at the front; its body and two forks.
Scene concaveScene(MotionKind kind, std::size_t obstacles);

std::vector<Segment> segmentsOf(const Polygon& footprint);

}  // namespace footprint_collision_predictor::bench
