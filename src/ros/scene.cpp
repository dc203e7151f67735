#include "scene.hpp"

#include <algorithm>
#include <iomanip>
#include <sstream>

#include "frame_motion.hpp"
#include "input_findings.hpp"

namespace footprint_collision_predictor {
namespace {

// How far [m, and per metre] a frame on the body may seem to move against it.
constexpr double kRigidTolerance = 1e-3;

std::string seconds(double value) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(3) << value << " s";
  return text.str();
}

/// The odometry at the stamp, or nothing and a finding.
std::optional<OdometrySample> odometryAt(const ros::Time& stamp, const OdometryHistory& odometry,
                                         double max_age, Findings& findings) {
  const auto sample = odometry.at(stamp);
  if (odometry.empty()) return std::nullopt;  // which is a finding of its own
  if (!sample) {
    findings.add(CollisionWarning::REASON_ODOM_MISSING,
                 "no odometry at or before the obstacles' stamp: publish odom, or set "
                 "~ego_motion to static for a sensor that stands still");
    return std::nullopt;
  }
  const double age = secondsBetween(sample->stamp, stamp);
  if (age <= max_age) return sample;
  findings.add(CollisionWarning::REASON_ODOM_STALE,
               "the odometry is " + seconds(age) + " older than the obstacles (~max_data_age " +
                   seconds(max_age) + "): is its source running?");
  return std::nullopt;
}

/// Of the base, told for the body's frame as if that were rigid to it; or nothing and a finding.
std::optional<core::Twist> baseTwist(const OdometryHistory& odometry, const tf2::BufferCore& tf,
                                     const Parameters& p, const Body& body, Scene& scene) try {
  scene.motion.odometry = odometryAt(scene.stamp, odometry, p.max_data_age, scene.findings);
  if (!scene.motion.odometry) return std::nullopt;
  const PlanarPose from = lookUpPose(tf, body.frame, scene.motion.odometry->frame, scene.stamp);
  return carriedOver(scene.motion.odometry->twist, from);
} catch (const TransformError& error) {
  scene.findings.add(CollisionWarning::REASON_TRANSFORM, error.what());
  return std::nullopt;
}

/// Of the body's frame by itself; or nothing and a finding.
std::optional<core::Twist> frameTwist(const tf2::BufferCore& tf, const Parameters& p,
                                      const Body& body, Scene& scene) try {
  const FrameMotion motion = frameMotion(tf, p.fixed_frame, body.frame, scene.stamp);
  const double age = secondsBetween(motion.newest, scene.stamp);
  if (age > p.max_data_age)
    throw TransformError(oldTransformsText(p.fixed_frame, body.frame, age, p.max_data_age));
  scene.motion.transforms = motion.newest;
  return motion.twist;
} catch (const TransformError& error) {
  scene.findings.add(CollisionWarning::REASON_TRANSFORM, error.what());
  return std::nullopt;
}

/// Fills twist, horizon and motion. \return the twist of the base, as far as it is needed
core::Twist setMotion(const OdometryHistory& odometry, const tf2::BufferCore& tf,
                      const Parameters& p, const Body& body, Scene& scene) {
  const core::Twist still;
  const auto base =
      needsOdometry(p, body) ? baseTwist(odometry, tf, p, body, scene) : std::optional(still);
  const auto own = body.motion == BodyMotion::kOdom ? base
                   : body.motion == BodyMotion::kTf ? frameTwist(tf, p, body, scene)
                                                    : std::optional(still);
  scene.twist = own.value_or(still);
  scene.horizon = base && own ? p.horizon : 0;
  return base.value_or(still);
}

/// Velocities as seen from a frame on the base get the motion of that frame added.
/// \param base its twist at the body's frame
core::Twist headerMotion(const ObstacleArray& message, const core::Twist& base,
                         const tf2::BufferCore& tf, const Parameters& p) {
  if (p.obstacle_velocity == ObstacleVelocity::kOverGround) return {};
  const std::string& frame = message.header.frame_id;
  if (frame == p.base_frame) return base;
  const ros::Time& stamp = message.header.stamp;
  const ros::Duration back(std::min(p.max_data_age, stamp.toSec() / 2));
  const PlanarPose at = lookUpPose(tf, frame, p.base_frame, stamp);
  const PlanarPose before = lookUpPose(tf, frame, p.base_frame, stamp - back);
  const double moved = (before.position - at.position).norm() + (before.x_axis - at.x_axis).norm();
  if (frame == p.fixed_frame || moved > kRigidTolerance)
    throw TransformError("obstacle velocities are said to be relative, but their frame \"" + frame +
                         "\" is not rigid to \"" + p.base_frame +
                         "\": set ~obstacle_velocity to over_ground, or publish in a frame of the "
                         "robot");
  return base;
}

}  // namespace

Scene makeScene(const ObstacleArray& message, const ros::SteadyTime& arrived,
                const core::Polygon& footprint, const OdometryHistory& odometry,
                const tf2::BufferCore& tf, const Parameters& parameters, const Body& body) {
  const ros::Time& stamp = message.header.stamp;
  const PlanarPose pose = lookUpPose(tf, message.header.frame_id, body.frame, stamp);
  const auto count = static_cast<std::uint32_t>(message.obstacles.size());
  Scene scene{stamp, arrived, footprint, {}, parameters.horizon, {}, {}, count, {}};
  const core::Twist base = setMotion(odometry, tf, parameters, body, scene);
  scene.obstacles = toCore(message, pose, headerMotion(message, base, tf, parameters));
  scene.findings.add(scene.obstacles.findings);
  return scene;
}

std::vector<core::Obstacle> carriedOn(const Scene& scene, double dt) {
  std::vector<core::Obstacle> obstacles;
  obstacles.reserve(scene.obstacles.in_body.size());
  for (const core::Obstacle& obstacle : scene.obstacles.in_body)
    obstacles.push_back(obstacle.after(dt, scene.twist));
  return obstacles;
}

}  // namespace footprint_collision_predictor
