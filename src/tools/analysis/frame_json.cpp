#include "frame_json.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>
#include <vector>

#include "csv_line.hpp"

namespace footprint_collision_predictor::tools {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

// Vertices of an outline that are kept, at most: of longer ones every second, third, ...
constexpr std::size_t kMostVertices = 60;

// Whole numbers beyond are not exact in JavaScript.
constexpr std::int64_t kLargestExact = std::int64_t{1} << 53;

std::string number(double value) {
  if (std::isnan(value)) return "\"?\"";
  return std::isinf(value) ? "null" : digits(value);
}

/// In ten-thousandths, so that it is short.
std::string whole(double value) { return std::to_string(std::llround(1e4 * value)); }

/// Rounded to a thousandth.
std::string shortTime(double seconds) {
  if (!std::isfinite(seconds)) return number(seconds);
  return digits(static_cast<double>(std::llround(1e3 * seconds)) / 1e3);
}

std::string idText(std::int64_t id) {
  if (id < 0) return "null";
  return id > kLargestExact ? '"' + std::to_string(id) + '"' : std::to_string(id);
}

template <typename Values, typename Text>
std::string list(const Values& values, const Text& text) {
  std::string json = "[";
  for (const auto& value : values) {
    if (json.size() > 1) json += ',';
    json += text(value);
  }
  return json + ']';
}

std::string pair(double x, double y) { return '[' + whole(x) + ',' + whole(y) + ']'; }

std::string vertices(const std::vector<core::Vec2>& path) {
  const std::size_t step = (path.size() + kMostVertices - 1) / kMostVertices;
  std::vector<core::Vec2> kept;
  for (std::size_t i = 0; i < path.size(); i += step) kept.push_back(path[i]);
  return list(kept, [](const core::Vec2& v) { return pair(v.x(), v.y()); });
}

/// An obstacle that is drawn.
struct Drawn {
  double time_to_collision;  // [s]
  double distance;           // [m] squared
  std::size_t place;         // in the scene

  bool operator<(const Drawn& other) const {
    return std::tie(time_to_collision, distance, place) <
           std::tie(other.time_to_collision, other.distance, other.place);
  }
};

/// The earliest contact that names an obstacle, by the obstacle's place in its message.
std::map<std::int32_t, double> contactTimes(const Answer& answer) {
  std::map<std::int32_t, double> times;
  const auto note = [&](std::int32_t index, double time) {
    const auto known = times.emplace(index, time).first;
    known->second = std::min(known->second, time);
  };
  for (const SegmentPrediction& segment : answer.prediction->segments)
    if (segment.collision_predicted != 0) note(segment.obstacle_index, segment.time_to_collision);
  if (answer.warning.collision_predicted != 0)
    note(obstacleIndexOf(answer), answer.warning.time_to_collision);
  return times;
}

/// In the order of their importance.
std::vector<Drawn> drawn(const Evaluation& evaluation) {
  const auto times = contactTimes(evaluation.answer);
  const SceneObstacles& obstacles = evaluation.scene->obstacles;
  std::vector<Drawn> all;
  for (std::size_t i = 0; i < obstacles.in_body.size(); ++i) {
    const auto time = times.find(obstacles.keys[i].index);
    all.push_back({time == times.end() ? kNever : time->second,
                   obstacles.in_body[i].motion().position.squaredNorm(), i});
  }
  const std::size_t kept = std::min(all.size(), kMostObstaclesKept);
  std::partial_sort(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(kept), all.end());
  all.resize(kept);
  return all;
}

std::string obstacleJson(const core::Obstacle& obstacle, const ObstacleKey& key, double time) {
  const core::Motion& m = obstacle.motion();
  std::string json = '[' + std::to_string(key.index) + ',' + idText(key.id) + ',' +
                     shortTime(time) + ',' + whole(m.position.x()) + ',' + whole(m.position.y()) +
                     ',' + whole(m.velocity.x()) + ',' + whole(m.velocity.y()) + ',' +
                     whole(obstacle.radius());
  const double growth = obstacle.disc().radius_rate;
  if (!m.acceleration.isZero(0) || growth > 0 || !obstacle.outline().empty())
    json += ',' + whole(m.acceleration.x()) + ',' + whole(m.acceleration.y()) + ',' +
            whole(growth) + ',' + vertices(obstacle.outline());
  return json + ']';
}

std::string sceneJson(const Evaluation& evaluation) {
  const CollisionWarning& warning = evaluation.answer.warning;
  const auto& segments = evaluation.answer.prediction->segments;
  const Scene& scene = *evaluation.scene;
  const std::vector<Drawn> kept = drawn(evaluation);
  const auto& all = scene.obstacles;
  return "[[" + whole(scene.twist.linear.x()) + ',' + whole(scene.twist.linear.y()) + ',' +
         whole(scene.twist.angular) + "]," +
         pair(warning.contact_point.x, warning.contact_point.y) + ',' +
         list(segments, [](const auto& segment) { return shortTime(segment.time_to_collision); }) +
         ',' +
         list(kept,
              [&](const Drawn& d) {
                return obstacleJson(all.in_body[d.place], all.keys[d.place], d.time_to_collision);
              }) +
         ',' + std::to_string(all.in_body.size() - kept.size()) + ',' +
         list(scene.footprint.vertices(), [](const core::Vec2& v) { return pair(v.x(), v.y()); }) +
         ']';
}

}  // namespace

std::string frameJson(const Evaluation& evaluation) {
  const CollisionWarning& w = evaluation.answer.warning;
  return '[' + digits(evaluation.elapsed) + ',' + std::to_string(w.level) + ',' +
         number(w.time_to_collision) + ',' + number(w.clearance) + ',' + number(w.closing_speed) +
         ',' + idText(w.segment) + ',' + idText(w.obstacle_id) + ',' + std::to_string(w.reason) +
         ',' + (evaluation.scene == nullptr ? "null" : sceneJson(evaluation)) + ']';
}

}  // namespace footprint_collision_predictor::tools
