// The three obstacle types. Their layouts are those of the packages' published message definitions,
// told apart by md5, so that neither obstacle_detector nor costmap_converter is needed to build.
#include "message_decoding.hpp"
#include "message_fields.hpp"

namespace footprint_collision_predictor {
namespace {

constexpr char kObstacleDetectorMd5[] = "043bbf49c7775f8111e850268dbcf2e3";
constexpr char kCostmapConverterMd5[] = "8a1bdcde72c65ca7d3ce8ebf52d43516";

void requireAtMost(std::size_t limit, const char* limit_name, std::size_t count, const char* what) {
  if (count > limit)
    throw LimitExceeded("it has " + std::to_string(count) + " " + what + ", more than ~" +
                        limit_name + " " + std::to_string(limit));
}

std::vector<geometry_msgs::Point> readPoints(WireReader& in, std::size_t max_vertices) {
  std::vector<geometry_msgs::Point> points(in.arrayLength(kPointBytes));
  requireAtMost(max_vertices, "max_vertices", points.size(), "outline vertices in one obstacle");
  for (auto& point : points) point = readTriple<geometry_msgs::Point>(in);
  return points;
}

void readOwn(WireReader& in, const Parameters& p, ObstacleArray& array) {
  constexpr std::size_t kShortest = 8 + 3 * kPointBytes + 2 * 8 + 4;
  const std::size_t count = in.arrayLength(kShortest);
  requireAtMost(p.max_obstacles, "max_obstacles", count, "obstacles");
  array.obstacles.resize(count);
  for (Obstacle& o : array.obstacles) {
    o.id = in.number<std::int64_t>();
    o.position = readTriple<geometry_msgs::Point>(in);
    o.velocity = readTriple<geometry_msgs::Vector3>(in);
    o.acceleration = readTriple<geometry_msgs::Vector3>(in);
    o.radius = in.number<double>();
    o.radius_rate = in.number<double>();
    o.outline = readPoints(in, p.max_vertices);
  }
}

Obstacle lineBetween(const geometry_msgs::Point& first, const geometry_msgs::Point& last) {
  Obstacle line;
  line.id = -1;
  line.position = first;
  line.outline.resize(2);
  line.outline[1].x = last.x - first.x;
  line.outline[1].y = last.y - first.y;
  line.outline[1].z = last.z - first.z;
  return line;
}

/// obstacle_detector sends the segments first; circles come first here.
void readObstacleDetector(WireReader& in, const Parameters& p, ObstacleArray& array) {
  const std::size_t segments = in.arrayLength(2 * kPointBytes);
  requireAtMost(p.max_obstacles, "max_obstacles", segments, "segments");
  std::vector<Obstacle> lines(segments);
  for (Obstacle& line : lines) {
    const auto first = readTriple<geometry_msgs::Point>(in);
    line = lineBetween(first, readTriple<geometry_msgs::Point>(in));
  }
  const std::size_t circles = in.arrayLength(2 * kPointBytes + 2 * 8);
  requireAtMost(p.max_obstacles, "max_obstacles", segments + circles, "obstacles");
  array.obstacles.resize(circles);
  for (Obstacle& circle : array.obstacles) {
    circle.id = -1;
    circle.position = readTriple<geometry_msgs::Point>(in);
    circle.velocity = readTriple<geometry_msgs::Vector3>(in);
    const double with_margin = in.number<double>();
    const double measured = in.number<double>();
    const bool use_measured = p.obstacle_detector_radius == ObstacleDetectorRadius::kTrueRadius;
    circle.radius = use_measured ? measured : with_margin;
  }
  array.obstacles.insert(array.obstacles.end(), lines.begin(), lines.end());
}

/// Each obstacle has a header of its own, which costmap_converter leaves empty: the array's counts.
Obstacle readCostmapObstacle(WireReader& in, const Parameters& p, const std::string& frame) {
  Obstacle o;
  const std::string own_frame = readHeader(in).frame_id;
  if (!own_frame.empty() && own_frame != frame)
    throw MalformedMessage("an obstacle of it is in frame \"" + own_frame +
                           "\" while the message is in frame \"" + frame + "\"");
  const std::size_t vertices = in.arrayLength(kPoint32Bytes);
  requireAtMost(p.max_vertices, "max_vertices", vertices, "polygon vertices in one obstacle");
  std::vector<geometry_msgs::Point> polygon(vertices);
  for (auto& vertex : polygon) vertex = readTriple32<geometry_msgs::Point>(in);
  o.radius = in.number<double>();
  o.id = in.number<std::int64_t>();
  readQuaternion(in);
  o.velocity = readTwist(in).linear;
  if (polygon.empty()) throw MalformedMessage("an obstacle of it has a polygon without vertices");
  o.position = polygon.front();
  if (polygon.size() == 1) return o;
  for (auto& vertex : polygon) {
    vertex.x -= o.position.x;
    vertex.y -= o.position.y;
  }
  o.outline = polygon;
  return o;
}

void readCostmapConverter(WireReader& in, const Parameters& p, ObstacleArray& array) {
  constexpr std::size_t kShortest = kShortestHeader + 4 + 8 + 8 + 32 + 48 + kCovarianceBytes;
  const std::size_t count = in.arrayLength(kShortest);
  requireAtMost(p.max_obstacles, "max_obstacles", count, "obstacles");
  array.obstacles.reserve(count);
  for (std::size_t i = 0; i < count; ++i)
    array.obstacles.push_back(readCostmapObstacle(in, p, array.header.frame_id));
}

[[noreturn]] void refuseType(const RawMessage& message) {
  std::string fitting;
  for (const MessageType& type : obstacleTypes())
    fitting += (fitting.empty() ? "" : ", ") + type.name + " (md5 " + type.md5 + ")";
  throw UnknownType("it carries " + message.type + " (md5 " + message.md5 +
                    "); the types that fit are " + fitting);
}

}  // namespace

std::vector<MessageType> obstacleTypes() {
  return {{ros::message_traits::DataType<ObstacleArray>::value(),
           ros::message_traits::MD5Sum<ObstacleArray>::value()},
          {"obstacle_detector/Obstacles", kObstacleDetectorMd5},
          {"costmap_converter/ObstacleArrayMsg", kCostmapConverterMd5}};
}

ObstacleArray decodeObstacles(const RawMessage& message, const Parameters& parameters) {
  const auto read = [&] {
    if (message.md5 == ros::message_traits::MD5Sum<ObstacleArray>::value()) return readOwn;
    if (message.md5 == kObstacleDetectorMd5) return readObstacleDetector;
    if (message.md5 == kCostmapConverterMd5) return readCostmapConverter;
    refuseType(message);
  }();
  WireReader in(message.bytes);
  ObstacleArray array;
  array.header = readHeader(in);
  read(in, parameters, array);
  in.finish();
  return array;
}

}  // namespace footprint_collision_predictor
