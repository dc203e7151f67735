// How right the answers of a method are.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "true_contacts.hpp"

namespace footprint_collision_predictor::bench {

/// What a method claims of itself; it is held to this and to nothing stricter.
struct Tolerance {
  double depth;      ///< [m] a contact that stays shallower may be missed
  double clearance;  ///< [m] a pass that comes so near may be called a contact
  double time;       ///< [s] beyond both
};

/// As time_to_collision.hpp has it.
constexpr Tolerance kGuarantee{0, 1e-9, 1e-9};

struct Score {
  std::size_t questions = 0;
  std::size_t hits = 0;         ///< true ones
  std::size_t misses = 0;       ///< true contacts that were not reported
  std::size_t late = 0;         ///< reported, but later than the tolerance allows
  std::size_t inventions = 0;   ///< contacts reported that are none, or not yet
  double worst_time_error = 0;  ///< [s] where truth and method both have a contact
};

/// \param truths of the questions, to spare asking again for every method
/// \param answer of a method to question number i, or kNever
Score judge(const std::vector<Question>& questions, const std::vector<Truth>& truths,
            const Tolerance& tolerance, const std::function<double(std::size_t)>& answer);

}  // namespace footprint_collision_predictor::bench
