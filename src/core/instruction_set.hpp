// Which instructions the processor has, beyond those that every one has.
#pragma once

namespace footprint_collision_predictor::core {

enum class InstructionSet { kBaseline, kAvx2, kAvx512 };

bool isSupported(InstructionSet set);
/// The widest that this processor supports.
InstructionSet widestInstructionSet();

}  // namespace footprint_collision_predictor::core
