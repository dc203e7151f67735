#include "score.hpp"

#include <algorithm>
#include <cmath>

#include "oracle.hpp"

namespace footprint_collision_predictor::bench {
namespace {

/// Whether the circle's path up to that time is too far from the segment for any contact.
/// Generously, in double: it only spares the oracle work.
bool isFarAway(const Segment& segment, const Motion& circle, double radius, double time) {
  const Vec2 end = circle.positionAt(time);
  const double reach =
      0.5 * (end - circle.position).norm() + 0.125 * time * time * circle.acceleration.norm();
  return core::distance(segment, 0.5 * (circle.position + end)) > radius + reach + 1e-3;
}

void count(const Question& question, double true_time, double time, const Tolerance& tolerance,
           Score* score) {
  if (std::abs(time - true_time) <= tolerance.time) return;  // not NaN, which ends below
  // Contact of the smaller circle is the latest excusable moment, of the larger one the earliest.
  if (time > true_time) {
    const double latest = tolerance.depth == 0 ? true_time : truth(question, -tolerance.depth);
    if (time == kNever && latest != kNever) ++score->misses;
    if (time != kNever && time > latest + tolerance.time) ++score->late;
  } else if (!(time >= truth(question, tolerance.clearance) - tolerance.time)) {
    ++score->inventions;
  }
}

}  // namespace

double truth(const Question& question, double growth) {
  double first = kNever;
  for (std::size_t j = question.obstacles.begin; j < question.obstacles.end; ++j) {
    const Motion circle = question.scene->relative(j);
    const double radius = std::max(0.0, question.scene->obstacles[j].radius() + growth);
    for (std::size_t i = question.segments.begin; i < question.segments.end; ++i) {
      const Segment segment = question.scene->footprint.segment(i);
      const double until = std::min(first, kHorizon);
      if (isFarAway(segment, circle, radius, until)) continue;
      const auto time = test::trueContact({segment, circle, radius, until});
      if (time) first = static_cast<double>(*time);
    }
  }
  return first;
}

Score judge(const std::vector<Question>& questions, const std::vector<double>& truths,
            const Tolerance& tolerance, const std::function<double(std::size_t)>& answer) {
  Score score;
  score.questions = questions.size();
  for (std::size_t i = 0; i < questions.size(); ++i) {
    const double time = answer(i);
    if (truths[i] != kNever) ++score.hits;
    if (time == truths[i]) continue;  // also where both say never
    count(questions[i], truths[i], time, tolerance, &score);
    if (time != kNever && truths[i] != kNever)
      score.worst_time_error = std::max(score.worst_time_error, std::abs(time - truths[i]));
  }
  return score;
}

}  // namespace footprint_collision_predictor::bench
