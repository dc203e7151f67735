// A YAML file of parameters, read as rosparam reads it.
#pragma once

#include <xmlrpcpp/XmlRpcValue.h>

#include <stdexcept>
#include <string>

namespace footprint_collision_predictor::tools {

/// Thrown for a file that cannot be used; what() names it and says why.
class ParameterFileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The struct that the node would find under "~" after `rosparam load`: "1e-3" is a text there, as
/// YAML 1.1 has it.
/// \throws ParameterFileError
XmlRpc::XmlRpcValue readParameters(const std::string& path);

}  // namespace footprint_collision_predictor::tools
