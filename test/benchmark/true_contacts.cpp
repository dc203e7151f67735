#include "true_contacts.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "footprint_oracle.hpp"
#include "oracle.hpp"

namespace footprint_collision_predictor::bench {
namespace {

double distance(const Segment& a, const Segment& b) {
  const auto side = [](const Segment& s, const Vec2& p) {
    return core::cross(s.end - s.start, p - s.start);
  };
  if (side(a, b.start) * side(a, b.end) < 0 && side(b, a.start) * side(b, a.end) < 0) return 0;
  return std::min({core::distance(a, b.start), core::distance(a, b.end), core::distance(b, a.start),
                   core::distance(b, a.end)});
}

/// One obstacle and the footprint until some time. In double and generously: it only spares the
/// oracles work.
class Neighbourhood {
 public:
  Neighbourhood(const Scene& scene, std::size_t obstacle, double growth, double until)
      : disc_(scene.obstacles[obstacle].disc()), twist_(scene.twist), until_(until) {
    const core::Motion& m = disc_.motion;
    double extent = 0;
    for (const Vec2& v : scene.obstacles[obstacle].outline()) extent = std::max(extent, v.norm());
    reach_ = disc_.radiusAt(until) + growth + extent + 1e-3;
    const double w = std::abs(twist_.angular), a = m.acceleration.norm();
    const double speed = m.velocity.norm() + a * until + twist_.linear.norm();
    const double pull = a + w * twist_.linear.norm();
    bend_ = pull + w * (2 * speed + w * (m.position.norm() + speed * until));
    if (w == 0) bend_ = a;
  }

  bool isOutOfReach(const Segment& segment, double more = 0) const {
    return isOutOfReach(segment, more, 1) || (bend_ > 0 && isOutOfReach(segment, more, 16));
  }
  bool isOutOfReach(const Polygon& footprint) const {
    const Vec2& centre = footprint.centroid();
    return isOutOfReach({centre, centre}, footprint.boundingRadius());
  }

 private:
  /// Whether the disc's path, cut into so many chords, is too far from the segment for any contact.
  bool isOutOfReach(const Segment& segment, double more, int chords) const {
    const double step = until_ / chords;
    const double reach = reach_ + more + bend_ * step * step / 8;
    Vec2 start = at(0);
    for (int i = 1; i <= chords; ++i) {
      const Vec2 end = at(i * step);
      if (distance(segment, Segment{start, end}) <= reach) return false;
      start = end;
    }
    return true;
  }

  Vec2 at(double t) const { return poseAt(twist_, t).toFrame(disc_.motion.positionAt(t)); }

  Disc disc_;
  Twist twist_;
  double until_;
  double reach_;  // [m]
  double bend_;   // [m/s^2] a bound on the acceleration in the footprint's frame
};

Truth byPolynomials(const Scene& scene, std::size_t segment, std::size_t obstacle, double growth,
                    double until) {
  const Disc disc = scene.seen(obstacle);
  const auto time =
      test::trueContact({scene.footprint.segment(segment), disc.motion,
                         std::max(0.0, disc.radius + growth), until, disc.radius_rate});
  if (!time) return {};
  return {static_cast<double>(*time), static_cast<double>(*time)};
}

Truth byCutting(const Scene& scene, std::size_t segment, std::size_t obstacle, double growth,
                double until) {
  Disc disc = scene.obstacles[obstacle].disc();
  disc.radius = std::max(0.0, disc.radius + growth);
  const test::FootprintOracle oracle(
      {scene.footprint.vertices(), scene.twist, disc, scene.obstacles[obstacle].outline(), until});
  const test::FirstTouch touch = oracle.firstTouchOfSegment(segment);
  const double free_until = static_cast<double>(touch.free_until);
  if (touch.contact_at) return {free_until, static_cast<double>(*touch.contact_at)};
  return {free_until >= until ? kNever : free_until, kNever};
}

/// Brings the truths of the segments up to date with one more obstacle.
void add(const Scene& scene, const Range& segments, std::size_t obstacle, double growth,
         std::vector<Truth>* truths) {
  const bool has_polynomials = scene.kind != Kind::kTurning && scene.kind != Kind::kWalls;
  double latest = 0;
  for (const Truth& t : *truths) latest = std::max(latest, std::min(kHorizon, t.contact_at));
  const Neighbourhood near(scene, obstacle, growth, latest);
  if (near.isOutOfReach(scene.footprint)) return;
  for (std::size_t i = segments.begin; i < segments.end; ++i) {
    if (near.isOutOfReach(scene.footprint.segment(i))) continue;
    Truth& known = (*truths)[i - segments.begin];
    const double until = std::min(kHorizon, known.contact_at);
    known = first(known,
                  (has_polynomials ? byPolynomials : byCutting)(scene, i, obstacle, growth, until));
  }
}

Truth firstOf(const std::vector<Truth>& truths) {
  return std::accumulate(truths.begin(), truths.end(), Truth{}, first);
}

}  // namespace

Truth first(const Truth& a, const Truth& b) {
  return {std::min(a.free_until, b.free_until), std::min(a.contact_at, b.contact_at)};
}

Truth truth(const Question& question, double growth) {
  std::vector<Truth> truths(question.segments.end - question.segments.begin);
  for (std::size_t j = question.obstacles.begin; j < question.obstacles.end; ++j)
    add(*question.scene, question.segments, j, growth, &truths);
  return firstOf(truths);
}

SceneTruths::SceneTruths(const Scene& scene) : scene_(scene) {
  const std::size_t count = std::min(kInputs, scene.obstacles.size());
  known_.reserve(count);
  for (std::size_t j = 0; j < count; ++j) {
    std::vector<Truth> truths = ofSegments({j, j + 1});
    if (firstOf(truths).free_until == kNever) truths.clear();
    known_.push_back(std::move(truths));
  }
}

std::vector<Truth> SceneTruths::ofSegments(const Range& obstacles) const {
  const std::size_t segments = scene_.footprint.size();
  std::vector<Truth> truths(segments);
  for (std::size_t j = obstacles.begin; j < obstacles.end; ++j) {
    if (j >= known_.size()) {
      add(scene_, {0, segments}, j, 0, &truths);
    } else if (!known_[j].empty()) {
      for (std::size_t i = 0; i < segments; ++i) truths[i] = first(truths[i], known_[j][i]);
    }
  }
  return truths;
}

Truth SceneTruths::ofFootprint(const Range& obstacles) const {
  return firstOf(ofSegments(obstacles));
}

}  // namespace footprint_collision_predictor::bench
