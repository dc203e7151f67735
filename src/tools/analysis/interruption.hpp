// Ctrl-C: what is done is kept. A second one ends the process at once.
#pragma once

namespace footprint_collision_predictor::tools {

/// From now on.
void watchForInterruption();
bool isInterrupted();

}  // namespace footprint_collision_predictor::tools
