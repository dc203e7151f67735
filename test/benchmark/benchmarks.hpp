// What is measured. Each of these adds to Google Benchmark's list; a scene must outlive the run.
#pragma once

#include <memory>

#include "scene.hpp"

namespace footprint_collision_predictor::bench {

using SharedScene = std::shared_ptr<const Scene>;

/// The first contact of a whole footprint with one obstacle: ours and every peer that can do it.
void addFootprintBenchmarks(const SharedScene& scene);

/// One segment and one obstacle.
void addSegmentBenchmarks(const SharedScene& scene);

/// All segments and all obstacles in one call, for 10 up to `most` obstacles.
void addManyBenchmarks(MotionKind kind, std::size_t most);

}  // namespace footprint_collision_predictor::bench
