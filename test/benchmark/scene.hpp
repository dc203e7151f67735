// The inputs of the benchmark: one footprint and many obstacles, made from a seed. Many different
// ones, since a processor learns the branches of a short list by heart.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "footprint_collision_predictor/motion.hpp"

namespace footprint_collision_predictor::bench {

using core::Disc;
using core::Obstacle;
using core::Polygon;
using core::Segment;
using core::Twist;
using core::Vec2;

constexpr double kHorizon = 5;          // [s] the node's default
constexpr std::size_t kInputs = 65536;  // more than branch predictors remember
constexpr std::uint64_t kSeed = 20240229;

/// What moves how: discs with constant velocity, discs with constant acceleration, a footprint that
/// turns at 0.5 rad/s among discs with constant velocity, discs that grow, lines that stand still.
enum class Kind { kStraight, kAccelerating, kTurning, kGrowing, kWalls };

/// When the contacts are. In a list of kMixed ones, something soon touches, and whoever narrows the
/// horizon to that has little left to do. kLate ones leave no such way out: nothing touches before
/// nine tenths of the horizon are over.
enum class Contacts { kMixed, kLate };

constexpr double kLate = 0.9 * kHorizon;  // [s]

/// "straight", "accelerating", ...
std::string nameOf(Kind kind);
/// "mixed" or "late".
std::string nameOf(Contacts contacts);

/// One footprint and discs of 0.1 to 0.6 m, or lines of 0.5 to 3 m, as far away as 10 m. Of the
/// mixed ones about one in ten hits within the horizon and one in a hundred touches now. None
/// starts wholly inside the footprint.
struct Scene {
  std::string footprint_name;  ///< its number of edges, or "concave"
  Kind kind;
  Contacts contacts;
  Polygon footprint;
  std::vector<Polygon> convex_parts;  ///< the same area, for engines that know convex shapes only
  Twist twist;
  std::vector<Obstacle> obstacles;  ///< over ground

  /// "mixed/straight/8"
  std::string name() const;
  /// As seen from a footprint that does not turn, else over ground. The same for everybody: nobody
  /// is spared the subtraction.
  Disc seen(std::size_t i) const;
};

/// A robot of about 1 x 0.7 m: as many vertices on an ellipse, at uneven distances.
Scene convexScene(int edges, Kind kind, Contacts contacts, std::size_t obstacles);
/// A forklift seen from above: 8 edges, open at the front; its body and two forks.
Scene concaveScene(Kind kind, Contacts contacts, std::size_t obstacles);

std::vector<Segment> segmentsOf(const Polygon& footprint);

/// Where the footprint's frame is at time t, in that of t = 0.
struct Pose {
  Vec2 position;
  double cosine;
  double sine;

  Vec2 toFrame(const Vec2& p) const {
    const Vec2 from_here = p - position;
    return {cosine * from_here.x() + sine * from_here.y(),
            cosine * from_here.y() - sine * from_here.x()};
  }
};

/// After a straight line or an arc.
Pose poseAt(const Twist& twist, double t);

}  // namespace footprint_collision_predictor::bench
