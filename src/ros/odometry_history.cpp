#include "odometry_history.hpp"

#include <algorithm>

namespace footprint_collision_predictor {
namespace {

// Ten seconds of odometry at 400 Hz: far more than any message waits.
constexpr std::size_t kMostSamples = 4000;

}  // namespace

bool OdometryHistory::add(const OdometrySample& sample) {
  if (!samples_.empty() && sample.stamp < samples_.back().stamp) return false;
  if (!samples_.empty() && sample.stamp == samples_.back().stamp) samples_.pop_back();
  samples_.push_back(sample);
  if (samples_.size() > kMostSamples) samples_.pop_front();
  return true;
}

std::optional<OdometrySample> OdometryHistory::at(const ros::Time& stamp) const {
  const auto later = [](const ros::Time& t, const OdometrySample& s) { return t < s.stamp; };
  const auto after = std::upper_bound(samples_.begin(), samples_.end(), stamp, later);
  if (after == samples_.begin()) return std::nullopt;
  return *std::prev(after);
}

void OdometryHistory::dropAfter(const ros::Time& stamp) {
  while (!samples_.empty() && samples_.back().stamp > stamp) samples_.pop_back();
}

bool OdometryHistory::reaches(const ros::Time& stamp) const {
  return !samples_.empty() && samples_.back().stamp >= stamp;
}

}  // namespace footprint_collision_predictor
