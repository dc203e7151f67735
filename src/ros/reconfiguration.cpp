#include "reconfiguration.hpp"

#include <ros/console.h>

namespace footprint_collision_predictor {

PredictorConfig configOf(const Parameters& p) {
  PredictorConfig config;
  config.horizon = p.horizon;
  config.warn_time = p.thresholds.warn_time;
  config.critical_time = p.thresholds.critical_time;
  config.clear_after = static_cast<int>(p.clear_after);
  config.max_data_age = p.max_data_age;
  config.transform_tolerance = p.transform_tolerance;
  config.heartbeat_rate = p.heartbeat_rate;
  config.max_obstacles = static_cast<int>(p.max_obstacles);
  return config;
}

Parameters changed(XmlRpc::XmlRpcValue values, const PredictorConfig& config) {
  values["horizon"] = config.horizon;
  values["warn_time"] = config.warn_time;
  values["critical_time"] = config.critical_time;
  values["clear_after"] = config.clear_after;
  values["max_data_age"] = config.max_data_age;
  values["transform_tolerance"] = config.transform_tolerance;
  values["heartbeat_rate"] = config.heartbeat_rate;
  values["max_obstacles"] = config.max_obstacles;
  return parametersFrom(values);
}

Reconfiguration::Reconfiguration(const ros::NodeHandle& private_node,
                                 const XmlRpc::XmlRpcValue& values, const Adopt& adopt)
    : values_(values),
      adopt_(adopt),
      report_{configOf(parametersFrom(values)), 0, 0, {}},
      server_(private_node) {
  server_.setCallback([this](PredictorConfig& config, std::uint32_t) { change(config); });
}

ConfigurationReport Reconfiguration::report() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return report_;
}

/// Whatever `config` is left at goes back to the client and to the parameter server.
void Reconfiguration::change(PredictorConfig& config) {
  const std::lock_guard<std::mutex> lock(mutex_);
  try {
    adopt_(changed(values_, config));
    report_.config = config;
    report_.refusal.clear();
    ++report_.accepted;
  } catch (const ParameterError& error) {
    config = report_.config;
    report_.refusal = error.what();
    ++report_.refused;
    ROS_ERROR_STREAM("the change of parameters is refused, the old ones stay:\n" << error.what());
  }
}

}  // namespace footprint_collision_predictor
