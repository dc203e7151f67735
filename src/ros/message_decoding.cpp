#include "message_decoding.hpp"

#include "message_fields.hpp"

namespace footprint_collision_predictor {
namespace {

template <typename Message>
void requireType(const RawMessage& message) {
  if (message.md5 == ros::message_traits::MD5Sum<Message>::value()) return;
  throw UnknownType("it carries " + message.type + " (md5 " + message.md5 + "); expected is " +
                    ros::message_traits::DataType<Message>::value() + " (md5 " +
                    ros::message_traits::MD5Sum<Message>::value() + ")");
}

}  // namespace

geometry_msgs::PolygonStamped decodeFootprint(const RawMessage& message, std::size_t max_vertices) {
  requireType<geometry_msgs::PolygonStamped>(message);
  WireReader in(message.bytes);
  geometry_msgs::PolygonStamped footprint;
  footprint.header = readHeader(in);
  const std::size_t count = in.arrayLength(kPoint32Bytes);
  if (count > max_vertices)
    throw LimitExceeded("it has " + std::to_string(count) + " vertices, more than ~max_vertices " +
                        std::to_string(max_vertices));
  footprint.polygon.points.resize(count);
  for (auto& point : footprint.polygon.points) point = readTriple32<geometry_msgs::Point32>(in);
  in.finish();
  return footprint;
}

nav_msgs::Odometry decodeOdometry(const RawMessage& message) {
  requireType<nav_msgs::Odometry>(message);
  WireReader in(message.bytes);
  nav_msgs::Odometry odometry;
  odometry.header = readHeader(in);
  odometry.child_frame_id = withoutLeadingSlash(in.string());
  odometry.pose.pose.position = readTriple<geometry_msgs::Point>(in);
  odometry.pose.pose.orientation = readQuaternion(in);
  in.skip(kCovarianceBytes);
  odometry.twist.twist = readTwist(in);
  in.finish();
  return odometry;
}

}  // namespace footprint_collision_predictor
