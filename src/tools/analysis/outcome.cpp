#include "outcome.hpp"

#include <algorithm>

#include "../exit_status.hpp"
#include "analysis_status.hpp"

namespace footprint_collision_predictor::tools {

bool breaksLimit(const BagReport& report, const Options& options) {
  const auto& worst = report.statistics.worst();
  return options.fail_under && worst && worst->time_to_collision < *options.fail_under;
}

bool isUnusable(const BagReport& report, const Options& options) {
  if (report.statistics.usable() == 0) return true;
  return options.fail_under && report.statistics.unknownPercent() > options.max_unknown;
}

int exitStatus(const std::vector<BagReport>& reports, const Options& options, bool interrupted) {
  const auto any = [&](auto holds) { return std::any_of(reports.begin(), reports.end(), holds); };
  if (interrupted) return kInterrupted;
  if (any([&](const BagReport& r) { return breaksLimit(r, options); })) return kLimitBroken;
  if (any([](const BagReport& r) { return r.status == kUsage; })) return kUsage;
  if (any([](const BagReport& r) { return r.status == kBagUnreadable; })) return kBagUnreadable;
  if (any([&](const BagReport& r) { return isUnusable(r, options); })) return kNothingUsable;
  return kDone;
}

}  // namespace footprint_collision_predictor::tools
