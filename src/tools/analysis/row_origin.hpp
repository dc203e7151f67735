// The last columns of every row: where it is from.
#pragma once

#include <string>

namespace footprint_collision_predictor::tools {

struct RowOrigin {
  std::string footprint;  ///< empty, and no column, where the robot has only one
  std::string bag;
};

/// Both begin with a comma.
std::string originHeader(const RowOrigin& origin);
std::string originColumns(const RowOrigin& origin);

}  // namespace footprint_collision_predictor::tools
