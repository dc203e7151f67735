// A cheap check of the guarantee that shares nothing with the core: the gap at many times, in 64
// bits. What it finds to be wrong is wrong; what slips between two samples it cannot see.
#pragma once

#include <string>

#include "case.hpp"

namespace footprint_collision_predictor::test {

/// What is wrong with an answer; empty when nothing is found.
std::string wrongBySampling(const Case& c, const std::optional<core::Contact>& contact);

}  // namespace footprint_collision_predictor::test
