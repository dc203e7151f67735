// From a prediction to a warning level, and how the level is held.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace footprint_collision_predictor::core {

/// The values are those of CollisionWarning. Ordered by isWorse, not by value.
enum class Level : std::uint8_t { kUnknown = 0, kClear = 1, kWarn = 2, kCritical = 3 };

/// 0 < critical_time <= warn_time; both inclusive.
struct Thresholds {
  double warn_time;      ///< [s]
  double critical_time;  ///< [s]
};

/// CRITICAL > UNKNOWN > WARN > CLEAR.
bool isWorse(Level a, Level b);
Level worse(Level a, Level b);

/// The level of what is seen at one moment.
///
/// \param time_to_collision [s] of the certain hit among the good inputs; nothing when there is
/// none \param all_inputs_good when false the result is UNKNOWN, unless that certain hit is
/// CRITICAL
Level assess(std::optional<double> time_to_collision, bool all_inputs_good,
             const Thresholds& thresholds);

/// Lets the level rise at once and fall only after `clear_after` messages in a row that give a
/// lower one, so that one noisy message does not release a warning. It holds the worst level of the
/// last `clear_after` messages. Loss of data is never held back: UNKNOWN replaces whatever was
/// held.
class LevelHold {
 public:
  /// \param clear_after >= 1. Starts as if that many UNKNOWN messages had come.
  explicit LevelHold(std::size_t clear_after);

  /// Takes the level that one obstacles message gives.
  void update(Level seen);
  /// Takes the level that a message with the stamp of the newest one gives: both count as one, at
  /// the worse of their levels.
  void replaceNewest(Level seen);
  /// After a gap in the messages: what is held stays, the count of lower ones starts again.
  void restartCount();
  /// Another length, >= 1: what is held stays, the count starts again.
  void setClearAfter(std::size_t clear_after);
  /// What to show, given what is seen at this moment (by a message, or by a repeat between
  /// messages).
  Level shown(Level seen) const;
  /// Back to the start: UNKNOWN.
  void reset();

 private:
  Level held() const;

  std::vector<Level> recent_;  // of the last clear_after messages, as a ring
  std::size_t next_ = 0;
};

}  // namespace footprint_collision_predictor::core
