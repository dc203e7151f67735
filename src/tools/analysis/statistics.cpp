#include "statistics.hpp"

#include <algorithm>
#include <cmath>

namespace footprint_collision_predictor::tools {
namespace {

/// Whether the inputs let the predictor tell. While the level settles they do.
bool isUsable(const CollisionWarning& warning) {
  const std::uint32_t unknown = warning.reason % kFirstDegradedReason;
  return (unknown & ~std::uint32_t{CollisionWarning::REASON_SETTLING}) == 0;
}

}  // namespace

const char* wordFor(Verdict verdict) {
  switch (verdict) {
    case Verdict::kContact:
      return "contact";
    case Verdict::kPredicted:
      return "predicted";
    case Verdict::kNone:
      return "none";
    default:
      return "unknown";
  }
}

void Statistics::take(const Evaluation& evaluation) {
  const CollisionWarning& warning = evaluation.answer.warning;
  const bool usable = isUsable(warning);
  addDuration(evaluation.elapsed);
  previous_ = {std::max(evaluation.elapsed, previous_.elapsed), warning.level, usable};
  ++evaluations_;
  if (usable) ++usable_;
  if (evaluation.silence) ++silences_;
  for (std::uint32_t bit = 1; bit != 0; bit <<= 1) {
    if ((warning.reason & bit) == 0) continue;
    ReasonCount& count = reasons_[bit];
    if (count.evaluations++ == 0) count.first_message = warning.message;
  }
  smallest_clearance_ = std::fmin(smallest_clearance_, warning.clearance);
  if (warning.collision_predicted != 0 &&
      (!worst_ || warning.time_to_collision < worst_->time_to_collision))
    worst_ = momentOf(evaluation);
}

void Statistics::finish(double elapsed) { addDuration(elapsed); }

void Statistics::addDuration(double until) {
  const double seconds = std::max(0.0, until - previous_.elapsed);
  seconds_ += seconds;
  seconds_at_.at(previous_.level) += seconds;
  if (!previous_.usable) unusable_seconds_ += seconds;
}

double Statistics::unknownPercent() const {
  if (seconds_ > 0) return 100 * unusable_seconds_ / seconds_;
  return usable_ > 0 ? 0 : 100;
}

Verdict Statistics::verdict(double max_unknown) const {
  if (worst_) return worst_->time_to_collision <= 0 ? Verdict::kContact : Verdict::kPredicted;
  return usable_ > 0 && unknownPercent() <= max_unknown ? Verdict::kNone : Verdict::kUnknown;
}

std::string reasonName(std::uint32_t bit) {
  using W = CollisionWarning;
  static const std::map<std::uint32_t, std::string> names = {
      {W::REASON_OBSTACLES_MISSING, "OBSTACLES_MISSING"},
      {W::REASON_OBSTACLES_STALE, "OBSTACLES_STALE"},
      {W::REASON_OBSTACLES_INVALID, "OBSTACLES_INVALID"},
      {W::REASON_OBSTACLES_TYPE, "OBSTACLES_TYPE"},
      {W::REASON_FOOTPRINT_MISSING, "FOOTPRINT_MISSING"},
      {W::REASON_FOOTPRINT_INVALID, "FOOTPRINT_INVALID"},
      {W::REASON_ODOM_MISSING, "ODOM_MISSING"},
      {W::REASON_ODOM_STALE, "ODOM_STALE"},
      {W::REASON_ODOM_INVALID, "ODOM_INVALID"},
      {W::REASON_TRANSFORM, "TRANSFORM"},
      {W::REASON_STAMP, "STAMP"},
      {W::REASON_CLOCK, "CLOCK"},
      {W::REASON_LIMIT, "LIMIT"},
      {W::REASON_DEADLINE, "DEADLINE"},
      {W::REASON_NOT_SUPPORTED, "NOT_SUPPORTED"},
      {W::REASON_SETTLING, "SETTLING"},
      {W::REASON_NOT_PREDICTED, "NOT_PREDICTED"},
      {W::REASON_DUPLICATE_ID, "DUPLICATE_ID"},
      {W::REASON_SEVERAL_PUBLISHERS, "SEVERAL_PUBLISHERS"},
      {W::REASON_OUT_OF_ORDER, "OUT_OF_ORDER"}};
  const auto found = names.find(bit);
  return found == names.end() ? std::to_string(bit) : found->second;
}

}  // namespace footprint_collision_predictor::tools
