#include "pipeline.hpp"

#include <ros/console.h>

#include <algorithm>
#include <cmath>

#include "input_findings.hpp"

namespace footprint_collision_predictor {

using Warning = CollisionWarning;

Pipeline::Pipeline(const Parameters& parameters, const InputNames& names, tf2::BufferCore& tf,
                   bool simulated_clock, Publish publish)
    : parameters_(parameters),
      names_(names),
      tf_(tf),
      publish_(std::move(publish)),
      clock_(simulated_clock, parameters.max_data_age),
      hold_(parameters.clear_after),
      queue_(parameters_, tf_, odometry_),
      footprint_(parameters.footprint) {}

void Pipeline::receiveObstacles(const RawMessage& raw, const Moment& now) {
  watchClock(now);
  Findings problem;
  auto message = decodedOrRefused(
      [&] { return decodeObstacles(raw, parameters_); },
      {names_.obstacles, Warning::REASON_OBSTACLES_INVALID, Warning::REASON_OBSTACLES_TYPE},
      problem);
  if (!message) return refuse(problem, now);
  queue_.push({now, std::move(*message)});
  process(now);
}

void Pipeline::receiveFootprint(const RawMessage& raw, const Moment& now) {
  watchClock(now);
  Findings problem;
  auto message = decodedOrRefused(
      [&] { return decodeFootprint(raw, parameters_.max_vertices); },
      {names_.footprint, Warning::REASON_FOOTPRINT_INVALID, Warning::REASON_FOOTPRINT_INVALID},
      problem);
  if (!message) {
    footprint_refusal_ = problem;
    return;
  }
  queue_.push({now, std::move(*message)});
  process(now);
}

void Pipeline::receiveOdometry(const RawMessage& raw, const Moment& now) {
  watchClock(now);
  Findings problem;
  const auto message = decodedOrRefused(
      [&] { return decodeOdometry(raw); },
      {names_.odom, Warning::REASON_ODOM_INVALID, Warning::REASON_ODOM_INVALID}, problem);
  if (message) problem = odometryFindings(*message, now, names_.odom);
  odometry_refusal_ = problem;
  if (problem.makeUnknown()) return;
  const auto& twist = message->twist.twist;
  const std::string& frame = message->child_frame_id;
  const bool taken = odometry_.add({message->header.stamp,
                                    now.steady,
                                    frame.empty() ? parameters_.base_frame : frame,
                                    {{twist.linear.x, twist.linear.y}, twist.angular.z}});
  if (!taken)
    odometry_refusal_.add(Warning::REASON_OUT_OF_ORDER,
                          ignoredText(names_.odom, ++ignored_odometry_));
  process(now);
}

void Pipeline::process(const Moment& now) {
  watchClock(now);
  while (const auto waiting = queue_.pop(now)) {
    if (const auto* obstacles = std::get_if<ObstacleArray>(&waiting->message))
      evaluate(*obstacles, waiting->arrived, now);
    else
      adopt(std::get<geometry_msgs::PolygonStamped>(waiting->message));
  }
}

CollisionWarning Pipeline::repeat(const Moment& now) {
  watchClock(now);
  return warningNow(now, false);
}

/// A looped recording or restarted simulator: all that belongs to the old time goes.
void Pipeline::watchClock(const Moment& now) {
  if (!clock_.jumpedBack(now)) return;
  ROS_WARN_STREAM("the clock jumped back to " << now.ros
                                              << ": all inputs of the old time are dropped");
  jump_ = {};
  jump_.add(Warning::REASON_CLOCK, "the clock was set back, so that earlier inputs do not count");
  tf_.clear();
  queue_.clear();
  odometry_.clear();
  hold_.reset();
  scene_.reset();
  newest_.reset();
  obstacles_refusal_ = footprint_refusal_ = odometry_refusal_ = {};
}

void Pipeline::evaluate(const ObstacleArray& message, const Moment& arrived, const Moment& now) {
  const ros::Time& stamp = message.header.stamp;
  const Findings unusable =
      headerFindings(message.header, arrived, now, parameters_.max_data_age, names_.obstacles);
  if (unusable.makeUnknown()) return refuse(unusable, now);
  if (newest_ && stamp < newest_->ros) {
    Findings ignored;
    ignored.add(Warning::REASON_OUT_OF_ORDER, ignoredText(names_.obstacles, ++ignored_obstacles_));
    return publish_(warningNow(now, false, ignored), std::nullopt);
  }
  std::optional<Scene> scene;
  try {
    if (footprint_)
      scene = makeScene(message, arrived.steady, *footprint_, odometry_, tf_, parameters_);
  } catch (const TransformError& error) {
    Findings untransformed;
    untransformed.add(Warning::REASON_TRANSFORM, error.what());
    return refuse(untransformed, now);
  }
  if (newest_ && secondsBetween(newest_->ros, stamp) > parameters_.max_data_age)
    hold_.restartCount();
  newest_ = Moment{stamp, arrived.steady};
  obstacles_refusal_ = jump_ = {};
  scene_ = std::move(scene);
  Findings findings = standingFindings(now);
  if (!scene_) return publish_(warning(nullptr, stamp, findings, now, true), std::nullopt);
  findings.add(scene_->findings);
  const Evaluated evaluated{*scene_, core::predict(scene_->footprint, scene_->twist,
                                                   scene_->circles.obstacles, scene_->horizon)};
  const CollisionPrediction prediction = predictionMsg(evaluated, findings, parameters_);
  publish_(warning(&evaluated, stamp, findings, now, true), prediction);
}

void Pipeline::adopt(const geometry_msgs::PolygonStamped& message) {
  footprint_refusal_ = {};
  const std_msgs::Header& header = message.header;
  try {
    if (header.frame_id.empty()) throw TransformError("its frame_id is empty");
    if (header.stamp.isZero() && header.frame_id != parameters_.base_frame)
      throw TransformError("its stamp is 0, so its place on the robot is not known");
    const PlanarPose body = lookUpPose(tf_, header.frame_id, parameters_.base_frame, header.stamp);
    // Not emplace: it would lose the last good one when this throws.
    footprint_ = core::Polygon(toCore(message.polygon, body));
  } catch (const TransformError& error) {
    footprint_refusal_.add(
        Warning::REASON_FOOTPRINT_INVALID | Warning::REASON_TRANSFORM,
        "the footprint on " + names_.footprint + " cannot be used: " + error.what());
  } catch (const core::InvalidPolygon& error) {
    footprint_refusal_.add(Warning::REASON_FOOTPRINT_INVALID,
                           "the footprint on " + names_.footprint + " is refused: " + error.what());
  }
}

/// The last good message stays predicted, but the level is at least UNKNOWN until a good one comes.
void Pipeline::refuse(const Findings& why, const Moment& now) {
  obstacles_refusal_ = why;
  publish_(warningNow(now, true), std::nullopt);
}

/// \param counts whether this is what an obstacles message gives, which alone changes the level
/// held
CollisionWarning Pipeline::warningNow(const Moment& now, bool counts, Findings findings) {
  Findings too_old = clock_.findings(now);
  too_old.add(staleness(now));
  findings.add(too_old);
  findings.add(standingFindings(now));
  if (!scene_ || too_old.makeUnknown()) return warning(nullptr, now.ros, findings, now, counts);
  findings.add(scene_->findings);
  const ros::Time stamp = std::max(now.ros, scene_->stamp);
  const auto obstacles = carriedOn(*scene_, secondsBetween(scene_->stamp, stamp));
  const Evaluated evaluated{
      *scene_, core::predict(scene_->footprint, scene_->twist, obstacles, scene_->horizon)};
  return warning(&evaluated, stamp, findings, now, counts);
}

CollisionWarning Pipeline::warning(const Evaluated* evaluated, const ros::Time& stamp,
                                   Findings& findings, const Moment& now, bool counts) {
  std::optional<double> time_to_collision;
  if (evaluated && evaluated->prediction.first)
    time_to_collision = evaluated->prediction.first->contact.time;
  const core::Level seen =
      core::assess(time_to_collision, !findings.makeUnknown(), parameters_.thresholds);
  if (counts) hold_.update(seen);
  const core::Level level = hold_.shown(seen);
  const std::string in_a_row =
      std::to_string(parameters_.clear_after) + " obstacles messages in a row (~clear_after)";
  if (level == core::Level::kUnknown && !findings.makeUnknown())
    findings.add(Warning::REASON_SETTLING, "the inputs are good, but not yet for " + in_a_row);
  CollisionWarning msg = warningMsg(evaluated, stamp, level, findings, parameters_);
  if (level != core::Level::kUnknown && core::isWorse(level, seen))
    msg.message += "the level is held until a lower one is given by " + in_a_row;
  msg.data_age = std::max(obstaclesAge(now), odometryAge(now));
  return msg;
}

Findings Pipeline::standingFindings(const Moment& now) const {
  Findings findings = clock_.findings(now);
  findings.add(jump_);
  findings.add(obstacles_refusal_);
  findings.add(footprint_refusal_);
  findings.add(odometry_refusal_);
  if (!newest_ && !obstacles_refusal_.makeUnknown())
    findings.add(Warning::REASON_OBSTACLES_MISSING, "nothing has come on " + names_.obstacles +
                                                        " yet: start the tracker, or remap "
                                                        "obstacles to its topic");
  if (!footprint_ && !footprint_refusal_.makeUnknown())
    findings.add(Warning::REASON_FOOTPRINT_MISSING,
                 "no footprint yet: set ~footprint, or publish one on " + names_.footprint);
  if (parameters_.ego_motion == EgoMotion::kOdom && odometry_.empty() &&
      !odometry_refusal_.makeUnknown())
    findings.add(Warning::REASON_ODOM_MISSING,
                 "nothing has come on " + names_.odom +
                     " yet: remap odom to the robot's odometry, or set ~ego_motion to static for a "
                     "sensor that stands still");
  return findings;
}

Findings Pipeline::staleness(const Moment& now) const {
  Findings findings;
  if (newest_ && obstaclesAge(now) > parameters_.max_data_age)
    findings.add(Warning::REASON_OBSTACLES_STALE,
                 staleText(names_.obstacles, obstaclesAge(now), parameters_.max_data_age));
  else if (odometryAge(now) > parameters_.max_data_age)
    findings.add(Warning::REASON_ODOM_STALE,
                 staleText(names_.odom, odometryAge(now), parameters_.max_data_age));
  return findings;
}

/// By the ROS clock; live also by the steady one, in case the wall clock is wrong or set.
double Pipeline::ageOf(const ros::Time& stamp, const ros::SteadyTime& arrived,
                       const Moment& now) const {
  const double age = std::max(0.0, secondsBetween(stamp, now.ros));
  return clock_.isSimulated() ? age : std::max(age, secondsBetween(arrived, now.steady));
}

double Pipeline::obstaclesAge(const Moment& now) const {
  return newest_ ? ageOf(newest_->ros, newest_->steady, now) : INFINITY;
}

double Pipeline::odometryAge(const Moment& now) const {
  if (!scene_ || !scene_->odometry) return 0;
  return ageOf(scene_->odometry->stamp, scene_->odometry->arrived, now);
}

}  // namespace footprint_collision_predictor
