// One evaluation as report.html keeps it.
#pragma once

#include <string>

#include "replay.hpp"

namespace footprint_collision_predictor::tools {

/// Obstacles of a frame that are kept, at most: those that touch something first, then the nearest.
constexpr std::size_t kMostObstaclesKept = 60;

/// A compact JSON array that data.js reads:
///     [elapsed, level, time_to_collision, clearance, closing_speed, segment, obstacle_id, reason,
///      scene]
/// A number that is infinite ("none") is null, one that is not known "?". The scene is null without
/// a prediction, else
///     [[vx, vy, yaw rate], [contact x, y], [time to collision of each segment], obstacles,
///      number of obstacles left out, footprint's vertices]
/// and an obstacle
///     [index, id, time to collision, x, y, vx, vy, radius]
/// with [ax, ay, radius_rate, outline] behind it where they are not all zero. Lengths and rates of
/// the scene are whole multiples of 1e-4 of their unit, in the footprint's frame; its times are
/// rounded to 1e-3 s.
std::string frameJson(const Evaluation& evaluation);

}  // namespace footprint_collision_predictor::tools
