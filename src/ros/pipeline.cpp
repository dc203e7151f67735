#include "pipeline.hpp"

#include <algorithm>

#include "input_findings.hpp"
#include "markers.hpp"

namespace footprint_collision_predictor {

using Warning = CollisionWarning;

Pipeline::Pipeline(const Parameters& parameters, const Body& body, const InputNames& names,
                   tf2::BufferCore& tf, bool simulated_clock, Publish publish)
    : parameters_(parameters),
      body_(body),
      names_(names),
      tf_(tf),
      publish_(std::move(publish)),
      simulated_clock_(simulated_clock),
      inputs_(parameters, body_, names, simulated_clock),
      level_(parameters.thresholds, parameters.clear_after),
      queue_(parameters_, body_, tf_, inputs_.odometry()) {}

void Pipeline::receiveObstacles(const RawMessage& raw, const Moment& now) {
  watchClock(now);
  inputs_.receive(InputKind::kObstacles, raw, now);
  Findings problem;
  auto message = decodedOrRefused(
      [&] { return decodeObstacles(raw, parameters_); },
      {names_.obstacles, Warning::REASON_OBSTACLES_INVALID, Warning::REASON_OBSTACLES_TYPE},
      problem);
  if (message)
    queue_.push({now, std::move(*message)});
  else
    queue_.push({now, Refusal{problem, InputKind::kObstacles}});
  process(now);
}

void Pipeline::receiveFootprint(const RawMessage& raw, const Moment& now) {
  watchClock(now);
  inputs_.receive(InputKind::kFootprint, raw, now);
  Findings problem;
  auto message = decodedOrRefused(
      [&] { return decodeFootprint(raw, parameters_.max_vertices); },
      {names_.footprint, Warning::REASON_FOOTPRINT_INVALID, Warning::REASON_FOOTPRINT_INVALID},
      problem);
  if (message)
    queue_.push({now, std::move(*message)});
  else
    queue_.push({now, Refusal{problem, InputKind::kFootprint}});
  process(now);
}

void Pipeline::receiveOdometry(const RawMessage& raw, const Moment& now) {
  watchClock(now);
  inputs_.receive(InputKind::kOdometry, raw, now);
  Findings problem;
  const auto message = decodedOrRefused(
      [&] { return decodeOdometry(raw); },
      {names_.odom, Warning::REASON_ODOM_INVALID, Warning::REASON_ODOM_INVALID}, problem);
  // A simulated clock may reach this process late; odometry from a little later does no harm.
  const double largest_lead = simulated_clock_ ? parameters_.max_data_age : kLargestLead;
  if (message) problem = odometryFindings(*message, now, largest_lead, names_.odom);
  if (problem.makeUnknown()) return inputs_.refuse(InputKind::kOdometry, problem, now);
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
  if (!scene_ || inputs_.tooOld(now, motion()).makeUnknown()) adoptPending();
  return warningNow(now, Counts::kNot);
}

visualization_msgs::MarkerArray Pipeline::picture(const CollisionWarning& repeated,
                                                  const Moment& now) const {
  const bool usable = scene_ && !inputs_.tooOld(now, motion()).makeUnknown();
  const auto& footprint = inputs_.footprint();
  return markers(repeated, usable ? &*scene_ : nullptr, footprint ? &*footprint : nullptr,
                 parameters_.thresholds);
}

/// What was predicted holds for the old parameters only.
void Pipeline::adoptPending() {
  if (!pending_) return;
  parameters_ = *pending_;
  inputs_.reconfigure(parameters_);
  level_.reconfigure(parameters_.thresholds, parameters_.clear_after);
  scene_.reset();
  pending_.reset();
}

void Pipeline::watchClock(const Moment& now) {
  if (!inputs_.forgetIfClockJumpedBack(now)) return;
  tf_.clear();
  queue_.clear();
  level_.reset();
  scene_.reset();
}

void Pipeline::take(const Waiting& waiting, const Moment& now) try {
  if (const auto* refusal = std::get_if<Refusal>(&waiting.message)) {
    if (refusal->of == InputKind::kObstacles) return refuse(refusal->why, now);
    return inputs_.refuse(refusal->of, refusal->why, now);
  }
  if (const auto* footprint = std::get_if<geometry_msgs::PolygonStamped>(&waiting.message))
    return adopt(*footprint, waiting.arrived, now);
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
  obstacles_frame_ = message.header.frame_id;
  waited_ = secondsBetween(arrived.steady, now.steady);
  const Findings unusable =
      headerFindings(message.header, arrived, now, parameters_.max_data_age, names_.obstacles);
  if (unusable.makeUnknown()) return refuse(unusable, now);
  const auto newest = inputs_.newest();
  if (newest && stamp < newest->ros)
    return publish_({warningNow(now, Counts::kNot, inputs_.ignoreObstacles()), {}, now});
  adoptPending();
  std::optional<Scene> scene;
  try {
    if (inputs_.footprint())
      scene = makeScene(message, arrived.steady, *inputs_.footprint(), inputs_.odometry(), tf_,
                        parameters_, body_);
  } catch (const TransformError& error) {
    Findings untransformed;
    untransformed.add(Warning::REASON_TRANSFORM, error.what());
    return refuse(untransformed, now);
  }
  if (newest && secondsBetween(newest->ros, stamp) > parameters_.max_data_age)
    level_.restartCount();
  inputs_.acceptObstacles({stamp, arrived.steady});
  scene_ = std::move(scene);
  const Counts counts = newest && newest->ros == stamp ? Counts::kAsReplacement : Counts::kAsNew;
  Findings findings = inputs_.tooOld(now, motion());
  const bool usable = scene_ && !findings.makeUnknown();
  findings.add(inputs_.standing(now));
  if (!usable) return publish_({warning(nullptr, stamp, findings, now, counts), {}, now});
  findings.add(scene_->findings);
  const Evaluated evaluated{*scene_, core::predict(scene_->footprint, scene_->twist,
                                                   scene_->obstacles.in_body, scene_->horizon)};
  const CollisionPrediction prediction = predictionMsg(evaluated, findings, parameters_, body_);
  publish_({warning(&evaluated, stamp, findings, now, counts), prediction, now});
}

void Pipeline::adopt(const geometry_msgs::PolygonStamped& message, const Moment& arrived,
                     const Moment& now) {
  const std_msgs::Header& header = message.header;
  Findings problem;
  try {
    if (header.frame_id.empty()) throw TransformError("its frame_id is empty");
    if (header.stamp.isZero() && header.frame_id != body_.frame)
      throw TransformError("its stamp is 0, so its place on the robot is not known");
    const PlanarPose body = lookUpPose(tf_, header.frame_id, body_.frame, header.stamp);
    inputs_.acceptFootprint(core::Polygon(toCore(message.polygon, body)),
                            {header.stamp, arrived.steady});
    if (scene_) scene_->footprint = *inputs_.footprint();
    return;
  } catch (const TransformError& error) {
    problem.add(Warning::REASON_FOOTPRINT_INVALID | Warning::REASON_TRANSFORM,
                "the footprint on " + names_.footprint + " cannot be used: " + error.what());
  } catch (const core::InvalidPolygon& error) {
    problem.add(Warning::REASON_FOOTPRINT_INVALID,
                "the footprint on " + names_.footprint + " is refused: " + error.what());
  }
  inputs_.refuse(InputKind::kFootprint, problem, now);
}

/// The last good message stays predicted, but the level is at least UNKNOWN until a good one comes.
void Pipeline::refuse(const Findings& why, const Moment& now) {
  inputs_.refuse(InputKind::kObstacles, why, now);
  publish_({warningNow(now, Counts::kAsNew), {}, now});
}

CollisionWarning Pipeline::warningNow(const Moment& now, Counts counts, Findings findings) {
  findings.add(inputs_.tooOld(now, motion()));
  const bool usable = scene_ && !findings.makeUnknown();
  findings.add(inputs_.standing(now));
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

CollisionWarning Pipeline::warning(const Evaluated* evaluated, const ros::Time& stamp,
                                   Findings& findings, const Moment& now, Counts counts) {
  Sight sight;
  if (evaluated) {
    const auto& first = evaluated->prediction.first;
    sight = {true, first ? std::make_optional(first->contact.time) : std::nullopt};
  }
  const core::Level level = level_.judge(sight, counts, findings);
  CollisionWarning msg = warningMsg(evaluated, stamp, level, findings, parameters_, body_);
  msg.data_age = inputs_.age(now, motion());
  return msg;
}

}  // namespace footprint_collision_predictor
