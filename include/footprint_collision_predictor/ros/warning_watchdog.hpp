// For a robot's controller: is it safe to go on, by the warnings that have come, and those that
// have not? A warning that does not come says nothing by itself, so somebody has to watch the
// clock.
//
// Only this header and the package's messages are needed; nothing has to be linked but roscpp's
// time.
#pragma once

#include <ros/time.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "footprint_collision_predictor/CollisionWarning.h"

namespace footprint_collision_predictor {

/// When to stop. The defaults fit the defaults of predictor_node.
struct WatchdogLimits {
  /// [s] Longest time without a new warning: four heartbeats at 20 Hz.
  double max_silence = 0.2;
  /// [s] Oldest input to rely on, counted until now: predictor_node's max_data_age and a silence.
  double max_data_age = 0.7;
  /// [s] How far a stamp may be ahead of this machine's clock.
  double max_stamp_lead = 0.1;
  /// Highest level at which it is safe to go on, in the order CLEAR < WARN < CRITICAL. UNKNOWN
  /// never is, nor is CRITICAL while something is unknown as well. CRITICAL is for controllers that
  /// brake by contact_free_time themselves.
  std::uint8_t highest_level = CollisionWarning::WARN;
};

/// Answers "safe to go on?". It is, while for every footprint all of this holds:
///  - a new warning has come within max_silence: its sequence is higher than that of the one before
///    (a repeated or older message does not count as one);
///  - it comes from a session that has been heard for at least max_silence, so that a restarted
///  node
///    is not relied on at once, and two nodes that publish on one topic never are;
///  - neither its stamp, by the ROS clock on arrival, nor its data_age is older than max_data_age
///  by
///    now: what has waited in a queue or behind a cut link is not taken for the present. The clocks
///    of the machines must agree (chrony), as they must for the predictor itself;
///  - its level is not UNKNOWN and at most highest_level.
/// A footprint that was heard once must go on being heard.
///
/// Pure: time is handed in, by a steady clock that neither simulation nor time servers touch.
/// Not thread-safe: feed and ask it from one thread, such as callbacks and a timer of one
/// ros::spin(), or under a lock.
class WarningWatchdog {
 public:
  struct Answer {
    bool safe;
    std::string why;  ///< what is wrong, for a person; empty when safe
  };

  /// \param footprints names of all footprints that have to be heard; empty: of any, at least one
  /// \throws std::invalid_argument for a limit that is not a number above 0, or not a level
  explicit WarningWatchdog(const WatchdogLimits& limits = {},
                           const std::vector<std::string>& footprints = {})
      : limits_(limits) {
    for (const double limit : {limits.max_silence, limits.max_data_age, limits.max_stamp_lead})
      if (!(std::isfinite(limit) && limit > 0))
        throw std::invalid_argument("WatchdogLimits: times must be above 0 s");
    if (limits.highest_level < CollisionWarning::CLEAR ||
        limits.highest_level > CollisionWarning::CRITICAL)
      throw std::invalid_argument("WatchdogLimits: highest_level must be CLEAR, WARN or CRITICAL");
    for (const std::string& name : footprints) heard_[name] = std::nullopt;
  }

  /// \param now ROS time of the arrival, which may be simulated
  /// \param steady steady time of the arrival
  void take(const CollisionWarning& warning, const ros::Time& now, const ros::SteadyTime& steady) {
    std::optional<Heard>& last = heard_[warning.footprint];
    const bool same_session = last && last->warning.session == warning.session;
    if (same_session && !isNewer(warning.sequence, last->warning.sequence)) {
      last->repeats = true;
      return;
    }
    const double stamp_age = now.toSec() - warning.header.stamp.toSec();
    last = Heard{warning, stamp_age, same_session ? last->session_start : steady, steady, false};
  }

