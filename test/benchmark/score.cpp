#include "score.hpp"

#include <algorithm>
#include <cmath>

namespace footprint_collision_predictor::bench {
namespace {

void count(const Question& question, const Truth& true_time, double time,
           const Tolerance& tolerance, Score* score) {
  const double latest_free = true_time.free_until - tolerance.time;
  const double latest = true_time.contact_at + tolerance.time;
  if (time >= latest_free && time <= latest) return;  // not NaN, which ends below
  // Contact of the smaller obstacle is the latest excusable moment, of the larger one the earliest.
  if (time > latest) {
    const double excusable =
        tolerance.depth == 0 ? true_time.contact_at : truth(question, -tolerance.depth).contact_at;
    if (time == kNever && excusable != kNever) ++score->misses;
    if (time != kNever && time > excusable + tolerance.time) ++score->late;
  } else if (!(time >= truth(question, tolerance.clearance).free_until - tolerance.time)) {
    ++score->inventions;
  }
}

}  // namespace

Score judge(const std::vector<Question>& questions, const std::vector<Truth>& truths,
            const Tolerance& tolerance, const std::function<double(std::size_t)>& answer) {
  Score score;
  score.questions = questions.size();
  for (std::size_t i = 0; i < questions.size(); ++i) {
    const double time = answer(i);
    const Truth& t = truths[i];
    if (t.contact_at != kNever) ++score.hits;
    count(questions[i], t, time, tolerance, &score);
    if (time != kNever && t.contact_at != kNever)
      score.worst_time_error =
          std::max({score.worst_time_error, time - t.contact_at, t.free_until - time});
  }
  return score;
}

}  // namespace footprint_collision_predictor::bench
