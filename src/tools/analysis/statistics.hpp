// What all evaluations of one bag come to.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>

#include "event.hpp"
#include "findings.hpp"
#include "replay.hpp"

namespace footprint_collision_predictor::tools {

/// What there is to say of a recording as a whole. Unusable data is never "none".
enum class Verdict { kContact, kPredicted, kNone, kUnknown };

/// "contact", "predicted", "none" or "unknown"
const char* wordFor(Verdict verdict);

/// A REASON_... bit in the evaluations of a recording.
struct ReasonCount {
  std::size_t evaluations = 0;
  std::string first_message;  ///< words of the first of them
};

class Statistics {
 public:
  void take(const Evaluation& evaluation);
  /// The recording goes on until `elapsed` [s] without a further evaluation.
  void finish(double elapsed);

  std::size_t evaluations() const { return evaluations_; }
  /// Of them, those about which nothing stops the predictor from telling.
  std::size_t usable() const { return usable_; }
  std::size_t silences() const { return silences_; }
  /// [s] spent at each level, by CollisionWarning's numbers of them.
  const std::array<double, 4>& secondsAt() const { return seconds_at_; }
  double seconds() const { return seconds_; }
  /// [%] of the time about which it cannot be told. The first messages of good data, after which
  /// the level still settles, do not count.
  double unknownPercent() const;
  /// By the bit.
  const std::map<std::uint32_t, ReasonCount>& reasons() const { return reasons_; }
  /// The smallest time to collision; nothing when no contact was ever predicted.
  const std::optional<WorstMoment>& worst() const { return worst_; }
  /// [m] the smallest seen; NaN when none is known.
  double smallestClearance() const { return smallest_clearance_; }

  /// \param max_unknown [%] above which "none" cannot be said
  Verdict verdict(double max_unknown) const;

 private:
  void addDuration(double until);

  struct Previous {
    double elapsed;
    std::uint8_t level;
    bool usable;
  };

  std::size_t evaluations_ = 0;
  std::size_t usable_ = 0;
  std::size_t silences_ = 0;
  std::array<double, 4> seconds_at_{};
  double seconds_ = 0;
  double unusable_seconds_ = 0;
  std::map<std::uint32_t, ReasonCount> reasons_;
  std::optional<WorstMoment> worst_;
  double smallest_clearance_ = std::numeric_limits<double>::quiet_NaN();
  // Before the first evaluation nothing is known.
  Previous previous_{0, CollisionWarning::UNKNOWN, false};
};

/// "OBSTACLES_STALE" for the bit of that reason.
std::string reasonName(std::uint32_t bit);

}  // namespace footprint_collision_predictor::tools
