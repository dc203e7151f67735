// What is measured. Each of these adds to Google Benchmark's list.
#pragma once

#include <memory>

#include "true_contacts.hpp"

namespace footprint_collision_predictor::bench {

using SharedScene = std::shared_ptr<const Scene>;

/// Of the first kInputs obstacles: the first contact of a whole footprint with one obstacle: ours
/// and every peer that can do it.
void addFootprintBenchmarks(const SharedScene& scene, const SceneTruths& truths);

/// One segment that stands still and one obstacle.
void addSegmentBenchmarks(const SharedScene& scene, const SceneTruths& truths);

/// All obstacles in one call, for 10 up to all of the scene's: each segment's earliest contact
/// (batch), the footprint's (lean), each with every set of instructions that this processor has;
/// with the batch filled within the time (filled); and everything there is to say (predict).
void addManyBenchmarks(const SharedScene& scene, const SceneTruths& truths);

/// Adds to what is told of the run: bytes that a batch of discs and one of lines hold for each
/// obstacle, and instructions that this processor has not.
void addContext();

}  // namespace footprint_collision_predictor::bench
