// What is wrong with the inputs: a mask of CollisionWarning's reasons, with the words for a person.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "footprint_collision_predictor/CollisionWarning.h"

namespace footprint_collision_predictor {

/// Reasons below this bit make the level UNKNOWN; the others only say what is degraded.
constexpr std::uint32_t kFirstDegradedReason = 1u << 24;

class Findings {
 public:
  /// The same words again add nothing.
  void add(std::uint32_t reason, const std::string& words) {
    for (const Finding& known : list_)
      if (known.words == words) return;
    reasons_ |= reason;
    list_.push_back({reason, words});
  }
  void add(const Findings& others) {
    for (const Finding& other : others.list_) add(other.reason, other.words);
  }

  /// Those that set one of these reasons.
  Findings with(std::uint32_t reasons) const {
    Findings some;
    for (const Finding& finding : list_)
      if (finding.reason & reasons) some.add(finding.reason, finding.words);
    return some;
  }

  std::uint32_t reasons() const { return reasons_; }
  bool makeUnknown() const { return reasons_ % kFirstDegradedReason != 0; }

  bool empty() const { return list_.empty(); }

  /// What, where and what to do; joined by "; ", empty when there is nothing to say.
  std::string text() const {
    std::string all;
    for (const Finding& finding : list_) all += (all.empty() ? "" : "; ") + finding.words;
    return all;
  }

 private:
  struct Finding {
    std::uint32_t reason;
    std::string words;
  };

  std::uint32_t reasons_ = 0;
  std::vector<Finding> list_;
};

}  // namespace footprint_collision_predictor
