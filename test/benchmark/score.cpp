#include "score.hpp"

#include <algorithm>
#include <cmath>

#include "oracle.hpp"

namespace footprint_collision_predictor::bench {
namespace {

/// Whether the circle's path is too far from the segment for any contact. Generously, in double:
/// it only spares the oracle work.
bool isFarAway(const Segment& segment, const Motion& circle, double radius) {
  const double reach = 0.5 * (circle.positionAt(kHorizon) - circle.position).norm() +
                       0.125 * kHorizon * kHorizon * circle.acceleration.norm();
  const Vec2 middle = 0.5 * (circle.position + circle.positionAt(kHorizon));
  return core::distance(segment, middle) > radius + reach + 1e-3;
}

void count(const Question& question, double true_time, double time, const Tolerance& tolerance,
           Score* score) {
  if (std::abs(time - true_time) <= tolerance.time) return;
  // Contact of the smaller circle is the latest excusable moment, of the larger one the earliest.
  if (time > true_time) {
    const double latest = tolerance.depth == 0 ? true_time : truth(question, -tolerance.depth);
    if (time == kNever && latest != kNever) ++score->misses;
    if (time != kNever && time > latest + tolerance.time) ++score->late;
  } else if (time < truth(question, tolerance.clearance) - tolerance.time) {
    ++score->inventions;
  }
}

}  // namespace

double truth(const Question& question, double growth) {
  const double radius = std::max(0.0, question.radius + growth);
  double first = kNever;
  for (const Segment& segment : question.segments) {
    if (isFarAway(segment, question.circle, radius)) continue;
    const auto time =
        test::trueContact({segment, question.circle, radius, std::min(first, kHorizon)});
    if (time) first = static_cast<double>(*time);
  }
  return first;
}

Score judge(const std::vector<Question>& questions, const std::vector<double>& truths,
            const Tolerance& tolerance, const std::function<double(std::size_t)>& answer) {
  Score score;
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
