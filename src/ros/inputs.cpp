#include "inputs.hpp"

#include <ros/console.h>

#include <algorithm>
#include <limits>

#include "input_findings.hpp"

namespace footprint_collision_predictor {

using Warning = CollisionWarning;

Inputs::Inputs(const Parameters& parameters, const InputNames& names, bool simulated_clock)
    : parameters_(parameters),
      names_(names),
      clock_(simulated_clock, parameters.max_data_age),
      footprint_(parameters.footprint) {}

bool Inputs::forgetIfClockJumpedBack(const Moment& now) {
  if (!clock_started_ && !now.ros.isZero()) {
    clock_started_ = true;
    // Before, no stamp could be judged; one of another clock would hide all that follow.
    odometry_.dropAfter(now.ros + ros::Duration(kLargestLead));
  }
  if (!clock_.jumpedBack(now)) return false;
  ROS_WARN_STREAM("the clock jumped back to " << now.ros
                                              << ": all inputs of the old time are dropped");
  jump_ = {};
  jump_.add(Warning::REASON_CLOCK, "the clock was set back, so that earlier inputs do not count");
  newest_.reset();
  odometry_.clear();
  obstacles_refusal_ = footprint_refusal_ = odometry_refusal_ = {};
  return true;
}

void Inputs::acceptObstacles(const Moment& stamp_and_arrival) {
  newest_ = stamp_and_arrival;
  obstacles_refusal_ = jump_ = {};
}

void Inputs::acceptFootprint(const core::Polygon& footprint) {
  footprint_ = footprint;
  footprint_refusal_ = {};
}

void Inputs::acceptOdometry(const OdometrySample& sample) {
  if (odometry_.add(sample))
    odometry_refusal_ = {};
  else
    odometry_refusal_.add(Warning::REASON_OUT_OF_ORDER,
                          ignoredText(names_.odom, ++ignored_odometry_));
}

Findings Inputs::ignoreObstacles() {
  Findings findings;
  findings.add(Warning::REASON_OUT_OF_ORDER, ignoredText(names_.obstacles, ++ignored_obstacles_));
  return findings;
}

Findings Inputs::standing() const {
  Findings findings = jump_;
  findings.add(obstacles_refusal_);
  findings.add(footprint_refusal_);
  findings.add(odometry_refusal_);
  if (!newest_ && !obstacles_refusal_.makeUnknown())
    findings.add(Warning::REASON_OBSTACLES_MISSING,
                 "nothing has come on " + names_.obstacles +
                     " yet: start the tracker, or remap obstacles to its topic");
  if (!footprint_ && !footprint_refusal_.makeUnknown())
    findings.add(Warning::REASON_FOOTPRINT_MISSING,
                 "no footprint yet: set ~footprint, or publish one on " + names_.footprint);
  const bool needs_odometry = parameters_.ego_motion == EgoMotion::kOdom;
  if (needs_odometry && odometry_.empty() && !odometry_refusal_.makeUnknown())
    findings.add(Warning::REASON_ODOM_MISSING,
                 "nothing has come on " + names_.odom +
                     " yet: remap odom to the robot's odometry, or set ~ego_motion to static for a "
                     "sensor that stands still");
  return findings;
}

Findings Inputs::tooOld(const Moment& now, const std::optional<OdometrySample>& used) const {
  const double limit = parameters_.max_data_age;
  Findings findings = clock_.findings(now);
  const bool obstacles_old = newest_ && obstaclesAge(now) > limit;
  if (obstacles_old)
    findings.add(Warning::REASON_OBSTACLES_STALE,
                 staleText(names_.obstacles, obstaclesAge(now), limit));
  // With old obstacles the odometry used is old as well, which says nothing about its source.
  const double odometry_age = odometryAge(now, obstacles_old ? odometry_.at(now.ros) : used);
  if (odometry_age > limit)
    findings.add(Warning::REASON_ODOM_STALE, staleText(names_.odom, odometry_age, limit));
  return findings;
}

double Inputs::age(const Moment& now, const std::optional<OdometrySample>& used) const {
  return std::max(obstaclesAge(now), odometryAge(now, used));
}

/// By the ROS clock; live also by the steady one, in case the wall clock is wrong or set.
double Inputs::ageOf(const ros::Time& stamp, const ros::SteadyTime& arrived,
                     const Moment& now) const {
  const double age = std::max(0.0, secondsBetween(stamp, now.ros));
  return clock_.isSimulated() ? age : std::max(age, secondsBetween(arrived, now.steady));
}

double Inputs::obstaclesAge(const Moment& now) const {
  return newest_ ? ageOf(newest_->ros, newest_->steady, now)
                 : std::numeric_limits<double>::infinity();
}

double Inputs::odometryAge(const Moment& now, const std::optional<OdometrySample>& sample) const {
  return sample ? ageOf(sample->stamp, sample->arrived, now) : 0;
}

}  // namespace footprint_collision_predictor
