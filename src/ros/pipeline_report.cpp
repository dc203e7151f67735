// The part of the pipeline that the diagnostics see.
#include "pipeline.hpp"
#include "planar_pose.hpp"

namespace footprint_collision_predictor {
namespace {

using Warning = CollisionWarning;

// What is found wrong with an input only when it is used.
constexpr std::uint32_t kOfObstacles = Warning::REASON_OBSTACLES_INVALID | Warning::REASON_LIMIT |
                                       Warning::REASON_NOT_PREDICTED | Warning::REASON_DUPLICATE_ID;
constexpr std::uint32_t kOfOdometry =
    Warning::REASON_ODOM_MISSING | Warning::REASON_ODOM_STALE | Warning::REASON_ODOM_INVALID;

}  // namespace

Report Pipeline::report(const Moment& now) const {
  Report report;
  report.made = now.steady;
  report.max_data_age = parameters_.max_data_age;
  report.obstacles = inputs_.report(InputKind::kObstacles, now);
  if (needsOdometry(parameters_, body_))
    report.odometry = inputs_.report(InputKind::kOdometry, now);
  if (scene_) {
    report.obstacles.findings.add(scene_->findings.with(kOfObstacles));
    if (report.odometry) report.odometry->findings.add(scene_->findings.with(kOfOdometry));
  }
  BodyReport body{body_.name, {}, transformReport(now)};
  if (!body_.footprint) body.footprint = inputs_.report(InputKind::kFootprint, now);
  report.bodies.push_back(std::move(body));
  report.clock = inputs_.clockReport(now);
  return report;
}

TransformReport Pipeline::transformReport(const Moment& now) const {
  TransformReport report{body_.frame, obstacles_frame_, {}, waited_, {}};
  Findings all = inputs_.standing(now);
  if (scene_) all.add(scene_->findings);
  all.add(inputs_.tooOld(now, motion()));
  report.findings = all.with(Warning::REASON_TRANSFORM);
  if (obstacles_frame_.empty()) return report;
  const auto newest = newestTransform(tf_, obstacles_frame_, body_.frame);
  if (newest) report.delay = newest->isZero() ? 0 : secondsBetween(*newest, now.ros);
  return report;
}

}  // namespace footprint_collision_predictor
