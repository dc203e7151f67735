// All that the diagnostics are made of: a value that the worker hands to another thread.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "clock_monitor.hpp"
#include "input_report.hpp"

namespace footprint_collision_predictor {

struct TransformReport {
  std::string body_frame;
  std::string frame;            ///< of the newest obstacles message; empty before the first
  std::optional<double> delay;  ///< [s] by which the newest transform between them is old; 0 when
                                ///< it never changes; nothing when there is none
  double waited = 0;            ///< [s] that the newest message waited for transforms and odometry
  Findings findings;            ///< what is wrong with transforms now
};

struct ComputationReport {
  double period = 0;              ///< [s] that an evaluation may take
  double p50 = 0;                 ///< [s] half of the last evaluations took no longer
  double p99 = 0;                 ///< [s] likewise 99 of 100
  double longest = 0;             ///< [s] of the last evaluations
  std::uint64_t evaluations = 0;  ///< since the start
  std::uint64_t late = 0;         ///< of these, longer than the period
  double since_last = 0;          ///< [s]; infinite before the first
};

struct BodyReport {
  std::string name;
  std::optional<InputReport> footprint;  ///< nothing where it is a parameter
  TransformReport transforms;
};

struct Report {
  ros::SteadyTime made;
  double max_data_age = 0;  ///< [s]
  InputReport obstacles;
  std::optional<InputReport> odometry;  ///< nothing where no body needs it
  std::vector<BodyReport> bodies;
  ComputationReport computation;
  ClockReport clock;
};

}  // namespace footprint_collision_predictor
