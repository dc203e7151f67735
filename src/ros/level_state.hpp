// The level that is shown: from what is seen at one moment, what is wrong with the inputs, and the
// messages before.
#pragma once

#include <cstddef>
#include <optional>

#include "findings.hpp"
#include "footprint_collision_predictor/warning.hpp"

namespace footprint_collision_predictor {

/// What one moment shows.
struct Sight {
  bool evaluated = false;                   ///< without an evaluation nothing is known
  std::optional<double> time_to_collision;  ///< [s] of the certain hit among the good inputs
};

/// Only obstacles messages change the level that is held: the others are repeats.
enum class Counts { kNot, kAsNew, kAsReplacement };

class LevelState {
 public:
  /// Starts as if nothing but UNKNOWN had come.
  LevelState(const core::Thresholds& thresholds, std::size_t clear_after);

  /// What is held stays, but the messages in a row are counted anew when their number changes.
  void reconfigure(const core::Thresholds& thresholds, std::size_t clear_after);
  void restartCount() { hold_.restartCount(); }
  void reset() { hold_.reset(); }

  /// \param findings all that is wrong; REASON_SETTLING or why the level is held is added
  core::Level judge(const Sight& sight, Counts counts, Findings& findings);

 private:
  core::Thresholds thresholds_;
  std::size_t clear_after_;
  core::LevelHold hold_;
};

}  // namespace footprint_collision_predictor
