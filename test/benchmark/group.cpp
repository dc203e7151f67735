#include "group.hpp"

#include <utility>

namespace footprint_collision_predictor::bench {

Group::Group(std::string name, std::vector<Question> questions, std::vector<Truth> truths)
    : name_(std::move(name)), questions_(std::move(questions)), truths_(std::move(truths)) {}

Group footprintGroup(const Scene& scene, const SceneTruths& truths) {
  std::vector<Question> questions;
  std::vector<Truth> answers;
  for (std::size_t i = 0; i < kInputs; ++i) {
    questions.push_back({&scene, {0, scene.footprint.size()}, {i, i + 1}});
    answers.push_back(truths.ofFootprint({i, i + 1}));
  }
  return {"footprint/" + scene.name(), std::move(questions), std::move(answers)};
}

Group segmentGroup(const Scene& scene, const SceneTruths& truths) {
  std::vector<Question> questions;
  std::vector<Truth> answers;
  for (std::size_t i = 0; i < kInputs; ++i) {
    const std::size_t segment = i % scene.footprint.size();
    questions.push_back({&scene, {segment, segment + 1}, {i, i + 1}});
    answers.push_back(truths.ofSegments({i, i + 1})[segment]);
  }
  return {"segment/" + scene.name(), std::move(questions), std::move(answers)};
}

}  // namespace footprint_collision_predictor::bench
