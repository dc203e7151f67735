// The node's parameters for an analysis.
#pragma once

#include "options.hpp"
#include "parameters.hpp"

namespace footprint_collision_predictor::tools {

/// Those of the file, changed by the options.
/// \throws ParameterError, ParameterFileError
Parameters parametersOf(const Options& options);

}  // namespace footprint_collision_predictor::tools
