// What rounding may amount to, and where an approach counts as a contact.
#pragma once

#include <limits>

namespace footprint_collision_predictor::core {

// Each of the some ten operations from the input to a gap errs by at most half an epsilon of the
// terms summed up in contactTolerance(); half of 32 leaves room for both the gap and the root.
constexpr double kRoundingAllowance = 32 * std::numeric_limits<double>::epsilon();

// What is left of the gap [m] when a segment that turns counts as touched, beside rounding.
constexpr double kTurningTolerance = 1e-9;

// More than any of the quick bounds can err by, relative to the terms that are summed up: they need
// not be tight.
constexpr double kGenerous = 1e-12;
// The same where they are computed in single precision.
constexpr double kGenerousSingle = 1e-5;

}  // namespace footprint_collision_predictor::core
