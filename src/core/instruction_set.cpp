#include "instruction_set.hpp"

namespace footprint_collision_predictor::core {

bool isSupported(InstructionSet set) {
  if (set == InstructionSet::kBaseline) return true;
#ifdef __x86_64__
  if (set == InstructionSet::kAvx2) return __builtin_cpu_supports("avx2");
  return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
         __builtin_cpu_supports("avx512dq");
#else
  return false;
#endif
}

InstructionSet widestInstructionSet() {
  static const InstructionSet widest =
      isSupported(InstructionSet::kAvx512) ? InstructionSet::kAvx512
      : isSupported(InstructionSet::kAvx2) ? InstructionSet::kAvx2
                                           : InstructionSet::kBaseline;
  return widest;
}

}  // namespace footprint_collision_predictor::core
