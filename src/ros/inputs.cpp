#include "inputs.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "input_findings.hpp"

namespace footprint_collision_predictor {

using Warning = CollisionWarning;

Inputs::Inputs(const Parameters& parameters, const Body& body, const InputNames& names,
               bool simulated_clock)
    : parameters_(parameters),
      body_(body),
      clock_(simulated_clock, parameters.max_data_age),
      obstacles_(names.obstacles),
      footprints_(names.footprint),
      odometries_(names.odom),
      footprint_(body.footprint) {}

void Inputs::reconfigure(const Parameters& parameters) {
  parameters_ = parameters;
  clock_.setLongestStop(parameters.max_data_age);
}

bool Inputs::forgetIfClockJumpedBack(const Moment& now) {
  if (!clock_started_ && !now.ros.isZero()) {
    clock_started_ = true;
    // Before, no stamp could be judged; one of another clock would hide all that follow.
    odometry_.dropAfter(now.ros + ros::Duration(kLargestLead));
  }
  if (!clock_.jumpedBack(now)) return false;
  jump_ = {};
  jump_.add(Warning::REASON_CLOCK, "the clock was set back, so that earlier inputs do not count");
  odometry_.clear();
  out_of_order_ = {};
  for (InputRecord* input : {&obstacles_, &footprints_, &odometries_}) input->forget();
  return true;
}

void Inputs::receive(InputKind kind, const RawMessage& message, const Moment& now) {
  record(kind).receive(message, now.steady);
}

void Inputs::acceptObstacles(const Moment& stamp_and_arrival) {
  obstacles_.accept(stamp_and_arrival);
  jump_ = {};
}

void Inputs::acceptFootprint(const core::Polygon& footprint, const Moment& stamp_and_arrival) {
  footprints_.accept(stamp_and_arrival);
  footprint_ = footprint;
}

void Inputs::acceptOdometry(const OdometrySample& sample) {
  if (odometry_.add(sample)) {
    odometries_.accept({sample.stamp, sample.arrived});
    out_of_order_ = {};
  } else {
    out_of_order_ = odometries_.ignore();
  }
}

void Inputs::refuse(InputKind kind, const Findings& why, const Moment& now) {
  record(kind).refuse(why, now.steady);
}

void Inputs::setRegistered(const PublishersOf& publishers_of) {
  for (InputRecord* input : {&obstacles_, &footprints_, &odometries_})
    input->setRegistered(publishers_of(input->topic()));
}

const InputRecord& Inputs::record(InputKind kind) const {
  switch (kind) {
    case InputKind::kObstacles:
      return obstacles_;
    case InputKind::kFootprint:
      return footprints_;
    default:
      return odometries_;
  }
}

InputRecord& Inputs::record(InputKind kind) {
  return const_cast<InputRecord&>(std::as_const(*this).record(kind));
}

Findings Inputs::missing(InputKind kind) const {
  const std::string& topic = record(kind).topic();
  Findings findings;
  if (kind == InputKind::kObstacles && !obstacles_.newest())
    findings.add(Warning::REASON_OBSTACLES_MISSING,
                 "nothing has come on " + topic +
                     " yet: start the tracker, or remap obstacles to its topic");
  if (kind == InputKind::kFootprint && !footprint_)
    findings.add(Warning::REASON_FOOTPRINT_MISSING,
                 "no footprint yet: set " +
                     std::string(parameters_.footprints.empty() ? "~footprint"
                                                                : "its polygon in ~footprints") +
                     ", or publish one on " + topic);
  if (kind == InputKind::kOdometry && odometry_.empty())
    findings.add(Warning::REASON_ODOM_MISSING,
                 "nothing has come on " + topic +
                     " yet: remap odom to the robot's odometry, or set ~ego_motion to static for a "
                     "sensor that stands still");
  return findings;
}

Findings Inputs::standing(InputKind kind, const Moment& now) const {
  if (kind == InputKind::kFootprint && body_.footprint) return {};
  if (kind == InputKind::kOdometry && !needsOdometry(parameters_, body_)) return {};
  const InputRecord& input = record(kind);
  Findings findings = input.refusal();
  if (kind == InputKind::kOdometry) findings.add(out_of_order_);
  if (!input.refusal().makeUnknown()) findings.add(missing(kind));
  findings.add(input.severalPublishers(now.steady));
  return findings;
}

Findings Inputs::standing(const Moment& now) const {
  Findings findings = jump_;
  for (const InputKind kind : {InputKind::kObstacles, InputKind::kFootprint, InputKind::kOdometry})
    findings.add(standing(kind, now));
  return findings;
}

Findings Inputs::tooOld(const Moment& now, const MotionSource& used) const {
  const double limit = parameters_.max_data_age;
  Findings findings = clock_.findings(now);
  const bool obstacles_old = newest() && ageOf(obstacles_, now) > limit;
  if (obstacles_old)
    findings.add(Warning::REASON_OBSTACLES_STALE,
                 staleText(obstacles_.topic(), ageOf(obstacles_, now), limit));
  // With old obstacles the odometry used is old as well, which says nothing about its source.
  const double odometry_age =
      odometryAge(now, obstacles_old ? odometry_.at(now.ros) : used.odometry);
  if (odometry_age > limit)
    findings.add(Warning::REASON_ODOM_STALE, staleText(odometries_.topic(), odometry_age, limit));
  const double transforms_age = transformsAge(now, used);
  if (!obstacles_old && transforms_age > limit)
    findings.add(Warning::REASON_TRANSFORM,
                 oldTransformsText(parameters_.fixed_frame, body_.frame, transforms_age, limit));
  return findings;
}

double Inputs::age(const Moment& now, const MotionSource& used) const {
  return std::max(
      {ageOf(obstacles_, now), odometryAge(now, used.odometry), transformsAge(now, used)});
}

InputReport Inputs::report(InputKind kind, const Moment& now) const {
  const InputRecord& input = record(kind);
  const double age = ageOf(input, now);
  Findings findings = clock_.findings(now);
  if (kind == InputKind::kObstacles) findings.add(jump_);
  findings.add(standing(kind, now));
  const bool expires = kind != InputKind::kFootprint;
  if (expires && input.newest() && age > parameters_.max_data_age)
    findings.add(kind == InputKind::kObstacles ? Warning::REASON_OBSTACLES_STALE
                                               : Warning::REASON_ODOM_STALE,
                 staleText(input.topic(), age, parameters_.max_data_age));
  return reportOf(input, age, findings, now.steady);
}

/// By the ROS clock; live also by the steady one, in case the wall clock is wrong or set.
double Inputs::ageOf(const ros::Time& stamp, const ros::SteadyTime& arrived,
                     const Moment& now) const {
  const double age = std::max(0.0, secondsBetween(stamp, now.ros));
  return clock_.isSimulated() ? age : std::max(age, secondsBetween(arrived, now.steady));
}

double Inputs::ageOf(const InputRecord& input, const Moment& now) const {
  const auto& newest = input.newest();
  return newest ? ageOf(newest->ros, newest->steady, now) : std::numeric_limits<double>::infinity();
}

double Inputs::odometryAge(const Moment& now, const std::optional<OdometrySample>& sample) const {
  return sample ? ageOf(sample->stamp, sample->arrived, now) : 0;
}

/// They are no younger than the obstacles, whose age is told by the steady clock as well.
double Inputs::transformsAge(const Moment& now, const MotionSource& used) {
  return used.transforms ? std::max(0.0, secondsBetween(*used.transforms, now.ros)) : 0;
}

}  // namespace footprint_collision_predictor
