#include "parameters.hpp"

#include <sstream>

#include "footprint_collision_predictor/motion.hpp"
#include "footprint_name.hpp"
#include "footprints_parameter.hpp"
#include "parameter_reader.hpp"

namespace footprint_collision_predictor {
namespace {

using Reader = ParameterReader;

std::string text(double value) {
  std::ostringstream stream;
  stream << value;
  return stream.str();
}

void requireConsistent(const Parameters& p, Reader& reader) {
  reader.require(p.thresholds.critical_time <= p.thresholds.warn_time,
                 "~critical_time " + text(p.thresholds.critical_time) + " is above ~warn_time " +
                     text(p.thresholds.warn_time) +
                     "; allowed is 0 < critical_time <= warn_time <= horizon");
  reader.require(p.thresholds.warn_time <= p.horizon,
                 "~warn_time " + text(p.thresholds.warn_time) + " is above ~horizon " +
                     text(p.horizon) + "; allowed is 0 < critical_time <= warn_time <= horizon");
  reader.require(p.transform_tolerance <= p.max_data_age,
                 "~transform_tolerance " + text(p.transform_tolerance) +
                     " is above ~max_data_age " + text(p.max_data_age) +
                     "; a message would be too old when its transform comes");
  reader.require(!(reader.has("footprint") && reader.has("footprints")),
                 "~footprint and ~footprints are both set; allowed is one of them");
}

void throwIfAny(const std::vector<std::string>& complaints) {
  if (complaints.empty()) return;
  std::string all;
  for (const std::string& complaint : complaints) all += (all.empty() ? "" : "\n") + complaint;
  throw ParameterError(all);
}

}  // namespace

Parameters parametersFrom(const XmlRpc::XmlRpcValue& values) {
  constexpr double kShortest = 1e-3;  // [s] any positive time is meant in seconds, not below
  Parameters p;
  Reader reader(values);
  reader.number("horizon", kShortest, core::kMaxHorizon, p.horizon);
  reader.number("warn_time", kShortest, core::kMaxHorizon, p.thresholds.warn_time);
  reader.number("critical_time", kShortest, core::kMaxHorizon, p.thresholds.critical_time);
  reader.number("max_data_age", kShortest, 60, p.max_data_age);
  reader.number("transform_tolerance", 0, 60, p.transform_tolerance);
  reader.number("heartbeat_rate", 10, 1000, p.heartbeat_rate);
  reader.count("clear_after", 1, 1000, p.clear_after);
  reader.count("max_obstacles", 1, 1000000, p.max_obstacles);
  reader.count("max_vertices", 3, 100000, p.max_vertices);
  reader.frame("base_frame", p.base_frame);
  reader.frame("fixed_frame", p.fixed_frame);
  reader.choice<EgoMotion>(
      "ego_motion", {{"odom", EgoMotion::kOdom}, {"static", EgoMotion::kStatic}}, p.ego_motion);
  reader.choice<ObstacleVelocity>(
      "obstacle_velocity",
      {{"over_ground", ObstacleVelocity::kOverGround}, {"relative", ObstacleVelocity::kRelative}},
      p.obstacle_velocity);
  reader.choice<ObstacleDetectorRadius>("obstacle_detector_radius",
                                        {{"true_radius", ObstacleDetectorRadius::kTrueRadius},
                                         {"radius", ObstacleDetectorRadius::kRadius}},
                                        p.obstacle_detector_radius);
  double diagnostic_period = 1;  // is read by diagnostic_updater, which throws for a wrong one
  reader.number("diagnostic_period", 0.01, 60, diagnostic_period);
  reader.polygon("footprint", p.max_vertices, p.footprint);
  readFootprints(reader, p);
  reader.refuseUnknown();
  requireConsistent(p, reader);
  throwIfAny(reader.complaints());
  return p;
}

std::vector<Body> bodiesOf(const Parameters& p) {
  if (!p.footprints.empty()) return p.footprints;
  return {{kOnlyFootprint, p.base_frame, p.footprint, "footprint", baseMotion(p)}};
}

bool needsOdometry(const Parameters& p, const Body& body) {
  const bool seen_from_base = p.obstacle_velocity == ObstacleVelocity::kRelative;
  return body.motion == BodyMotion::kOdom || (seen_from_base && p.ego_motion == EgoMotion::kOdom);
}

}  // namespace footprint_collision_predictor
