// How right the answers of a method are, by the 113-bit oracle.
#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <vector>

#include "scene.hpp"

namespace footprint_collision_predictor::bench {

/// "No contact within the horizon", so that answers are plain numbers.
constexpr double kNever = std::numeric_limits<double>::infinity();

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

/// Places in a list: [begin, end).
struct Range {
  std::size_t begin;
  std::size_t end;
};

/// When do any of these obstacles first touch any of these segments?
struct Question {
  const Scene* scene;
  Range segments;
  Range obstacles;
};

/// First contact within the horizon, or kNever, when all radii are grown by `growth` [m].
double truth(const Question& question, double growth = 0);

/// \param truths of the questions, to spare asking again for every method
/// \param answer of a method to question number i, or kNever
Score judge(const std::vector<Question>& questions, const std::vector<double>& truths,
            const Tolerance& tolerance, const std::function<double(std::size_t)>& answer);

}  // namespace footprint_collision_predictor::bench
