#include "warning_message.hpp"

#include <algorithm>
#include <limits>

namespace footprint_collision_predictor {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
using Warning = CollisionWarning;

void fillContact(const core::FootprintContact& first, const Evaluated& evaluated,
                 CollisionWarning& msg) {
  msg.collision_predicted = 1;
  msg.time_to_collision = first.contact.time;
  msg.segment = static_cast<std::int32_t>(first.segment);
  msg.obstacle_id = evaluated.scene.obstacles.keys[first.obstacle].id;
  msg.contact_point = toMsg(first.contact.point);
  msg.closing_speed = first.closing_speed;
  msg.closest_distance = 0;
  msg.closest_time = first.contact.time;
}

/// Without obstacles there is no gap that could be small, and no time of it.
void fillGaps(const core::Prediction& prediction, CollisionWarning& msg) {
  msg.clearance = prediction.clearance.value_or(kInfinity);
  msg.closest_distance = prediction.closest ? prediction.closest->distance : kInfinity;
  msg.closest_time = prediction.closest ? prediction.closest->time : kNaN;
}

/// Makes a finished warning UNKNOWN; a certain and CRITICAL hit stays.
void addUnknown(std::uint32_t reason, const std::string& words, CollisionWarning& msg) {
  msg.reason |= reason;
  msg.message += (msg.message.empty() ? "" : "; ") + words;
  if (msg.collision_predicted == 0)
    msg.time_to_collision = msg.closest_distance = msg.closest_time = kNaN;
  if (msg.collision_predicted == 0 || msg.level != Warning::CRITICAL) msg.level = Warning::UNKNOWN;
  msg.contact_free_time = 0;
  msg.clearance = kNaN;
}

}  // namespace

CollisionWarning warningMsg(const Evaluated* evaluated, const ros::Time& stamp, core::Level level,
                            const Findings& findings, const Parameters& parameters,
                            const Body& body) {
  CollisionWarning msg;
  msg.header.stamp = stamp;
  msg.header.frame_id = body.frame;
  msg.footprint = body.name;
  msg.level = static_cast<std::uint8_t>(level);
  msg.time_to_collision = findings.makeUnknown() ? kNaN : kInfinity;
  msg.horizon = parameters.horizon;
  msg.segment = -1;
  msg.obstacle_id = -1;
  msg.clearance = msg.closest_distance = msg.closest_time = kNaN;
  msg.reason = findings.reasons();
  msg.message = findings.text();
  if (evaluated) {
    msg.obstacle_count = evaluated->scene.obstacle_count;
    if (evaluated->prediction.first) fillContact(*evaluated->prediction.first, *evaluated, msg);
    const bool all_known = findings.reasons() % kFirstDegradedReason == 0 ||
                           findings.reasons() % kFirstDegradedReason == Warning::REASON_SETTLING;
    if (all_known) fillGaps(evaluated->prediction, msg);
  }
  msg.contact_free_time =
      findings.makeUnknown() ? 0 : std::min(msg.time_to_collision, parameters.horizon);
  return msg;
}

CollisionPrediction predictionMsg(const Evaluated& evaluated, const Findings& findings,
                                  const Parameters& parameters, const Body& body) {
  const Scene& scene = evaluated.scene;
  CollisionPrediction msg;
  msg.header.stamp = scene.stamp;
  msg.header.frame_id = body.frame;
  msg.footprint = body.name;
  msg.area = scene.footprint.area();
  msg.centroid = toMsg(scene.footprint.centroid());
  msg.twist = toMsg(scene.twist);
  msg.segments = toMsg(scene.footprint, evaluated.prediction, scene.obstacles.keys,
                       parameters.horizon, !findings.makeUnknown());
  return msg;
}

CollisionWarning olderBy(double seconds, CollisionWarning warning, const Parameters& parameters) {
  warning.data_age += seconds;
  if (warning.data_age <= parameters.max_data_age || warning.level == Warning::UNKNOWN)
    return warning;
  warning.collision_predicted = 0;  // no hit is certain any more
  warning.segment = -1;
  warning.obstacle_id = -1;
  warning.contact_point = geometry_msgs::Point();
  warning.closing_speed = 0;
  addUnknown(Warning::REASON_OBSTACLES_STALE,
             "the inputs were " + std::to_string(warning.data_age) +
                 " s old when the evaluation was done (~max_data_age)",
             warning);
  return warning;
}

CollisionWarning finishedAfter(double seconds, CollisionWarning warning,
                               const Parameters& parameters) {
  CollisionWarning older = olderBy(seconds, std::move(warning), parameters);
  const double period = 1 / parameters.heartbeat_rate;
  if (seconds > period)
    addUnknown(Warning::REASON_DEADLINE,
               "evaluating " + std::to_string(older.obstacle_count) + " obstacles took " +
                   std::to_string(seconds) + " s, longer than the period of " +
                   std::to_string(period) +
                   " s: send fewer obstacles, simplify the footprint, or lower ~heartbeat_rate",
               older);
  return older;
}

}  // namespace footprint_collision_predictor
