// The guarantee, put to the oracle of whole footprints.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "footprint_case.hpp"
#include "guarantee.hpp"

namespace footprint_collision_predictor::test {

/// What the cases of a suite amounted to.
struct FootprintTally {
  std::size_t cases = 0;
  std::size_t hits = 0;       ///< of the footprint
  std::size_t now = 0;        ///< of them at t = 0
  std::size_t undecided = 0;  ///< grazes that the oracle leaves open
  double worst_lateness = 0;  ///< [s] behind the true contact
  double worst_gap = 0;       ///< [m] left at a reported contact
  double worst_closest = 0;   ///< [m] error of the closest distance
};

/// What is wrong with the answers to this case; empty when all of this holds. The footprint's and
/// each segment's first contact is never missed, never late by more than 1e-9 s (relative for large
/// times) and never invented: the gap is then at most 1e-9 m, or 1e-6 m where the footprint turns,
/// scaled by the size of the coordinates. The segment and the point that are named are touched.
/// Clearance is right to the same gap. The closest distance is right to 1e-6 m, at a time when the
/// gap is so small. What predict() says is what the single functions say.
std::string violations(const FootprintCase& c, FootprintTally* tally);

/// For a single case, as asCode() prints it.
void expectFootprintGuarantee(const FootprintCase& c);

/// Puts that many random cases to the guarantee and prints a line of summary.
void runFootprintSuite(const std::string& suite, const SuiteSize& size,
                       const std::function<FootprintCase(Random&)>& make);

}  // namespace footprint_collision_predictor::test
