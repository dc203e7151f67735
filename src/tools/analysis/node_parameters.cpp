#include "node_parameters.hpp"

#include "yaml_parameters.hpp"

namespace footprint_collision_predictor::tools {

Parameters parametersOf(const Options& options) {
  XmlRpc::XmlRpcValue values;
  if (!options.params.empty()) values = readParameters(options.params);
  XmlRpc::XmlRpcValue changes = options.changes;
  if (changes.valid())
    for (const auto& [name, value] : changes) values[name] = value;
  return parametersFrom(values);
}

}  // namespace footprint_collision_predictor::tools
