// How long evaluations take.
#pragma once

#include <ros/time.h>

#include <cstdint>
#include <vector>

#include "report.hpp"

namespace footprint_collision_predictor {

class EvaluationTimes {
 public:
  /// \param seconds that an evaluation took, finished at `now`
  /// \param period [s] that it may take
  void add(double seconds, double period, const ros::SteadyTime& now);
  /// Percentiles are of the last 1000 evaluations.
  ComputationReport report(double period, const ros::SteadyTime& now) const;

 private:
  std::vector<double> recent_;  // as a ring
  std::uint64_t count_ = 0;
  std::uint64_t late_ = 0;
  ros::SteadyTime last_;
};

}  // namespace footprint_collision_predictor
