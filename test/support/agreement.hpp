// Two questions that must have the same answer, within the guarantee.
#pragma once

#include <optional>
#include <string>

#include "case.hpp"

namespace footprint_collision_predictor::test {

using Answer = std::optional<core::Contact>;

/// Within 1e-9 s, relative for large times.
bool notLater(const Answer& answer, double time);

/// The other case reported contact at `time`; this one did so later, or not at all. That is right
/// only in a graze: nothing touches yet, but by a hair [m].
bool hairIsLeft(const Case& c, double time, double hair);

/// Both touch at the same time or neither does: empty, or both cases as code. The gaps of the two
/// may differ by off_at_a [m] at the time of a, and likewise for b.
std::string disagreement(const Case& one, const Answer& a, const Case& other, const Answer& b,
                         double off_at_a = 0, double off_at_b = 0);
std::string disagreement(const Case& one, const Case& other);

}  // namespace footprint_collision_predictor::test
