#include "evaluation_times.hpp"

#include <algorithm>
#include <limits>

#include "moment.hpp"

namespace footprint_collision_predictor {
namespace {

constexpr std::size_t kRemembered = 1000;

/// The smallest value that no more than (1 - share) of all exceed; \pre sorted, not empty.
double percentile(const std::vector<double>& sorted, double share) {
  const auto rank = static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1) + 0.5);
  return sorted[rank];
}

}  // namespace

void EvaluationTimes::add(double seconds, double period, const ros::SteadyTime& now) {
  if (recent_.size() < kRemembered)
    recent_.push_back(seconds);
  else
    recent_[count_ % kRemembered] = seconds;
  ++count_;
  if (seconds > period) ++late_;
  last_ = now;
}

ComputationReport EvaluationTimes::report(double period, const ros::SteadyTime& now) const {
  ComputationReport report;
  report.period = period;
  report.evaluations = count_;
  report.late = late_;
  report.since_last =
      count_ == 0 ? std::numeric_limits<double>::infinity() : secondsBetween(last_, now);
  if (recent_.empty()) return report;
  std::vector<double> sorted = recent_;
  std::sort(sorted.begin(), sorted.end());
  report.p50 = percentile(sorted, 0.5);
  report.p99 = percentile(sorted, 0.99);
  report.longest = sorted.back();
  return report;
}

}  // namespace footprint_collision_predictor
