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
};

}  // namespace footprint_collision_predictor
