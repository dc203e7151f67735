#include "marker_shapes.hpp"

#include <algorithm>
#include <cmath>

namespace footprint_collision_predictor {
namespace {

constexpr double kPi = 3.14159265358979323846;

// Chords of a full turn.
constexpr int kChords = 32;

// Of one path at most, since a path may be thousands of kilometres long.
constexpr double kMostDashes = 200;

geometry_msgs::Point pointAt(const core::Vec2& p, double z) {
  geometry_msgs::Point point;
  point.x = p.x();
  point.y = p.y();
  point.z = z;
  return point;
}

core::Vec2 along(double angle) { return {std::cos(angle), std::sin(angle)}; }

double lengthOf(const Path& path) {
  double length = 0;
  for (std::size_t i = 0; i < path.size(); ++i)
    length += (path[(i + 1) % path.size()] - path[i]).norm();
  return length;
}

/// Lays dashes along a path, going on with the pattern from edge to edge.
class Dasher {
 public:
  Dasher(const Style& style, double unit, double length)
      : dash_(std::max(style.dash * unit,
                       style.dash / (style.dash + style.gap) * length / kMostDashes)),
        period_(dash_ * (1 + style.gap / style.dash)) {}

  void addEdge(const core::Vec2& from, const core::Vec2& to, double z, Points& lines) {
    const double length = (to - from).norm();
    if (length == 0) return;
    const core::Vec2 direction = (to - from) / length;
    double at = -phase_;
    for (; at < length; at += period_) {
      const double begin = std::max(0.0, at);
      const double end = std::min(length, at + dash_);
      if (end <= begin) continue;
      lines.push_back(pointAt(from + begin * direction, z));
      lines.push_back(pointAt(from + end * direction, z));
    }
    phase_ = length - (at - period_);
  }

 private:
  double dash_;
  double period_;
  double phase_ = 0;  // how far into the pattern the next edge begins
};

/// Thick lines end bluntly: longer by this [m], those of neighbouring edges meet at the outside of
/// their corner.
double overlap(const core::Vec2& edge, const core::Vec2& next, double width) {
  const double turn = std::abs(std::atan2(core::cross(edge, next), edge.dot(next)));
  return 0.5 * width * std::min(1.0, std::tan(std::min(turn, 0.5 * kPi) / 2));
}

void addSolid(const core::Vec2& from, const core::Vec2& to, double before, double after, double z,
              Points& lines) {
  const core::Vec2 edge = to - from;
  const double length = edge.norm();
  if (length == 0) return;
  lines.push_back(pointAt(from - before / length * edge, z));
  lines.push_back(pointAt(to + after / length * edge, z));
}

}  // namespace

PlanarPose poseAfter(const core::Twist& twist, double t) {
  const double turned = twist.angular * t;
  // The chord of the arc: it points half the turn aside, and is shorter by sin(x) / x.
  const double half = turned / 2;
  const double chord = std::abs(half) < 1e-9 ? 1 : std::sin(half) / half;
  const PlanarPose direction{{0, 0}, along(half)};
  return {direction.vectorFromLocal(twist.linear * (t * chord)), along(turned)};
}

Path outlineAt(const core::Obstacle& obstacle, double t, double least_radius) {
  const core::Vec2 centre = obstacle.motion().positionAt(t);
  const double radius = std::max(obstacle.radius(), least_radius);
  Path path;
  path.reserve(kChords);
  for (int i = 0; i < kChords; ++i) path.push_back(centre + radius * along(2 * kPi * i / kChords));
  return path;
}

Path posed(const Path& path, const PlanarPose& pose) {
  Path moved;
  moved.reserve(path.size());
  for (const core::Vec2& p : path) moved.push_back(pose.position + pose.vectorFromLocal(p));
  return moved;
}

void addLine(const core::Vec2& from, const core::Vec2& to, const Style& style, double unit,
             double z, Points& lines) {
  if (style.dash > 0) return Dasher(style, unit, (to - from).norm()).addEdge(from, to, z, lines);
  const double half = 0.5 * style.width * unit;
  addSolid(from, to, half, half, z, lines);
}

void addClosed(const Path& path, const Style& style, double unit, double z, Points& lines) {
  const std::size_t n = path.size();
  const auto edge = [&](std::size_t i) -> core::Vec2 { return path[(i + 1) % n] - path[i % n]; };
  const auto corner = [&](std::size_t i) {  // at the end of edge i
    return overlap(edge(i), edge(i + 1), style.width * unit);
  };
  if (style.dash > 0) {
    Dasher dasher(style, unit, lengthOf(path));
    for (std::size_t i = 0; i < n; ++i) dasher.addEdge(path[i], path[(i + 1) % n], z, lines);
    return;
  }
  for (std::size_t i = 0; i < n; ++i)
    addSolid(path[i], path[(i + 1) % n], corner(i + n - 1), corner(i), z, lines);
}

void addFilled(const Path& path, double z, Points& triangles) {
  for (std::size_t i = 2; i < path.size(); ++i)
    for (const std::size_t corner : {std::size_t{0}, i - 1, i})
      triangles.push_back(pointAt(path[corner], z));
}

void addArrow(const core::Vec2& from, const core::Vec2& to, double head, double z, Points& lines) {
  const double length = (to - from).norm();
  if (length == 0) return;
  const core::Vec2 back = std::min(head, 0.5 * length) / length * (from - to);
  const core::Vec2 aside = 0.5 * core::leftNormal(back);
  for (const core::Vec2& tail :
       {from, core::Vec2(to + back + aside), core::Vec2(to + back - aside)}) {
    lines.push_back(pointAt(tail, z));
    lines.push_back(pointAt(to, z));
  }
}

}  // namespace footprint_collision_predictor
