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
  std::size_t hits = 0;         ///< true ones
  std::size_t misses = 0;       ///< true contacts that were not reported
  std::size_t late = 0;         ///< reported, but later than the tolerance allows
  std::size_t inventions = 0;   ///< contacts reported that are none, or not yet
  double worst_time_error = 0;  ///< [s] where truth and method both have a contact
};

/// One question: the obstacle against these segments, of which the earliest contact counts.
struct Question {
  std::vector<Segment> segments;
  Motion circle;
  double radius;
};

/// First contact within the horizon, or kNever, of the circle with its radius grown by `growth`.
double truth(const Question& question, double growth = 0);

Score judge(const std::vector<Question>& questions, const std::vector<double>& truths,
            const Tolerance& tolerance, const std::function<double(std::size_t)>& answer);

}  // namespace footprint_collision_predictor::bench
