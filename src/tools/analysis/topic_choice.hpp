// Which topics of a bag are the obstacles, the odometry and the footprint.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "options.hpp"
#include "parameters.hpp"
#include "pipeline.hpp"
#include "recording.hpp"

namespace footprint_collision_predictor::tools {

struct TopicChoice {
  InputNames names;  ///< empty where none is needed
  std::string obstacles_type;
  std::map<std::string, Input> inputs;  ///< everything that is read, /tf, /tf_static and /clock too
};

/// The topics that the body needs: those that the options or ~footprints name, else those whose
/// types fit.
/// \param bag its name, for messages
/// \throws BagProblem when none or several fit, with what there is and the option to use, or when
///     one has the right type in a version that is not understood
TopicChoice chooseTopics(const std::string& bag, const std::vector<RecordedTopic>& topics,
                         const Options& options, const Parameters& parameters, const Body& body);

}  // namespace footprint_collision_predictor::tools
