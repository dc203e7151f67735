// A cheap check of the guarantee that shares nothing with the core: the gap at many times, in 64
// bits. What it finds to be wrong is wrong; what slips between two samples it cannot see.
#pragma once

#include <optional>
#include <string>

#include "case.hpp"

namespace footprint_collision_predictor::test {

/// What is wrong with an answer; empty when nothing is found.
std::string wrongBySampling(const Case& c, const std::optional<core::Contact>& contact);

/// One half of it: whether the disc is far from touching at the reported contact. Less strict: that
/// of a vertex may have been found by a longer neighbour, with the tolerance of that.
std::string inventedBySampling(const Case& c, const core::Contact& contact);

/// The other half: whether the disc overlaps before a contact is reported, if one is. The contact
/// may be that of a whole of which this is a part.
std::string missedBySampling(const Case& c, const std::optional<core::Contact>& contact);

}  // namespace footprint_collision_predictor::test
