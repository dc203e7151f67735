#include "level_state.hpp"

#include <string>

namespace footprint_collision_predictor {

using core::Level;

LevelState::LevelState(const core::Thresholds& thresholds, std::size_t clear_after)
    : thresholds_(thresholds), clear_after_(clear_after), hold_(clear_after) {}

void LevelState::reconfigure(const core::Thresholds& thresholds, std::size_t clear_after) {
  thresholds_ = thresholds;
  if (clear_after == clear_after_) return;
  clear_after_ = clear_after;
  hold_.setClearAfter(clear_after);
}

Level LevelState::judge(const Sight& sight, Counts counts, Findings& findings) {
  const Level seen =
      sight.evaluated ? core::assess(sight.time_to_collision, !findings.makeUnknown(), thresholds_)
                      : Level::kUnknown;
  if (counts == Counts::kAsNew) hold_.update(seen);
  if (counts == Counts::kAsReplacement) hold_.replaceNewest(seen);
  const Level level = hold_.shown(seen);
  const std::string in_a_row =
      std::to_string(clear_after_) + " obstacles messages in a row (~clear_after)";
  if (level == Level::kUnknown && !findings.makeUnknown())
    findings.add(CollisionWarning::REASON_SETTLING,
                 "the inputs are good, but not yet for " + in_a_row);
  if (level != Level::kUnknown && core::isWorse(level, seen))
    findings.add(0, "the level is held until a lower one is given by " + in_a_row);
  return level;
}

}  // namespace footprint_collision_predictor
