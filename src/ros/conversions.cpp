#include "conversions.hpp"

#include <limits>

namespace footprint_collision_predictor {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

std::uint8_t featureMsg(core::Feature feature) {
  switch (feature) {
    case core::Feature::kInside:
      return SegmentPrediction::INSIDE;
    case core::Feature::kStart:
      return SegmentPrediction::START;
    case core::Feature::kEnd:
      return SegmentPrediction::END;
  }
  return SegmentPrediction::NONE;
}

SegmentPrediction segmentMsg(const core::Segment& segment, double horizon, bool complete) {
  SegmentPrediction msg;
  msg.start = toMsg(segment.start);
  msg.end = toMsg(segment.end);
  msg.time_to_collision = complete ? kInfinity : kNaN;
  msg.contact_free_time = complete ? horizon : 0;
  msg.obstacle_id = -1;
  msg.obstacle_index = -1;
  msg.feature = SegmentPrediction::NONE;
  return msg;
}

void fillContact(const core::SegmentContact& hit, const ObstacleKey& key, bool complete,
                 SegmentPrediction& msg) {
  msg.collision_predicted = 1;
  msg.time_to_collision = hit.contact.time;
  msg.contact_free_time = complete ? hit.contact.time : 0;
  msg.obstacle_id = key.id;
  msg.obstacle_index = key.index;
  msg.feature = featureMsg(hit.contact.feature);
  msg.contact_point = toMsg(hit.contact.point);
}

}  // namespace

std::vector<core::Vec2> toCore(const geometry_msgs::Polygon& polygon, const PlanarPose& body) {
  std::vector<core::Vec2> vertices;
  vertices.reserve(polygon.points.size());
  for (const auto& p : polygon.points) vertices.push_back(body.pointToLocal({p.x, p.y}));
  return vertices;
}

core::Twist carriedOver(const core::Twist& twist, const PlanarPose& from) {
  return {from.vectorFromLocal(twist.linear) - twist.angular * core::leftNormal(from.position),
          twist.angular};
}

geometry_msgs::Point toMsg(const core::Vec2& p) {
  geometry_msgs::Point msg;
  msg.x = p.x();
  msg.y = p.y();
  return msg;
}

geometry_msgs::Twist toMsg(const core::Twist& twist) {
  geometry_msgs::Twist msg;
  msg.linear.x = twist.linear.x();
  msg.linear.y = twist.linear.y();
  msg.angular.z = twist.angular;
  return msg;
}

std::vector<SegmentPrediction> toMsg(const core::Polygon& footprint,
                                     const core::Prediction& prediction,
                                     const std::vector<ObstacleKey>& keys, double horizon,
                                     bool complete) {
  std::vector<SegmentPrediction> segments;
  segments.reserve(footprint.size());
  for (std::size_t i = 0; i < footprint.size(); ++i) {
    segments.push_back(segmentMsg(footprint.segment(i), horizon, complete));
    const auto& hit = prediction.segments[i];
    if (hit) fillContact(*hit, keys[hit->obstacle], complete, segments.back());
  }
  return segments;
}

}  // namespace footprint_collision_predictor
