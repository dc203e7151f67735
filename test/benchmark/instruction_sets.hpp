// The instructions that the core's batch can be asked to use.
#pragma once

#include <string>
#include <vector>

#include "broad_phase.hpp"

namespace footprint_collision_predictor::bench {

struct NamedSet {
  std::string name;
  core::InstructionSet set;
};

inline std::vector<NamedSet> allSets() {
  return {{"baseline", core::InstructionSet::kBaseline},
          {"avx2", core::InstructionSet::kAvx2},
          {"avx512", core::InstructionSet::kAvx512}};
}

/// Those that this processor has.
inline std::vector<NamedSet> supportedSets() {
  std::vector<NamedSet> sets;
  for (const NamedSet& set : allSets())
    if (core::isSupported(set.set)) sets.push_back(set);
  return sets;
}

}  // namespace footprint_collision_predictor::bench
