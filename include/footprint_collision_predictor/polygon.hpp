// A footprint: a simple polygon in either winding, with its area and centroid.
//
// Area and centroid follow the shoelace formulas (Bourke, "Calculating the area and centroid of a
// polygon", 1988), taken relative to the first vertex: far from the origin the products of absolute
// coordinates would cancel and cost all digits.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

#include "footprint_collision_predictor/geometry.hpp"

namespace footprint_collision_predictor::core {

/// Largest absolute coordinate of any input [m]; UTM northings fit.
constexpr double kMaxCoordinate = 1e8;
/// Largest width or height of a footprint [m].
constexpr double kMaxFootprintExtent = 1e4;

/// Thrown for vertices that do not make a footprint; what() names the rule and the vertices.
class InvalidPolygon : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

/// Signed area [m^2]: positive for counter-clockwise vertices, negative for clockwise ones, 0 for
/// fewer than 3.
double signedArea(const std::vector<Vec2>& vertices);

/// Centroid of the enclosed area [m], in either winding.
/// \throws InvalidPolygon when the area is 0.
Vec2 centroid(const std::vector<Vec2>& vertices);

/// The segments as seen from the centroid, where coordinates are small; a value for each.
struct Sides {
  std::vector<double> normal_x, normal_y;  ///< unit vector out of the footprint
  std::vector<double> offset;              ///< [m] of the segment's line along the normal
  std::vector<double> start;               ///< [m] of the segment's start along its direction
  std::vector<double> length;              ///< [m]
  double winding;                          ///< 1 counter-clockwise, -1 clockwise

  Vec2 normal(std::size_t i) const { return {normal_x[i], normal_y[i]}; }
  /// How far [m] a point lies outside of side i.
  double across(std::size_t i, const Vec2& p) const {
    return normal_x[i] * p.x() + normal_y[i] * p.y() - offset[i];
  }
  /// How far [m] a point lies along side i, from its start.
  double along(std::size_t i, const Vec2& p) const {
    return winding * (normal_x[i] * p.y() - normal_y[i] * p.x()) - start[i];
  }
};

/// A valid footprint. Segment i runs from vertex i to vertex i + 1 in the order given, the last one
/// to vertex 0; nothing is ever renumbered, whatever the winding.
class Polygon {
 public:
  /// \param vertices [m] at least 3; collinear neighbours, very short edges and concave shapes are
  ///     fine, in either winding.
  /// \throws InvalidPolygon for fewer than 3 vertices, a coordinate that is not finite or beyond
  ///     kMaxCoordinate, an extent beyond kMaxFootprintExtent, equal neighbours, edges that cross
  ///     or touch other than at their common vertex, and no area.
  explicit Polygon(std::vector<Vec2> vertices);

  const std::vector<Vec2>& vertices() const { return vertices_; }
  /// Number of segments, which is also the number of vertices.
  std::size_t size() const { return vertices_.size(); }
  const Edge& segment(std::size_t i) const { return edges_[i]; }
  /// The segment, or vertex, that follows i.
  std::size_t next(std::size_t i) const { return i + 1 == size() ? 0 : i + 1; }
  /// The segment, or vertex, before i.
  std::size_t previous(std::size_t i) const { return (i == 0 ? size() : i) - 1; }
  /// [m^2] > 0, whatever the winding.
  double area() const;
  bool isCounterClockwise() const { return signed_area_ > 0; }
  /// [m]
  const Vec2& centroid() const { return centroid_; }
  /// Whether no vertex turns inwards; straight ones may.
  bool isConvex() const { return is_convex_; }
  const Sides& sides() const { return sides_; }
  /// Distance from the centroid to the farthest vertex [m].
  double boundingRadius() const { return bounding_radius_; }
  /// Whether p lies inside. A point on the boundary may be told either way.
  bool contains(const Vec2& p) const;

 private:
  std::vector<Vec2> vertices_;
  std::vector<Edge> edges_;
  double signed_area_;
  Vec2 centroid_;
  double bounding_radius_;
  bool is_convex_;
  Sides sides_;
};

}  // namespace footprint_collision_predictor::core
