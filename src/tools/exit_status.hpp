// Exit statuses of the command-line tools; each tool's --help says which it uses.
#pragma once

namespace footprint_collision_predictor::tools {

constexpr int kSuccess = 0;
constexpr int kDisagrees = 1;    ///< the warnings are not those that were expected
constexpr int kUsage = 2;        ///< the command line is wrong
constexpr int kNoWarning = 3;    ///< no warning ever came
constexpr int kCannotRead = 4;   ///< an input file is missing or not what it should be
constexpr int kCannotWrite = 5;  ///< an output file could not be written

}  // namespace footprint_collision_predictor::tools
