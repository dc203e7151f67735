// tf2 refuses frame names with the leading slash that tf used to have and some sources still write.
#pragma once

#include <string>

namespace footprint_collision_predictor {

inline std::string withoutLeadingSlash(const std::string& frame) {
  return !frame.empty() && frame.front() == '/' ? frame.substr(1) : frame;
}

}  // namespace footprint_collision_predictor
