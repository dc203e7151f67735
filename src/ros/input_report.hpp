// What the diagnostics say of one input: a value, so that it can be handed to another thread.
#pragma once

#include <string>
#include <vector>

#include "input_record.hpp"

namespace footprint_collision_predictor {

struct InputReport {
  std::string topic;
  std::string type;
  std::string md5;
  std::vector<std::string> publishers;
  InputCounts counts;
  double rate = 0;  ///< [Hz]
  double age = 0;   ///< [s] of the newest good message; infinite before the first
  std::string last_refusal;
  double since_last_refusal = 0;  ///< [s]
  Findings findings;              ///< what is wrong with it now; nothing when it is good and fresh
};

/// \param age [s] of its newest good message
inline InputReport reportOf(const InputRecord& record, double age, const Findings& findings,
                            const ros::SteadyTime& now) {
  return {record.topic(),
          record.type(),
          record.md5(),
          record.publishers(now),
          record.counts(),
          record.rate(now),
          age,
          record.lastRefusal(),
          record.lastRefusal().empty() ? 0 : secondsBetween(record.lastRefusalTime(), now),
          findings};
}

}  // namespace footprint_collision_predictor
