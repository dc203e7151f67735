#include "event.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "../warning_line.hpp"
#include "csv_line.hpp"

namespace footprint_collision_predictor::tools {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

Event begun(const Evaluation& evaluation) {
  const ros::Time& stamp = evaluation.answer.warning.header.stamp;
  return {evaluation.elapsed,     evaluation.elapsed,   stamp, stamp,
          CollisionWarning::WARN, momentOf(evaluation), kNaN,  false,
          EventEnd::kRecording};
}

}  // namespace

const char* wordFor(EventEnd end) {
  switch (end) {
    case EventEnd::kClear:
      return "clear";
    case EventEnd::kUnknown:
      return "unknown";
    default:
      return "recording_end";
  }
}

WorstMoment momentOf(const Evaluation& evaluation) {
  const CollisionWarning& w = evaluation.answer.warning;
  return {evaluation.elapsed, w.header.stamp, w.time_to_collision,
          w.segment,          w.obstacle_id,  obstacleIndexOf(evaluation.answer),
          w.contact_point,    w.closing_speed};
}

bool EventFinder::isNear(const CollisionWarning& warning) const {
  return warning.level == CollisionWarning::WARN || warning.level == CollisionWarning::CRITICAL ||
         warning.time_to_collision <= warn_time_;
}

void EventFinder::take(const Evaluation& evaluation) {
  const CollisionWarning& warning = evaluation.answer.warning;
  if (isNear(warning)) {
    if (open_ && evaluation.elapsed - open_->end > longest_unknown_ + 1e-9 && unknown_since_end_)
      close(EventEnd::kUnknown);
    if (!open_) open_ = begun(evaluation);
    extend(evaluation);
    unknown_since_end_ = false;
  } else if (open_ && warning.level == CollisionWarning::UNKNOWN) {
    unknown_since_end_ = true;
  } else if (open_) {
    close(unknown_since_end_ ? EventEnd::kUnknown : EventEnd::kClear);
  }
}

void EventFinder::extend(const Evaluation& evaluation) {
  const CollisionWarning& warning = evaluation.answer.warning;
  open_->end = evaluation.elapsed;
  open_->end_stamp = warning.header.stamp;
  open_->level = std::max(open_->level, warning.level);
  // fmin passes over NaN.
  open_->closest_distance = std::fmin(open_->closest_distance, warning.clearance);
  if (warning.collision_predicted == 0) return;
  open_->contact = open_->contact || warning.time_to_collision <= 0;
  if (!(open_->worst.time_to_collision <= warning.time_to_collision))
    open_->worst = momentOf(evaluation);
}

void EventFinder::close(EventEnd how) {
  open_->ended = how;
  events_.push_back(*open_);
  open_.reset();
  unknown_since_end_ = false;
}

std::vector<Event> EventFinder::finish() {
  if (open_) close(unknown_since_end_ ? EventEnd::kUnknown : EventEnd::kRecording);
  return std::move(events_);
}

std::string eventsHeader() {
  return "start,end,duration,start_elapsed,end_elapsed,worst,worst_elapsed,time_to_collision,level,"
         "segment,obstacle_id,obstacle_index,contact_x,contact_y,closing_speed,closest_distance,"
         "contact,ended";
}

std::string eventsRow(const Event& event) {
  const auto whole = [](auto value) { return static_cast<std::int64_t>(value); };
  const WorstMoment& worst = event.worst;
  CsvLine line;
  line.add(event.begin_stamp).add(event.end_stamp).add(event.end - event.begin);
  line.add(event.begin).add(event.end).add(worst.stamp).add(worst.elapsed);
  line.add(worst.time_to_collision).add(levelName(event.level)).add(whole(worst.segment));
  line.add(worst.obstacle_id).add(whole(worst.obstacle_index));
  line.add(worst.contact_point.x).add(worst.contact_point.y).add(worst.closing_speed);
  line.add(event.closest_distance).add(whole(event.contact)).add(std::string(wordFor(event.ended)));
  return line.text();
}

}  // namespace footprint_collision_predictor::tools
