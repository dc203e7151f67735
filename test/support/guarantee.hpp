// The guarantee of time_to_collision.hpp, put to the oracles.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>

#include "case.hpp"
#include "random.hpp"

namespace footprint_collision_predictor::test {

/// What the cases of a suite amounted to.
struct Tally {
  std::size_t cases = 0;
  std::size_t hits = 0;
  std::size_t misses = 0;
  double worst_lateness = 0;  ///< [s] behind the true contact
  double worst_gap = 0;       ///< [m] left at a reported contact
  double worst_share = 0;     ///< of that gap in the size of the coordinates, or in 1 m
  std::size_t undecided = 0;  ///< grazes of which nobody can tell whether they touch
};

/// Gap [m] that may be left at a reported contact: 1e-9 m, or 1e-6 m where the segment turns,
/// scaled by the size of the coordinates.
double allowedGap(const Case& c, double t);

/// What is wrong with the answer to this case; empty when the guarantee holds: (a) never missed and
/// never late by more than 1e-9 s, relative for large times; (b) never invented: the gap at the
/// reported time is at most allowedGap(), and no more than the core promises of itself; (c) the
/// time lies within [0, horizon]; (d) the point is the nearest one of the segment, and an end that
/// is named is exact.
std::string violations(const Case& c, Tally* tally);

/// For a single case, as asCode() prints it.
void expectGuarantee(const Case& c);

/// The seed of every random suite, from PROPERTY_SEED, else 1.
std::uint64_t suiteSeed();
/// How many cases a suite has: each time, and in the long run that PROPERTY_LONG=1 asks for.
struct SuiteSize {
  std::size_t each_time;
  std::size_t long_run;
};
constexpr SuiteSize kMain{200000, 10000000};
constexpr SuiteSize kSpecial{200000, 1000000};
constexpr SuiteSize kHalf{100000, 1000000};
constexpr SuiteSize kLaw{100000, 1000000};
constexpr SuiteSize kProven{20000, 1000000};  // with intervals, which take their time

/// The size that is asked for, times PROPERTY_SCALE.
std::size_t scaled(const SuiteSize& size);

/// Calls each(random, index) for that many cases, stops after five that failed, and puts the
/// suite's name, seed and index into what they print.
void forEachCase(const std::string& suite, const SuiteSize& size,
                 const std::function<std::string(Random&)>& each);

/// Puts that many random cases to the guarantee and prints a line of summary.
Tally runSuite(const std::string& suite, const SuiteSize& size,
               const std::function<Case(Random&)>& make);

}  // namespace footprint_collision_predictor::test
