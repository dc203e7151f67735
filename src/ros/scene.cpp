#include "scene.hpp"

#include <algorithm>
#include <iomanip>
#include <sstream>

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

/// Fills twist, horizon and odometry.
void setMotion(const OdometryHistory& odometry, const tf2::BufferCore& tf, const Parameters& p,
               Scene& scene) try {
  if (p.ego_motion == EgoMotion::kStatic) return;
  scene.horizon = 0;
  scene.odometry = odometryAt(scene.stamp, odometry, p.max_data_age, scene.findings);
  if (!scene.odometry) return;
  const PlanarPose from = lookUpPose(tf, p.base_frame, scene.odometry->frame, scene.stamp);
  scene.twist = carriedOver(scene.odometry->twist, from);
  scene.horizon = p.horizon;
} catch (const TransformError& error) {
  scene.findings.add(CollisionWarning::REASON_TRANSFORM, error.what());
}

/// Velocities as seen from a frame on the robot get the motion of that frame added.
core::Twist headerMotion(const ObstacleArray& message, const PlanarPose& body, const Scene& scene,
                         const tf2::BufferCore& tf, const Parameters& p) {
  if (p.obstacle_velocity == ObstacleVelocity::kOverGround) return {};
  const std::string& frame = message.header.frame_id;
  if (frame == p.base_frame) return scene.twist;
  const ros::Duration back(std::min(p.max_data_age, scene.stamp.toSec() / 2));
  const PlanarPose before = lookUpPose(tf, frame, p.base_frame, scene.stamp - back);
  const double moved =
      (before.position - body.position).norm() + (before.x_axis - body.x_axis).norm();
  if (frame == p.fixed_frame || moved > kRigidTolerance)
    throw TransformError("obstacle velocities are said to be relative, but their frame \"" + frame +
                         "\" is not rigid to \"" + p.base_frame +
                         "\": set ~obstacle_velocity to over_ground, or publish in a frame of the "
                         "robot");
  return scene.twist;
}

}  // namespace

Scene makeScene(const ObstacleArray& message, const ros::SteadyTime& arrived,
                const core::Polygon& footprint, const OdometryHistory& odometry,
                const tf2::BufferCore& tf, const Parameters& parameters) {
  const ros::Time& stamp = message.header.stamp;
  const PlanarPose body = lookUpPose(tf, message.header.frame_id, parameters.base_frame, stamp);
  const auto count = static_cast<std::uint32_t>(message.obstacles.size());
  Scene scene{stamp, arrived, footprint, {}, parameters.horizon, {}, {}, count, {}};
  setMotion(odometry, tf, parameters, scene);
  scene.obstacles = toCore(message, body, headerMotion(message, body, scene, tf, parameters));
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
