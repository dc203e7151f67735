#include "marker_shapes.hpp"

#include <algorithm>
#include <cmath>

namespace footprint_collision_predictor {
namespace {

constexpr double kPi = 3.14159265358979323846;

// Chords of a full turn.
constexpr int kChords = 32;

// Vertices of a path that is filled, at most: the time grows with their square, or worse.
constexpr std::size_t kMostFilled = 200;

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

/// Without vertices that repeat the one before.
Path counterClockwise(const Path& path) {
  Path result;
  for (std::size_t i = 0; i < path.size(); ++i)
    if (path[i] != path[(i + 1) % path.size()]) result.push_back(path[i]);
  if (result.empty() && !path.empty()) result.push_back(path[0]);
  if (core::signedArea(result) < 0) std::reverse(result.begin(), result.end());
  return result;
}

/// Both ends included.
void addArc(const core::Vec2& centre, double radius, double from, double turn, Path& path) {
  const int chords = std::max(1, static_cast<int>(std::ceil(kChords * turn / (2 * kPi) - 1e-9)));
  for (int i = 0; i <= chords; ++i)
    path.push_back(centre + radius * along(from + turn * i / chords));
}

/// Whether the corner sticks out and nothing else lies in its triangle.
bool isEar(const Path& path, std::size_t corner) {
  const std::size_t n = path.size();
  const core::Vec2 &a = path[(corner + n - 1) % n], &b = path[corner], &c = path[(corner + 1) % n];
  const auto side = [](const core::Vec2& from, const core::Vec2& to, const core::Vec2& p) {
    return core::cross(to - from, p - from);
  };
  return side(a, b, c) > 0 && std::none_of(path.begin(), path.end(), [&](const core::Vec2& p) {
           return p != a && p != b && p != c && side(a, b, p) >= 0 && side(b, c, p) >= 0 &&
                  side(c, a, p) >= 0;
         });
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

Path rounded(const Path& path, double distance) {
  const Path corners = counterClockwise(path);
  const std::size_t n = corners.size();
  if (distance <= 0 || n < 2) return corners;
  Path result;
  for (std::size_t i = 0; i < n; ++i) {
    const core::Vec2 in = (corners[i] - corners[(i + n - 1) % n]).normalized();
    const core::Vec2 out = (corners[(i + 1) % n] - corners[i]).normalized();
    const double turn = std::atan2(core::cross(in, out), in.dot(out));
    const core::Vec2 normal = -core::leftNormal(in);
    if (turn > 0 || turn < 1e-9 - kPi)  // the end of a line may turn either way
      addArc(corners[i], distance, std::atan2(normal.y(), normal.x()), std::abs(turn), result);
    else  // a dent: where the shifted edges meet
      result.push_back(corners[i] + distance / std::max(0.1, 1 + in.dot(out)) *
                                        (normal - core::leftNormal(out)));
  }
  return result;
}

Path outlineAt(const core::Obstacle& obstacle, double t, double least_radius) {
  const core::Vec2 centre = obstacle.motion().positionAt(t);
  const double radius = obstacle.disc().radiusAt(t);
  Path path = rounded(obstacle.outline(), radius);
  for (core::Vec2& vertex : path) vertex += centre;
  if (path.size() >= 2) return path;
  path.clear();  // without an extent, an outline is a circle too
  addArc(centre + (obstacle.outline().empty() ? core::Vec2(0, 0) : obstacle.outline()[0]),
         std::max(radius, least_radius), 0, 2 * kPi * (1 - 1.0 / kChords), path);
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
  if (path.size() > kMostFilled) return;
  Path left = counterClockwise(path);
  while (left.size() >= 3) {
    std::size_t ear = 0;
    while (ear < left.size() && !isEar(left, ear)) ++ear;
    if (ear == left.size()) return;
    for (const std::size_t corner : {ear + left.size() - 1, ear, ear + 1})
      triangles.push_back(pointAt(left[corner % left.size()], z));
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(ear));
  }
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
