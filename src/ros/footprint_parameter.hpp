// The footprint as costmap_2d takes it: a list of [x, y] pairs, or the same as a string.
#pragma once

#include <xmlrpcpp/XmlRpcValue.h>

#include <vector>

#include "footprint_collision_predictor/geometry.hpp"

namespace footprint_collision_predictor {

/// \return the vertices [m] in the order given, not yet validated as a polygon
/// \throws std::invalid_argument that shows both accepted forms
std::vector<core::Vec2> footprintVertices(const XmlRpc::XmlRpcValue& value);

}  // namespace footprint_collision_predictor
