// Approaches: the stretches of a recording in which something came nearer than the warn time.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "replay.hpp"

namespace footprint_collision_predictor::tools {

/// How an approach ended.
enum class EventEnd { kClear, kUnknown, kRecording };

/// "clear", "unknown" or "recording_end"
const char* wordFor(EventEnd end);

/// The moment of an approach with the smallest time to collision, the first of several.
struct WorstMoment {
  double elapsed;  ///< [s] since the window's begin
  ros::Time stamp;
  double time_to_collision;  ///< [s]
  std::int32_t segment;
  std::int64_t obstacle_id;
  std::int32_t obstacle_index;
  geometry_msgs::Point contact_point;
  double closing_speed;  ///< [m/s]
};

WorstMoment momentOf(const Evaluation& evaluation);

struct Event {
  double begin;  ///< [s] since the window's begin, of the first evaluation in it
  double end;    ///< [s] of the last one
  ros::Time begin_stamp;
  ros::Time end_stamp;
  std::uint8_t level;  ///< the highest: CollisionWarning's WARN or CRITICAL
  WorstMoment worst;
  double closest_distance;  ///< [m] smallest clearance seen, below 0 inside; NaN: not known
  bool contact;             ///< whether something was seen to touch the footprint
  EventEnd ended;
};

/// An approach begins with a level of WARN or CRITICAL, or a certain contact within the warn time,
/// and ends with the level, which falls only after some messages. Unknown moments that are short
/// belong to it.
class EventFinder {
 public:
  EventFinder(double warn_time, double longest_unknown)
      : warn_time_(warn_time), longest_unknown_(longest_unknown) {}

  void take(const Evaluation& evaluation);
  /// The recording is over.
  std::vector<Event> finish();

 private:
  bool isNear(const CollisionWarning& warning) const;
  void extend(const Evaluation& evaluation);
  void close(EventEnd how);

  const double warn_time_;        // [s]
  const double longest_unknown_;  // [s]
  std::optional<Event> open_;
  bool unknown_since_end_ = false;  // of the open one
  std::vector<Event> events_;
};

/// First line of events.csv, and a line for an event, without where it is from.
std::string eventsHeader();
std::string eventsRow(const Event& event);

}  // namespace footprint_collision_predictor::tools
