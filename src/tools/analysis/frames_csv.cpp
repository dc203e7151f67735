#include "frames_csv.hpp"

#include <algorithm>

#include "csv_line.hpp"

namespace footprint_collision_predictor::tools {
namespace {

// Units and meanings are those of CollisionWarning's fields of the same names.
constexpr const char* kColumns =
    "time,elapsed,level,time_to_collision,contact_free_time,collision_predicted,segment,"
    "obstacle_id,obstacle_index,contact_x,contact_y,clearance,closest_distance,closest_time,"
    "closing_speed,data_age,obstacle_count,reason,silence,velocity_x,velocity_y,yaw_rate";

constexpr std::size_t kColumnCount = 22;

}  // namespace

std::string framesHeader(std::size_t segments) {
  std::string header = kColumns;
  for (std::size_t i = 0; i < segments; ++i) header += ",time_to_collision_" + std::to_string(i);
  return header;
}

std::string framesRow(const Evaluation& evaluation) {
  const CollisionWarning& w = evaluation.answer.warning;
  const auto& prediction = evaluation.answer.prediction;
  const auto whole = [](auto value) { return static_cast<std::int64_t>(value); };
  CsvLine line;
  line.add(w.header.stamp).add(evaluation.elapsed).add(whole(w.level));
  line.add(w.time_to_collision).add(w.contact_free_time).add(whole(w.collision_predicted));
  line.add(whole(w.segment)).add(w.obstacle_id).add(whole(obstacleIndexOf(evaluation.answer)));
  line.add(w.contact_point.x).add(w.contact_point.y);
  line.add(w.clearance).add(w.closest_distance).add(w.closest_time).add(w.closing_speed);
  line.add(w.data_age).add(whole(w.obstacle_count)).add(whole(w.reason));
  line.add(whole(evaluation.silence));
  const geometry_msgs::Twist twist = prediction ? prediction->twist : geometry_msgs::Twist();
  line.add(twist.linear.x).add(twist.linear.y).add(twist.angular.z);
  if (prediction)
    for (const SegmentPrediction& segment : prediction->segments)
      line.add(segment.time_to_collision);
  return line.text();
}

std::string framesRowEnd(std::size_t segments_in_row, std::size_t segments,
                         const RowOrigin& origin) {
  return std::string(segments - segments_in_row, ',') + originColumns(origin);
}

std::size_t segmentsIn(const std::string& row) {
  const auto commas = static_cast<std::size_t>(std::count(row.begin(), row.end(), ','));
  return commas + 1 - kColumnCount;
}

}  // namespace footprint_collision_predictor::tools
