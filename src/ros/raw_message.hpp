// A message as it came over the wire, before anything in it is believed.
#pragma once

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
