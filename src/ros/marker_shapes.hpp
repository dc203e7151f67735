// Shapes in the plane as the points of markers.
#pragma once

#include <geometry_msgs/Point.h>

#include <vector>

#include "footprint_collision_predictor/motion.hpp"
#include "marker_style.hpp"
#include "planar_pose.hpp"

namespace footprint_collision_predictor {

using Points = std::vector<geometry_msgs::Point>;
using Path = std::vector<core::Vec2>;

/// Where the footprint's frame is `t` [s] later, in the footprint's frame at t = 0.
PlanarPose poseAfter(const core::Twist& twist, double t);

/// The closed path at a distance [m] all round a line or polygon, in either winding. Where edges
/// are shorter than the distance, a dent is drawn with loops.
Path rounded(const Path& path, double distance);

/// The closed path round an obstacle at time t, over ground in the footprint's frame at t = 0: a
/// circle, or its outline rounded by its radius.
/// \param least_radius [m] a smaller circle is drawn as large as this
Path outlineAt(const core::Obstacle& obstacle, double t, double least_radius);

/// The closed path, from the posed frame into that of the pose.
Path posed(const Path& path, const PlanarPose& pose);

/// Adds lines (two points for each) along a path.
/// \param unit [m] that the style's lengths are multiples of
/// \param z [m] height
void addLine(const core::Vec2& from, const core::Vec2& to, const Style& style, double unit,
             double z, Points& lines);
void addClosed(const Path& path, const Style& style, double unit, double z, Points& lines);

/// Adds triangles (three points for each) that fill a closed path in either winding, by cutting off
/// ears. One that crosses itself is filled in part, one of very many vertices not at all.
void addFilled(const Path& path, double z, Points& triangles);

/// Adds an arrow as lines; nothing for one without length.
/// \param head [m] length of its head at most
void addArrow(const core::Vec2& from, const core::Vec2& to, double head, double z, Points& lines);

}  // namespace footprint_collision_predictor
