// An obstacle as the narrow phase sees it, and how it lies to the footprint at one moment.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "footprint_collision_predictor/obstacle_batch.hpp"
#include "footprint_collision_predictor/polygon.hpp"
#include "footprint_collision_predictor/time_to_collision.hpp"

namespace footprint_collision_predictor::core {

/// A disc that moves, or what its outline is when rounded by the disc's radius.
struct Shape {
  Disc disc;
  Outline outline;  ///< relative to the disc's centre; empty for a circle
};

/// Distance [m] of the outline's farthest vertex from the obstacle's position.
double farthestVertex(const Obstacle& obstacle);
/// [m] of the circle about the obstacle's position that holds it all now
inline double boundingRadius(const Obstacle& obstacle) {
  return obstacle.outline().empty() ? obstacle.radius()
                                    : obstacle.radius() + farthestVertex(obstacle);
}

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

/// The point of the disc's centre or of the outline that is nearest to p, `dt` [s] later, in the
/// frame of a footprint that has moved on for so long.
/// \param on_edge whether it lies on an outline's edge between its ends, and that edge's direction
Vec2 nearestOf(const Shape& shape, const Twist& footprint, double dt, const Vec2& p,
               std::optional<Vec2>* edge_direction);

/// Which part of the segment a point of it is.
Feature featureOf(const Segment& segment, const Vec2& point);

}  // namespace footprint_collision_predictor::core
