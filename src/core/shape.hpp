// An obstacle as the narrow phase sees it, and how it lies to the footprint at one moment.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "footprint_collision_predictor/obstacle_batch.hpp"
#include "footprint_collision_predictor/polygon.hpp"
#include "footprint_collision_predictor/time_to_collision.hpp"
#include "path.hpp"

namespace footprint_collision_predictor::core {

/// A disc that moves, or what its outline is when rounded by the disc's radius.
struct Shape {
  Disc disc;
  Outline outline;  ///< relative to the disc's centre; empty for a circle
};

/// Adds the edges of the obstacle's outline: one of a line, as many as vertices of a polygon.
void appendOutline(const Obstacle& obstacle, std::vector<Edge>* edges);

/// The nearest place of the footprint's boundary to an obstacle.
struct Nearest {
  std::size_t segment;
  Vec2 point;  ///< [m] of the segment
  double gap;  ///< [m] minus the radius; the distance counts negative where one is inside the other
};

/// How the obstacle lies to the solid footprint now.
Nearest nearestNow(const Polygon& footprint, const Shape& shape);

/// Distance [m] of an edge to the obstacle now, minus the radius.
double gapNow(const Edge& edge, const Shape& shape);

/// Where an edge of the footprint and the obstacle touch or cross now, but for rounding.
std::optional<Vec2> touchNow(const Edge& edge, const Shape& shape);

/// The point of an outline that is nearest to the origin.
/// \param turn of the frame since the outline had its axes
/// \param centre [m] of the outline
/// \param edge_direction of the edge that the point lies on between its ends; nothing at a vertex
Vec2 nearestToOrigin(const Outline& outline, const Turn& turn, const Vec2& centre,
                     std::optional<Vec2>* edge_direction);

/// Which part of the segment a point of it is.
Feature featureOf(const Segment& segment, const Vec2& point);

}  // namespace footprint_collision_predictor::core
