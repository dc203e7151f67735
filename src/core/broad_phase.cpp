#include "broad_phase.hpp"

#include <algorithm>
#include <cmath>

#include "chord.hpp"
#include "rounding.hpp"

namespace footprint_collision_predictor::core {
namespace {

struct Arrays {
  const float *x, *y, *vx, *vy, *ax, *ay, *radius, *radius_rate;
};

/// A single one of many.
template <typename Real>
struct Moving {
  Real x, y, vx, vy, ax, ay, radius, radius_rate;
};

/// What all obstacles are asked: a window, and how near to come in it.
template <typename Real>
struct Question {
  Real start, duration;
  Real x, y;    ///< [m] of the window's circle
  Real vx, vy;  ///< [m/s]
  Real reach;   ///< [m] beside an obstacle's own radius
};

/// What is true of all obstacles and the footprint, so that less has to be computed.
enum class Simple {
  kNow,       ///< no time passes
  kStraight,  ///< nothing accelerates, turns or grows
  kSteady,    ///< nothing grows
  kNothing,
};

template <typename Real>
[[gnu::always_inline]] inline Chord<Real> chordOf(const Moving<Real>& o, const Question<Real>& q) {
  const Real half_start = q.start / 2, middle = q.start + q.duration / 2;
  const Real bulge = q.duration * q.duration / 8 * (std::abs(o.ax) + std::abs(o.ay));
  return {o.x - q.x + q.start * (o.vx + half_start * o.ax),
          o.y - q.y + q.start * (o.vy + half_start * o.ay), o.vx + middle * o.ax - q.vx,
          o.vy + middle * o.ay - q.vy, o.radius + q.reach + o.radius_rate * q.start + bulge};
}

template <Simple kSimple>
[[gnu::always_inline]] inline bool mayTouch(const Arrays& a, std::size_t i,
                                            const Question<float>& q) {
  if constexpr (kSimple == Simple::kNow || kSimple == Simple::kStraight) {
    const float x = a.x[i] - q.x, y = a.y[i] - q.y;
    const float reach = a.radius[i] + q.reach;
    if constexpr (kSimple == Simple::kNow) return x * x + y * y <= squared(reach);
    return mayTouch(Chord<float>{x, y, a.vx[i] - q.vx, a.vy[i] - q.vy, reach}, q.duration);
  }
  const Moving<float> o{a.x[i],  a.y[i],  a.vx[i],     a.vy[i],
                        a.ax[i], a.ay[i], a.radius[i], a.radius_rate[i]};
  if constexpr (kSimple == Simple::kSteady) return mayTouch(chordOf(o, q), q.duration);
  // Of these the squares of squares are taken, too large for single precision.
  const Chord<float> c = chordOf(o, q);
  return mayTouchGrowing({c.px, c.py, c.vx, c.vy, c.reach}, o.radius_rate, q.duration);
}

/// The marks are as wide as all other numbers, so that a register holds as many of them.
template <Simple kSimple>
[[gnu::always_inline]] inline void mark(const Arrays& a, std::size_t count,
                                        const Question<float>& q, std::uint32_t* marks) {
  for (std::size_t i = 0; i < count; ++i) marks[i] |= mayTouch<kSimple>(a, i, q) ? 1U : 0U;
}

template <Simple kSimple>
void markBaseline(const Arrays& a, std::size_t count, const Question<float>& q,
                  std::uint32_t* marks) {
  mark<kSimple>(a, count, q, marks);
}

#ifdef __x86_64__
template <Simple kSimple>
[[gnu::target("avx2")]] void markAvx2(const Arrays& a, std::size_t count, const Question<float>& q,
                                      std::uint32_t* marks) {
  mark<kSimple>(a, count, q, marks);
}

template <Simple kSimple>
[[gnu::target("avx512f,avx512vl,avx512dq")]] void markAvx512(const Arrays& a, std::size_t count,
                                                             const Question<float>& q,
                                                             std::uint32_t* marks) {
  mark<kSimple>(a, count, q, marks);
}
#endif

using MarkAll = void (*)(const Arrays&, std::size_t, const Question<float>&, std::uint32_t*);

template <Simple kSimple>
MarkAll markWith(InstructionSet set) {
#ifdef __x86_64__
  if (set == InstructionSet::kAvx512) return markAvx512<kSimple>;
  if (set == InstructionSet::kAvx2) return markAvx2<kSimple>;
#endif
  (void)set;
  return markBaseline<kSimple>;
}

MarkAll markWith(InstructionSet set, const ObstacleBatch& obstacles,
                 const SweptFootprint& footprint) {
  if (footprint.horizon() == 0) return markWith<Simple::kNow>(set);
  if (obstacles.grows()) return markWith<Simple::kNothing>(set);
  if (footprint.turns() || obstacles.largestAcceleration() > 0)
    return markWith<Simple::kSteady>(set);
  return markWith<Simple::kStraight>(set);
}

/// \param centre [m] of the window's circle at its start
template <typename Real>
Question<Real> questionOf(const SweptFootprint::Window& window, const Vec2& centre, double reach) {
  return {static_cast<Real>(window.start),
          static_cast<Real>(window.duration),
          static_cast<Real>(centre.x()),
          static_cast<Real>(centre.y()),
          static_cast<Real>(window.velocity.x()),
          static_cast<Real>(window.velocity.y()),
          static_cast<Real>(reach)};
}

/// The indices of those that are marked. Most are not, so whole groups are passed over.
std::size_t collect(const std::array<std::uint32_t, kBlock>& marks, std::size_t begin,
                    std::size_t count, std::array<std::size_t, kBlock>* candidates) {
  constexpr std::size_t kGroup = 8;
  std::size_t found = 0;
  for (std::size_t group = 0; group < count; group += kGroup) {
    std::uint32_t any = 0;
    for (std::size_t i = group; i < group + kGroup; ++i) any |= marks[i];
    if (any == 0) continue;
    for (std::size_t i = group; i < group + kGroup; ++i) {
      (*candidates)[found] = begin + i;
      found += marks[i];
    }
  }
  return found;
}

}  // namespace

std::size_t findCandidates(const ObstacleBatch& obstacles, std::size_t begin, std::size_t end,
                           const SweptFootprint& footprint, double gap, InstructionSet set,
                           std::array<std::size_t, kBlock>* candidates) {
  constexpr double kSmallest = 1e-18;  // [m] the square of less may be 0 in single precision
  std::array<std::uint32_t, kBlock> marks;
  const std::size_t count = end - begin;
  marks.fill(0);
  const ObstacleColumns& all = obstacles.columns();
  const Arrays arrays{&all.x[begin],
                      &all.y[begin],
                      &all.vx[begin],
                      &all.vy[begin],
                      &all.ax[begin],
                      &all.ay[begin],
                      &all.bounding_radius[begin],
                      &all.radius_rate[begin]};
  const MarkAll mark_window = markWith(set, obstacles, footprint);
  const double farthest = obstacles.farthest(footprint.horizon());
  for (const auto& window : footprint) {
    const Vec2 centre = (footprint.centroid() - obstacles.origin()) + window.centre;
    // Where the reach is decided within rounding it is about as large as the distance.
    const double size =
        farthest + centre.lpNorm<1>() + (1 + window.duration) * window.velocity.lpNorm<1>();
    const double rounding = kGenerousSingle * size + kSmallest * (1 + window.duration);
    mark_window(arrays, count, questionOf<float>(window, centre, window.radius + gap + rounding),
                marks.data());
  }
  return collect(marks, begin, count, candidates);
}

bool mayComeWithin(double gap, const SweptFootprint& footprint, const Disc& disc,
                   double bounding_radius) {
  const Motion& m = disc.motion;
  const Moving<double> obstacle{m.position.x(),  m.position.y(),     m.velocity.x(),
                                m.velocity.y(),  m.acceleration.x(), m.acceleration.y(),
                                bounding_radius, disc.radius_rate};
  const double t = footprint.horizon();
  const double farthest =
      m.position.lpNorm<1>() + t * (m.velocity.lpNorm<1>() + 0.5 * t * m.acceleration.lpNorm<1>());
  const double rounding = kGenerous * (farthest + footprint.centroid().lpNorm<1>());
  const auto may_touch = [&](const SweptFootprint::Window& window) {
    const auto question = questionOf<double>(window, footprint.centroid() + window.centre,
                                             window.radius + gap + rounding);
    return mayTouch(chordOf(obstacle, question), disc.radius_rate, window.duration);
  };
  return std::any_of(footprint.begin(), footprint.end(), may_touch);
}

bool mayComeWithin(double gap, const Polygon& footprint, const Disc& disc, double bounding_radius) {
  const double reach = bounding_radius + footprint.boundingRadius() + gap;
  const double p2 = (disc.motion.position - footprint.centroid()).squaredNorm();
  return reach >= 0 && p2 * (1 - kGenerous) <= reach * reach;
}

}  // namespace footprint_collision_predictor::core
