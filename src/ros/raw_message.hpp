// A message as it came over the wire, before anything in it is believed. roscpp can subscribe to
// it, whatever the type of the topic is.
#pragma once

#include <ros/message_traits.h>
#include <ros/serialization.h>

#include <cstdint>
#include <string>
#include <vector>

namespace footprint_collision_predictor {

struct RawMessage {
  std::string type;  ///< as the publisher names it, e.g. "nav_msgs/Odometry"
  std::string md5;
  std::vector<std::uint8_t> bytes;
  std::string publisher{};  ///< name of the node that sent it; empty when not known
};

}  // namespace footprint_collision_predictor

namespace ros {
namespace message_traits {

template <>
struct MD5Sum<footprint_collision_predictor::RawMessage> {
  static const char* value() { return "*"; }
};

template <>
struct DataType<footprint_collision_predictor::RawMessage> {
  static const char* value() { return "*"; }
};

}  // namespace message_traits

namespace serialization {

template <>
struct PreDeserialize<footprint_collision_predictor::RawMessage> {
  using Message = footprint_collision_predictor::RawMessage;
  static void notify(const PreDeserializeParams<Message>& params) {
    auto& header = *params.connection_header;  // where what is missing reads as empty
    params.message->type = header["type"];
    params.message->md5 = header["md5sum"];
    params.message->publisher = header["callerid"];
  }
};

template <>
struct Serializer<footprint_collision_predictor::RawMessage> {
  template <typename Stream>
  static void read(Stream& stream, footprint_collision_predictor::RawMessage& message) {
    message.bytes.assign(stream.getData(), stream.getData() + stream.getLength());
  }
};

}  // namespace serialization
}  // namespace ros
