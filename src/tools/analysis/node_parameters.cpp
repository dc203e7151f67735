#include "node_parameters.hpp"

#include "yaml_parameters.hpp"

namespace footprint_collision_predictor::tools {

Parameters parametersOf(const Options& options) {
  XmlRpc::XmlRpcValue values;
  if (!options.params.empty()) values = readParameters(options.params);
  XmlRpc::XmlRpcValue changes = options.changes;
  if (changes.valid())
    for (const auto& [name, value] : changes) values[name] = value;
  const Parameters parameters = parametersFrom(values);
  if (!options.footprint.empty() && !parameters.footprints.empty())
    throw ParameterError(
        "--footprint is for a robot with a single footprint; with ~footprints each body says its "
        "topic itself");
  return parameters;
}

}  // namespace footprint_collision_predictor::tools
