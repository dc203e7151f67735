// The bodies of a robot that has several: a list of structs.
#pragma once

#include "parameter_reader.hpp"
#include "parameters.hpp"

namespace footprint_collision_predictor {

/// Reads ~footprints, of which each has `name`, `frame_id`, `polygon` or `topic`, and maybe
/// `motion`: that is odom, tf or static, by default ~ego_motion in base_frame, and tf elsewhere.
///
/// \param parameters of which base_frame, ego_motion and max_vertices have been read
void readFootprints(ParameterReader& reader, Parameters& parameters);

/// What ~ego_motion means for a body in base_frame.
BodyMotion baseMotion(const Parameters& parameters);

}  // namespace footprint_collision_predictor
