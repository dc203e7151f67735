// Methods that answer the same questions: each is put to the oracle once, then measured.
#pragma once

#include <string>
#include <vector>

#include "measurement.hpp"
#include "score.hpp"

namespace footprint_collision_predictor::bench {

/// The questions of one scene with their true answers; needed only while methods are added.
class Group {
 public:
  Group(std::string name, std::vector<Question> questions, std::vector<Truth> truths);

  /// \param answer double(std::size_t): first contact of question i, or kNever
  template <typename Answer>
  void add(const std::string& method, const Tolerance& tolerance, const Answer& answer) const {
    const Score score = judge(questions_, truths_, tolerance, answer);
    addMeasurement(name_ + "/" + method, questions_.size(), 1, score, tolerance, answer);
  }

 private:
  std::string name_;
  std::vector<Question> questions_;
  std::vector<Truth> truths_;
};

/// The whole footprint against one obstacle at a time.
Group footprintGroup(const Scene& scene, const SceneTruths& truths);
/// One segment against one obstacle: the segments take turns.
Group segmentGroup(const Scene& scene, const SceneTruths& truths);

}  // namespace footprint_collision_predictor::bench
