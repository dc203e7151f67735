#include "group.hpp"

namespace footprint_collision_predictor::bench {
namespace {

std::string pathOf(const std::string& what, const Scene& scene) {
  return what + "/" + nameOf(scene.kind) + "/" + scene.name;
}

}  // namespace

Group::Group(std::string name, std::vector<Question> questions)
    : name_(std::move(name)), questions_(std::move(questions)) {
  truths_.reserve(size());
  for (const Question& question : questions_) truths_.push_back(truth(question));
}

void Group::report(const Score& score, const Tolerance& tolerance, std::size_t inputs,
                   benchmark::State* state) {
  auto& counters = state->counters;
  counters["inputs"] = static_cast<double>(inputs);
  counters["hits"] = static_cast<double>(score.hits);
  counters["misses"] = static_cast<double>(score.misses);
  counters["late"] = static_cast<double>(score.late);
  counters["inventions"] = static_cast<double>(score.inventions);
  counters["worst_time_error"] = score.worst_time_error;
  counters["tolerance_m"] = tolerance.clearance;
  counters["tolerance_s"] = tolerance.time;
}

Group footprintGroup(const Scene& scene) {
  const std::vector<Segment> segments = segmentsOf(scene.footprint);
  std::vector<Question> questions;
  for (std::size_t i = 0; i < scene.obstacles.size(); ++i)
    questions.push_back({segments, scene.relative(i), scene.obstacles[i].radius()});
  return {pathOf("footprint", scene), std::move(questions)};
}

Group segmentGroup(const Scene& scene) {
  std::vector<Question> questions;
  for (std::size_t i = 0; i < scene.obstacles.size(); ++i)
    questions.push_back({{scene.footprint.segment(i % scene.footprint.size())},
                         scene.relative(i),
                         scene.obstacles[i].radius()});
  return {pathOf("segment", scene), std::move(questions)};
}

}  // namespace footprint_collision_predictor::bench
