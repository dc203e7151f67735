// Which warnings are worth a line in the log, and what it says.
#pragma once

#include <ros/time.h>

#include <optional>
#include <string>

#include "footprint_collision_predictor/CollisionWarning.h"

namespace footprint_collision_predictor {

struct LogLine {
  bool is_good_news;  ///< to be logged as information, not as a warning
  std::string text;
};

/// A change of level or reasons is told once, and once more when it is over. A level that is worse
/// than the one last told is told at once, all else at most once a second: so a fault that comes
/// and goes gives no more than two lines a second.
class WarningLog {
 public:
  /// For every warning that goes out, since a change that was held back is told later.
  /// \return the line to log, if any
  std::optional<LogLine> update(const CollisionWarning& warning, const ros::SteadyTime& now);

 private:
  std::optional<CollisionWarning> told_;
  ros::SteadyTime told_time_;
};

}  // namespace footprint_collision_predictor