  /// \param steady steady time now
  Answer safeToGoOn(const ros::SteadyTime& steady) const {
    if (heard_.empty()) return {false, "no collision warning has come yet" + whatToDo()};
    for (const auto& [name, heard] : heard_) {
      const std::string why =
          heard ? problemOf(*heard, steady) : "no collision warning has come yet" + whatToDo();
      if (!why.empty()) return {false, whose(name) + why};
    }
    return {true, ""};
  }

 private:
  struct Heard {
    CollisionWarning warning;
    double stamp_age;  // [s] on arrival
    ros::SteadyTime session_start;
    ros::SteadyTime arrival;
    bool repeats;  // since then messages have come, but none was new
  };

  /// Sequence numbers wrap round.
  static bool isNewer(std::uint32_t sequence, std::uint32_t than) {
    return sequence != than && sequence - than < (1u << 31);
  }

  /// "footprint" is the name of the only one.
  static std::string whose(const std::string& footprint) {
    return footprint == "footprint" ? "" : "footprint \"" + footprint + "\": ";
  }

  static std::string whatToDo() {
    return ": is predictor_node running, and is the topic its collision_warning?";
  }

  static std::string seconds(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3f s", value);
    return text;
  }

  static std::string above(double limit) { return " (limit " + seconds(limit) + ")"; }

  std::string problemOf(const Heard& heard, const ros::SteadyTime& steady) const {
    const double silence = (steady - heard.arrival).toSec();
    if (silence > limits_.max_silence) return silenceOf(heard, silence);
    const double session = (steady - heard.session_start).toSec();
    if (session < limits_.max_silence)
      return "a predictor has started " + seconds(session) +
             " ago, or two publish in turn: it is relied on after " + seconds(limits_.max_silence);
    const std::string age = ageProblemOf(heard, silence);
    return age.empty() ? levelProblemOf(heard.warning) : age;
  }

  std::string silenceOf(const Heard& heard, double silence) const {
    const std::string time = " for " + seconds(silence) + above(limits_.max_silence);
    if (heard.repeats)
      return "no new collision warning" + time + ": those that come repeat sequence " +
             std::to_string(heard.warning.sequence) + ", or older ones";
    return "no collision warning" + time + ": has predictor_node ended, or is the network cut?";
  }

  /// Written so that NaN is a problem.
  std::string ageProblemOf(const Heard& heard, double silence) const {
    if (!(heard.stamp_age >= -limits_.max_stamp_lead))
      return "the warning is stamped " + seconds(-heard.stamp_age) +
             " ahead of this machine's clock" + above(limits_.max_stamp_lead) +
             ": do the clocks agree, and has simulated time started?";
    const double stamp_age = heard.stamp_age + silence;
    if (!(stamp_age <= limits_.max_data_age))
      return "the newest warning is stamped " + seconds(stamp_age) + " ago" +
             above(limits_.max_data_age) + ": is the network slow, or do the clocks differ?";
    const double data_age = heard.warning.data_age + silence;
    if (!(data_age <= limits_.max_data_age))
      return "its data are " + seconds(data_age) + " old" + above(limits_.max_data_age);
    return "";
  }

  std::string levelProblemOf(const CollisionWarning& warning) const {
    constexpr std::uint32_t kFirstDegradedReason = 1u << 24;  // the reasons below make UNKNOWN
    const bool known =
        warning.level != CollisionWarning::UNKNOWN && warning.reason % kFirstDegradedReason == 0;
    if (known && warning.level <= limits_.highest_level) return "";
    std::string text = "level ";
    text += warning.level == CollisionWarning::CRITICAL ? "CRITICAL"
            : warning.level == CollisionWarning::WARN   ? "WARN"
                                                        : "UNKNOWN";
    if (warning.collision_predicted != 0)
      text += ", contact in " + seconds(warning.time_to_collision);
    return warning.message.empty() ? text : text + ": " + warning.message;
  }

  WatchdogLimits limits_;
  std::map<std::string, std::optional<Heard>> heard_;  // by footprint
};

}  // namespace footprint_collision_predictor
