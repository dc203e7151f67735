#include <algorithm>

#include "benchmarks.hpp"
#include "footprint_collision_predictor/predictor.hpp"
#include "measurement.hpp"

namespace footprint_collision_predictor::bench {
namespace {

using Lists = std::vector<std::vector<Obstacle>>;

/// As many lists of `size` as make up all inputs, so that short lists differ from call to call too.
Lists listsOf(const Scene& scene, std::size_t size) {
  Lists lists;
  auto from = scene.obstacles.begin();
  for (std::size_t i = 0; i < std::max<std::size_t>(1, kInputs / size); ++i) {
    const auto to = from + static_cast<std::ptrdiff_t>(size);
    lists.emplace_back(from, to);
    from = to;
  }
  return lists;
}

/// Each segment's earliest contact with any obstacle of its list.
Score judgeSegments(const Scene& scene, const Lists& lists) {
  const std::size_t segments = scene.footprint.size();
  const std::size_t size = lists.front().size();
  std::vector<Question> questions;
  std::vector<double> truths;
  for (std::size_t j = 0; j < lists.size(); ++j)
    for (std::size_t i = 0; i < segments; ++i) {
      questions.push_back({&scene, {i, i + 1}, {j * size, (j + 1) * size}});
      truths.push_back(truth(questions.back()));
    }
  core::Prediction prediction;  // the list's, for all of its segments
  return judge(questions, truths, kGuarantee, [&](std::size_t question) {
    const std::size_t segment = question % segments;
    if (segment == 0)
      prediction =
          core::predict(scene.footprint, scene.twist, lists[question / segments], kHorizon);
    const auto& contact = prediction.segments[segment];
    return contact ? contact->contact.time : kNever;
  });
}

void add(const SharedScene& scene, std::size_t size) {
  const auto lists = std::make_shared<const Lists>(listsOf(*scene, size));
  addMeasurement(pathOf("many", *scene) + "/ours_" + std::to_string(size), lists->size(), size,
                 judgeSegments(*scene, *lists), kGuarantee, [scene, lists](std::size_t i) {
                   return core::predict(scene->footprint, scene->twist, (*lists)[i], kHorizon);
                 });
}

}  // namespace

void addManyBenchmarks(MotionKind kind, std::size_t most) {
  const auto scene = std::make_shared<const Scene>(convexScene(8, kind, std::max(kInputs, most)));
  for (std::size_t size = 10; size <= most; size *= 10) add(scene, size);
}

}  // namespace footprint_collision_predictor::bench
