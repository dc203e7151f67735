// Live changes of the parameters by dynamic_reconfigure.
#pragma once

#include <dynamic_reconfigure/server.h>
#include <ros/node_handle.h>
#include <xmlrpcpp/XmlRpcValue.h>

#include <cstdint>
#include <functional>
#include <mutex>
#include <string>

#include "footprint_collision_predictor/PredictorConfig.h"
#include "parameters.hpp"

namespace footprint_collision_predictor {

/// The values of the parameters that can be changed live.
PredictorConfig configOf(const Parameters& parameters);

/// The parameters after a change, validated as a whole, in the same way as at the start.
/// \param values all private parameters at the start
/// \throws ParameterError
Parameters changed(XmlRpc::XmlRpcValue values, const PredictorConfig& config);

struct ConfigurationReport {
  PredictorConfig config;
  std::uint64_t accepted = 0;
  std::uint64_t refused = 0;
  std::string refusal;  ///< of the newest change; empty when it was accepted
};

class Reconfiguration {
 public:
  using Adopt = std::function<void(const Parameters&)>;

  /// \param values of all private parameters, validated already
  /// \param adopt is called with every set of parameters that is accepted, in the thread that
  /// serves the callbacks of `private_node`
  Reconfiguration(const ros::NodeHandle& private_node, const XmlRpc::XmlRpcValue& values,
                  const Adopt& adopt);

  ConfigurationReport report() const;  ///< thread-safe

 private:
  void change(PredictorConfig& config);

  const XmlRpc::XmlRpcValue values_;
  const Adopt adopt_;
  mutable std::mutex mutex_;
  ConfigurationReport report_;
  dynamic_reconfigure::Server<PredictorConfig> server_;
};

}  // namespace footprint_collision_predictor
