#include "warning_log.hpp"

#include <sstream>
#include <utility>

#include "footprint_collision_predictor/warning.hpp"
#include "footprint_name.hpp"
#include "moment.hpp"

namespace footprint_collision_predictor {
namespace {

using Warning = CollisionWarning;

constexpr double kQuiet = 1;  // [s]

// REASON_SETTLING is not among them: it follows every fault, and its end is the new level itself.
constexpr std::pair<std::uint32_t, const char*> kFaults[] = {
    {Warning::REASON_OBSTACLES_MISSING, "obstacles missing"},
    {Warning::REASON_OBSTACLES_STALE, "obstacles too old"},
    {Warning::REASON_OBSTACLES_INVALID, "obstacles refused"},
    {Warning::REASON_OBSTACLES_TYPE, "obstacles of an unknown type"},
    {Warning::REASON_FOOTPRINT_MISSING, "footprint missing"},
    {Warning::REASON_FOOTPRINT_INVALID, "footprint refused"},
    {Warning::REASON_ODOM_MISSING, "odometry missing"},
    {Warning::REASON_ODOM_STALE, "odometry too old"},
    {Warning::REASON_ODOM_INVALID, "odometry refused"},
    {Warning::REASON_TRANSFORM, "transform missing or unusable"},
    {Warning::REASON_STAMP, "impossible stamps"},
    {Warning::REASON_CLOCK, "clock not running"},
    {Warning::REASON_LIMIT, "too many obstacles or vertices"},
    {Warning::REASON_DEADLINE, "evaluation too late"},
    {Warning::REASON_NOT_SUPPORTED, "input not supported"},
    {Warning::REASON_NOT_PREDICTED, "outlines not predicted"},
    {Warning::REASON_DUPLICATE_ID, "duplicate ids"},
    {Warning::REASON_SEVERAL_PUBLISHERS, "several publishers"},
    {Warning::REASON_OUT_OF_ORDER, "messages out of order"},
};

std::string named(std::uint32_t reasons) {
  std::string all;
  for (const auto& [reason, name] : kFaults)
    if (reasons & reason) all += (all.empty() ? "" : ", ") + std::string(name);
  return all;
}

std::string described(const Warning& warning, const std::string& over) {
  static const char* const kNames[] = {"UNKNOWN", "CLEAR", "WARN", "CRITICAL"};
  std::ostringstream text;
  text << prefixFor(warning.footprint) << kNames[warning.level];
  if (warning.collision_predicted != 0)
    text << ": contact in " << warning.time_to_collision << " s, segment " << warning.segment
         << ", obstacle " << warning.obstacle_id;
  if (!warning.message.empty()) text << ": " << warning.message;
  if (!over.empty()) text << " (over: " << over << ")";
  return text.str();
}

bool isWorse(const Warning& a, const Warning& b) {
  return core::isWorse(static_cast<core::Level>(a.level), static_cast<core::Level>(b.level));
}

}  // namespace

std::optional<LogLine> WarningLog::update(const Warning& warning, const ros::SteadyTime& now) {
  if (told_) {
    if (warning.level == told_->level && warning.reason == told_->reason) return std::nullopt;
    const bool quiet = secondsBetween(told_time_, now) >= kQuiet;
    if (!quiet && !isWorse(warning, *told_)) return std::nullopt;
  }
  const std::string over = told_ ? named(told_->reason & ~warning.reason) : "";
  told_ = warning;
  told_time_ = now;
  return LogLine{warning.level == Warning::CLEAR, described(warning, over)};
}

}  // namespace footprint_collision_predictor
