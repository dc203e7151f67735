#include "contact_formulas.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace footprint_collision_predictor::tools {
namespace {

constexpr double kTurn = 2 * 3.14159265358979323846;

Point operator-(const Point& a, const Point& b) { return {a.x - b.x, a.y - b.y}; }
double dot(const Point& a, const Point& b) { return a.x * b.x + a.y * b.y; }
double cross(const Point& a, const Point& b) { return a.x * b.y - a.y * b.x; }
double length(const Point& p) { return std::hypot(p.x, p.y); }
Point unit(const Point& p) { return {p.x / length(p), p.y / length(p)}; }
Point turnedLeft(const Point& p) { return {-p.y, p.x}; }

/// A way along a line, from begin to end [m]; empty when begin > end.
struct Stretch {
  double begin;
  double end;
};

/// Where p + s d, with |d| = 1, is within `radius` of c.
Stretch inDisc(const Point& p, const Point& d, const Point& c, double radius) {
  const double middle = dot(c - p, d);
  const double off = cross(c - p, d);
  const double half = radius * radius - off * off;
  if (half < 0) return {1, 0};
  return {middle - std::sqrt(half), middle + std::sqrt(half)};
}

/// Where low <= value + s slope <= high.
Stretch between(double value, double slope, double low, double high) {
  constexpr double kEverywhere = 1e9;  // [m]
  if (slope == 0)
    return value >= low && value <= high ? Stretch{-kEverywhere, kEverywhere} : Stretch{1, 0};
  const double a = (low - value) / slope;
  const double b = (high - value) / slope;
  return {std::min(a, b), std::max(a, b)};
}

/// Where p + s d is beside the segment, at most `radius` away.
Stretch inRectangle(const Point& p, const Point& d, double radius, const Line& segment) {
  const Point along = unit(segment.end - segment.start);
  const Point across = turnedLeft(along);
  const Point offset = p - segment.start;
  const double extent = length(segment.end - segment.start);
  const Stretch beside = between(dot(offset, along), dot(d, along), 0, extent);
  const Stretch near = between(dot(offset, across), dot(d, across), -radius, radius);
  return {std::max(beside.begin, near.begin), std::min(beside.end, near.end)};
}

/// The time to go a way of s >= 0 with speed v and acceleration a, both >= 0.
std::optional<double> timeFor(double s, double v, double a) {
  if (v == 0 && a == 0) return std::nullopt;
  return 2 * s / (v + std::sqrt(v * v + 2 * a * s));
}

/// Angles at which radius * cos(angle) is the value.
void addCosine(double value, double radius, double zero, std::vector<double>& angles) {
  if (std::abs(value) > radius) return;
  const double angle = std::acos(value / radius);
  angles.push_back(zero + angle);
  angles.push_back(zero - angle);
}

/// Directions, from the centre of a circle of `rho` round the origin, of all points of it that are
/// on a border of one of the three sets; among them all at which a touch begins.
std::vector<double> borders(double rho, double radius, const Line& segment) {
  std::vector<double> angles;
  for (const Point& end : {segment.start, segment.end}) {
    // rho^2 + |end|^2 - 2 rho |end| cos = radius^2
    const double reach = length(end);
    const double value = (rho * rho + reach * reach - radius * radius) / (2 * reach);
    addCosine(value, rho, std::atan2(end.y, end.x), angles);
  }
  const Point across = turnedLeft(unit(segment.end - segment.start));
  const double direction = std::atan2(across.y, across.x);
  const double offset = dot(segment.start, across);
  for (const double side : {-radius, radius}) addCosine(offset + side, rho, direction, angles);
  return angles;
}

}  // namespace

double distance(const Point& p, const Line& segment) {
  const Point along = segment.end - segment.start;
  const double share = std::clamp(dot(p - segment.start, along) / dot(along, along), 0.0, 1.0);
  const Point foot = {segment.start.x + share * along.x, segment.start.y + share * along.y};
  return length(p - foot);
}

std::optional<double> straightContact(const Point& p, const Point& v, const Point& a, double radius,
                                      const Line& segment) {
  if (distance(p, segment) <= radius) return 0;
  const Point motion = length(v) > 0 ? v : a;
  if (length(motion) == 0) return std::nullopt;
  const Point d = unit(motion);
  std::optional<double> first;
  for (const Stretch& stretch :
       {inDisc(p, d, segment.start, radius), inDisc(p, d, segment.end, radius),
        inRectangle(p, d, radius, segment)})
    if (stretch.begin <= stretch.end && stretch.begin >= 0)
      first = std::min(first.value_or(stretch.begin), stretch.begin);
  return first ? timeFor(*first, length(v), length(a)) : std::nullopt;
}

std::optional<double> roundContact(const Point& p, const Point& about, double rate, double radius,
                                   const Line& segment) {
  if (distance(p, segment) <= radius) return 0;
  const Line moved = {segment.start - about, segment.end - about};
  const Point from = p - about;
  const double rho = length(from);
  std::optional<double> first;
  for (const double angle : borders(rho, radius, moved)) {
    constexpr double kRounding = 1e-9;  // [m]
    if (distance({rho * std::cos(angle), rho * std::sin(angle)}, moved) > radius + kRounding)
      continue;  // on the line's continuation, beyond an end
    const double way = std::fmod(std::atan2(from.y, from.x) - angle + 2 * kTurn, kTurn);
    first = std::min(first.value_or(way), way);
  }
  return first ? std::optional<double>(*first / rate) : std::nullopt;
}

}  // namespace footprint_collision_predictor::tools
