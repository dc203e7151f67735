#include "group.hpp"

namespace footprint_collision_predictor::bench {
Group::Group(std::string name, std::vector<Question> questions)
    : name_(std::move(name)), questions_(std::move(questions)) {
  truths_.reserve(questions_.size());
  for (const Question& question : questions_) truths_.push_back(truth(question));
}

Group footprintGroup(const Scene& scene) {
  std::vector<Question> questions;
  for (std::size_t i = 0; i < scene.obstacles.size(); ++i)
    questions.push_back({&scene, {0, scene.footprint.size()}, {i, i + 1}});
  return {pathOf("footprint", scene), std::move(questions)};
}

Group segmentGroup(const Scene& scene) {
  std::vector<Question> questions;
  for (std::size_t i = 0; i < scene.obstacles.size(); ++i) {
    const std::size_t segment = i % scene.footprint.size();
    questions.push_back({&scene, {segment, segment + 1}, {i, i + 1}});
  }
  return {pathOf("segment", scene), std::move(questions)};
}

}  // namespace footprint_collision_predictor::bench
