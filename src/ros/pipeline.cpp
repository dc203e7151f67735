#include "pipeline.hpp"

#include <algorithm>

#include "input_findings.hpp"
#include "markers.hpp"

namespace footprint_collision_predictor {

using Warning = CollisionWarning;

Pipeline::Pipeline(const Parameters& parameters, const InputNames& names, tf2::BufferCore& tf,
                   bool simulated_clock, Publish publish)
    : parameters_(parameters),
      names_(names),
      tf_(tf),
      publish_(std::move(publish)),
      largest_odometry_lead_(simulated_clock ? parameters.max_data_age : kLargestLead),
      inputs_(parameters, names, simulated_clock),
      hold_(parameters.clear_after),
      queue_(parameters_, tf_, inputs_.odometry()) {}

void Pipeline::receiveObstacles(const RawMessage& raw, const Moment& now) {
  watchClock(now);
  Findings problem;
  auto message = decodedOrRefused(
      [&] { return decodeObstacles(raw, parameters_); },
      {names_.obstacles, Warning::REASON_OBSTACLES_INVALID, Warning::REASON_OBSTACLES_TYPE},
      problem);
  if (message)
    queue_.push({now, std::move(*message)});
  else
    queue_.push({now, Refusal{problem, Refusal::Of::kObstacles}});
  process(now);
}

void Pipeline::receiveFootprint(const RawMessage& raw, const Moment& now) {
  watchClock(now);
  Findings problem;
  auto message = decodedOrRefused(
      [&] { return decodeFootprint(raw, parameters_.max_vertices); },
      {names_.footprint, Warning::REASON_FOOTPRINT_INVALID, Warning::REASON_FOOTPRINT_INVALID},
      problem);
  if (message)
    queue_.push({now, std::move(*message)});
  else
    queue_.push({now, Refusal{problem, Refusal::Of::kFootprint}});
  process(now);
}

void Pipeline::receiveOdometry(const RawMessage& raw, const Moment& now) {
  watchClock(now);
  Findings problem;
  const auto message = decodedOrRefused(
      [&] { return decodeOdometry(raw); },
      {names_.odom, Warning::REASON_ODOM_INVALID, Warning::REASON_ODOM_INVALID}, problem);
  if (message) problem = odometryFindings(*message, now, largest_odometry_lead_, names_.odom);
  if (problem.makeUnknown()) return inputs_.refuseOdometry(problem);
  const auto& twist = message->twist.twist;
  const std::string& frame = message->child_frame_id;
  inputs_.acceptOdometry({message->header.stamp,
                          now.steady,
                          frame.empty() ? parameters_.base_frame : frame,
                          {{twist.linear.x, twist.linear.y}, twist.angular.z}});
  process(now);
}

void Pipeline::process(const Moment& now) {
  watchClock(now);
  while (const auto waiting = queue_.pop(now)) take(*waiting, now);
}

CollisionWarning Pipeline::repeat(const Moment& now) {
  watchClock(now);
  return warningNow(now, Counts::kNot);
}

visualization_msgs::MarkerArray Pipeline::picture(const CollisionWarning& repeated,
                                                  const Moment& now) const {
  const bool usable = scene_ && !inputs_.tooOld(now, scene_->odometry).makeUnknown();
  const auto& footprint = inputs_.footprint();
  return markers(repeated, usable ? &*scene_ : nullptr, footprint ? &*footprint : nullptr,
                 parameters_.thresholds);
}

void Pipeline::watchClock(const Moment& now) {
  if (!inputs_.forgetIfClockJumpedBack(now)) return;
  tf_.clear();
  queue_.clear();
  hold_.reset();
  scene_.reset();
}

void Pipeline::take(const Waiting& waiting, const Moment& now) try {
  if (const auto* refusal = std::get_if<Refusal>(&waiting.message)) {
    if (refusal->of == Refusal::Of::kObstacles) return refuse(refusal->why, now);
    return inputs_.refuseFootprint(refusal->why);
  }
  if (const auto* footprint = std::get_if<geometry_msgs::PolygonStamped>(&waiting.message))
    return adopt(*footprint);
  evaluate(std::get<ObstacleArray>(waiting.message), waiting.arrived, now);
} catch (const std::exception& error) {
  // Nothing throws here as far as is known; if something does, it must not look like nothing.
  scene_.reset();
  Findings failed;
  failed.add(Warning::REASON_OBSTACLES_INVALID,
             std::string("a message could not be evaluated: ") + error.what());
  refuse(failed, now);
}

void Pipeline::evaluate(const ObstacleArray& message, const Moment& arrived, const Moment& now) {
  const ros::Time& stamp = message.header.stamp;
  const Findings unusable =
      headerFindings(message.header, arrived, now, parameters_.max_data_age, names_.obstacles);
  if (unusable.makeUnknown()) return refuse(unusable, now);
  const auto newest = inputs_.newest();
  if (newest && stamp < newest->ros)
    return publish_({warningNow(now, Counts::kNot, inputs_.ignoreObstacles()), {}, now});
  std::optional<Scene> scene;
  try {
    if (inputs_.footprint())
      scene = makeScene(message, arrived.steady, *inputs_.footprint(), inputs_.odometry(), tf_,
                        parameters_);
  } catch (const TransformError& error) {
    Findings untransformed;
    untransformed.add(Warning::REASON_TRANSFORM, error.what());
    return refuse(untransformed, now);
  }
  if (newest && secondsBetween(newest->ros, stamp) > parameters_.max_data_age) hold_.restartCount();
  inputs_.acceptObstacles({stamp, arrived.steady});
  scene_ = std::move(scene);
  const Counts counts = newest && newest->ros == stamp ? Counts::kAsReplacement : Counts::kAsNew;
  Findings findings = inputs_.tooOld(now, scene_ ? scene_->odometry : std::nullopt);
  const bool usable = scene_ && !findings.makeUnknown();
  findings.add(inputs_.standing());
  if (!usable) return publish_({warning(nullptr, stamp, findings, now, counts), {}, now});
  findings.add(scene_->findings);
  const Evaluated evaluated{*scene_, core::predict(scene_->footprint, scene_->twist,
                                                   scene_->circles.obstacles, scene_->horizon)};
  const CollisionPrediction prediction = predictionMsg(evaluated, findings, parameters_);
  publish_({warning(&evaluated, stamp, findings, now, counts), prediction, now});
}

void Pipeline::adopt(const geometry_msgs::PolygonStamped& message) {
  const std_msgs::Header& header = message.header;
  Findings problem;
  try {
    if (header.frame_id.empty()) throw TransformError("its frame_id is empty");
    if (header.stamp.isZero() && header.frame_id != parameters_.base_frame)
      throw TransformError("its stamp is 0, so its place on the robot is not known");
    const PlanarPose body = lookUpPose(tf_, header.frame_id, parameters_.base_frame, header.stamp);
    inputs_.acceptFootprint(core::Polygon(toCore(message.polygon, body)));
    if (scene_) scene_->footprint = *inputs_.footprint();
    return;
  } catch (const TransformError& error) {
    problem.add(Warning::REASON_FOOTPRINT_INVALID | Warning::REASON_TRANSFORM,
                "the footprint on " + names_.footprint + " cannot be used: " + error.what());
  } catch (const core::InvalidPolygon& error) {
    problem.add(Warning::REASON_FOOTPRINT_INVALID,
                "the footprint on " + names_.footprint + " is refused: " + error.what());
  }
  inputs_.refuseFootprint(problem);
}

/// The last good message stays predicted, but the level is at least UNKNOWN until a good one comes.
void Pipeline::refuse(const Findings& why, const Moment& now) {
  inputs_.refuseObstacles(why);
  publish_({warningNow(now, Counts::kAsNew), {}, now});
}

CollisionWarning Pipeline::warningNow(const Moment& now, Counts counts, Findings findings) {
  findings.add(inputs_.tooOld(now, scene_ ? scene_->odometry : std::nullopt));
  const bool usable = scene_ && !findings.makeUnknown();
  findings.add(inputs_.standing());
  if (!usable) return warning(nullptr, now.ros, findings, now, counts);
  findings.add(scene_->findings);
  // Without known motions nothing can be carried on: what touched at the stamp is all that is
  // certain.
  const bool moves = scene_->horizon > 0;
  const ros::Time stamp = moves ? std::max(now.ros, scene_->stamp) : scene_->stamp;
  const auto obstacles = carriedOn(*scene_, secondsBetween(scene_->stamp, stamp));
  const Evaluated evaluated{
      *scene_, core::predict(scene_->footprint, scene_->twist, obstacles, scene_->horizon)};
  return warning(&evaluated, stamp, findings, now, counts);
}

/// \param counts only obstacles messages change the level that is held
CollisionWarning Pipeline::warning(const Evaluated* evaluated, const ros::Time& stamp,
                                   Findings& findings, const Moment& now, Counts counts) {
  core::Level seen = core::Level::kUnknown;
  if (evaluated) {
    const auto& first = evaluated->prediction.first;
    seen = core::assess(first ? std::make_optional(first->contact.time) : std::nullopt,
                        !findings.makeUnknown(), parameters_.thresholds);
  }
  if (counts == Counts::kAsNew) hold_.update(seen);
  if (counts == Counts::kAsReplacement) hold_.replaceNewest(seen);
  const core::Level level = hold_.shown(seen);
  const std::string in_a_row =
      std::to_string(parameters_.clear_after) + " obstacles messages in a row (~clear_after)";
  if (level == core::Level::kUnknown && !findings.makeUnknown())
    findings.add(Warning::REASON_SETTLING, "the inputs are good, but not yet for " + in_a_row);
  if (level != core::Level::kUnknown && core::isWorse(level, seen))
    findings.add(0, "the level is held until a lower one is given by " + in_a_row);
  CollisionWarning msg = warningMsg(evaluated, stamp, level, findings, parameters_);
  msg.data_age = inputs_.age(now, scene_ ? scene_->odometry : std::nullopt);
  return msg;
}

}  // namespace footprint_collision_predictor
