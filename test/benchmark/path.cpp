#include "path.hpp"

namespace footprint_collision_predictor::bench {
namespace {

topic_tools::ShapeShifter serialised(const ObstacleArray& message) {
  namespace traits = ros::message_traits;
  const auto bytes = ros::serialization::serializeMessage(message);
  ros::serialization::IStream stream(bytes.message_start,
                                     static_cast<std::uint32_t>(bytes.num_bytes - 4));
  topic_tools::ShapeShifter raw;
  raw.morph(traits::md5sum(message), traits::datatype(message), traits::definition(message), "");
  raw.read(stream);
  return raw;
}

}  // namespace

Path::Path(const std::string& name, bool within_process)
    : name_(name),
      within_process_(within_process),
      publisher_(ros::NodeHandle().advertise<ObstacleArray>(name + "/obstacles", 10)),
      answers_(name + "/answer") {}

void Path::waitConnected(ObstacleArray& message) {
  while (publisher_.getNumSubscribers() == 0 || !answers_.isConnected()) {
    message.header.stamp = ros::Time::now();
    publisher_.publish(message);
    ros::WallDuration(0.1).sleep();
  }
}

double Path::measure(ObstacleArray& message) {
  message.header.stamp = ros::Time::now();
  if (within_process_) {
    const auto shared = boost::make_shared<const ObstacleArray>(message);
    return answers_.measure(message.header.stamp, [&] { publisher_.publish(shared); });
  }
  const topic_tools::ShapeShifter raw = serialised(message);
  return answers_.measure(message.header.stamp, [&] { publisher_.publish(raw); });
}

}  // namespace footprint_collision_predictor::bench
