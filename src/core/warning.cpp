#include "footprint_collision_predictor/warning.hpp"

#include <algorithm>

namespace footprint_collision_predictor::core {
namespace {

int severity(Level level) {
  switch (level) {
    case Level::kClear:
      return 0;
    case Level::kWarn:
      return 1;
    case Level::kUnknown:
      return 2;
    case Level::kCritical:
      return 3;
  }
  return 2;
}

}  // namespace

bool isWorse(Level a, Level b) { return severity(a) > severity(b); }

Level worse(Level a, Level b) { return isWorse(a, b) ? a : b; }

Level assess(std::optional<double> time_to_collision, bool all_inputs_good,
             const Thresholds& thresholds) {
  if (time_to_collision && *time_to_collision <= thresholds.critical_time) return Level::kCritical;
  if (!all_inputs_good) return Level::kUnknown;
  if (time_to_collision && *time_to_collision <= thresholds.warn_time) return Level::kWarn;
  return Level::kClear;
}

LevelHold::LevelHold(std::size_t clear_after) : recent_(clear_after, Level::kUnknown) {}

void LevelHold::update(Level seen) {
  if (seen == Level::kUnknown) return reset();
  recent_[next_] = seen;
  next_ = (next_ + 1) % recent_.size();
}

void LevelHold::replaceNewest(Level seen) {
  if (seen == Level::kUnknown) return reset();
  Level& newest = recent_[(next_ + recent_.size() - 1) % recent_.size()];
  newest = worse(newest, seen);
}

void LevelHold::restartCount() { std::fill(recent_.begin(), recent_.end(), held()); }

void LevelHold::setClearAfter(std::size_t clear_after) {
  recent_.assign(clear_after, held());
  next_ = 0;
}

Level LevelHold::shown(Level seen) const {
  return seen == Level::kUnknown ? seen : worse(held(), seen);
}

void LevelHold::reset() { std::fill(recent_.begin(), recent_.end(), Level::kUnknown); }

Level LevelHold::held() const {
  Level level = Level::kClear;
  for (const Level recent : recent_) level = worse(level, recent);
  return level;
}

}  // namespace footprint_collision_predictor::core
