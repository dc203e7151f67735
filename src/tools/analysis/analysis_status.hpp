// Exit statuses of analyze_bag; --help lists them.
#pragma once

namespace footprint_collision_predictor::tools {

/// Beside kSuccess, kUsage and kCannotWrite, which all tools share.
enum AnalysisStatus : int {
  kDone = 0,
  kLimitBroken = 1,  ///< --fail-under
  kBagUnreadable = 3,
  kNothingUsable = 4,  ///< or, with --fail-under, more UNKNOWN than --max-unknown allows
  kInterrupted = 130,
};

}  // namespace footprint_collision_predictor::tools
