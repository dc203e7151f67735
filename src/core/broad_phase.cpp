#include "broad_phase.hpp"

#include <algorithm>
#include <cmath>

#include "path.hpp"
#include "rounding.hpp"

namespace footprint_collision_predictor::core {
namespace {

/// An obstacle about the footprint's circle within a window: a point that moves straight, and how
/// near [m] to the origin it touches. Plain numbers, several of which share a register.
template <typename Real>
struct Chord {
  Real px, py, vx, vy, reach;
};

/// Square of a reach, for comparisons: nothing is within a negative one, which is that of a gap
/// that only overlaps can have.
template <typename Real>
[[gnu::always_inline]] inline Real squared(Real reach) {
  return reach * std::abs(reach);
}

/// By where the point is nearest.
[[gnu::always_inline]] inline bool mayTouch(const Chord<float>& c, float duration) {
  const float nearest = -(c.px * c.vx + c.py * c.vy) / (c.vx * c.vx + c.vy * c.vy);
  const float from_now = nearest > 0 ? nearest : 0;  // also for NaN: it stands still
  const float t = from_now < duration ? from_now : duration;
  const float x = c.px + t * c.vx, y = c.py + t * c.vy;
  return x * x + y * y <= squared(c.reach);
}

/// By the ends of the way and, where it passes between them, how far away its line does: without a
/// division, which is quicker for a single one. With an allowance for rounding.
[[gnu::always_inline]] inline bool mayTouchWithoutDivision(const Chord<double>& c,
                                                           double duration) {
  const double ex = c.px + duration * c.vx, ey = c.py + duration * c.vy;
  const double p2 = c.px * c.px + c.py * c.py, e2 = ex * ex + ey * ey;
  const double reach2 = squared(c.reach) + kGenerous * (p2 + e2);
  const double cross = c.px * c.vy - c.py * c.vx;
  const bool at_the_ends = (p2 <= reach2) | (e2 <= reach2);
  const bool between = (c.px * c.vx + c.py * c.vy <= 0) & (ex * c.vx + ey * c.vy >= 0) &
                       (cross * cross <= reach2 * (c.vx * c.vx + c.vy * c.vy));
  return at_the_ends | between;
}

/// By the sign of a quadratic. The reach grows at a rate [m/s].
[[gnu::always_inline]] inline bool mayTouchGrowing(const Chord<double>& c, double rate,
                                                   double duration) {
  // |p + v t|^2 - (reach + rate t)^2 = f + 2 h t + m t^2, and its discriminant as a sum of squares
  // of cross products, which does not cancel far away.
  const double p2 = c.px * c.px + c.py * c.py;
  const double reach2 = c.reach * c.reach;
  const double f = p2 - reach2;
  const double h = c.px * c.vx + c.py * c.vy - c.reach * rate;
  const double m = c.vx * c.vx + c.vy * c.vy - rate * rate;
  const double speeds = c.vx * c.vx + c.vy * c.vy + rate * rate;
  const double cross = c.px * c.vy - c.py * c.vx;
  const double x = c.reach * c.vx - rate * c.px, y = c.reach * c.vy - rate * c.py;
  const double discriminant = x * x + y * y - cross * cross;
  const double at_end = f + duration * (2 * h + duration * m);
  const double size = kGenerous * (p2 + reach2);
  const double rounding = size + kGenerous * duration * duration * speeds;
  const bool at_the_ends = (f <= rounding) | (at_end <= rounding);
  const bool between = (h <= 0) & (h + m * duration >= 0) & (discriminant >= -size * speeds);
  return (at_the_ends | between) & (c.reach >= 0);
}

/// For a single one.
[[gnu::always_inline]] inline bool mayTouch(const Chord<double>& c, double rate, double duration) {
  return rate == 0 ? mayTouchWithoutDivision(c, duration) : mayTouchGrowing(c, rate, duration);
}

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
    return mayTouch({x, y, a.vx[i] - q.vx, a.vy[i] - q.vy, reach}, q.duration);
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

namespace {

/// By a single window.
[[gnu::noinline]] bool mayTouchBent(const Polygon& footprint, const Twist& twist, const Disc& disc,
                                    double bounding_radius, double horizon) {
  const Motion& m = disc.motion;
  const Vec2 p = m.position - footprint.centroid();
  Vec2 own = twist.linear;
  double acceleration = m.acceleration.lpNorm<1>();
  double rounding = kGenerous * footprint.boundingRadius();
  if (twist.angular != 0) {
    own = atPoint(footprint.centroid(), twist).linear;
    acceleration += std::abs(twist.angular) * own.norm();
    own = Turn(twist.angular * horizon).displacement(own);
    rounding += kGenerous * std::abs(twist.angular) * horizon * footprint.centroid().lpNorm<1>() +
                kGenerous * horizon * own.norm() + kTurningTolerance;
  }
  const Vec2 v = m.velocity - own + 0.5 * horizon * m.acceleration;
  const double bulge = 0.125 * horizon * horizon * acceleration;
  const double reach = bounding_radius + footprint.boundingRadius() + bulge + rounding;
  const Chord<double> chord{p.x(), p.y(), v.x(), v.y(), reach};
  return mayTouch(chord, disc.radius_rate, horizon);
}

}  // namespace

bool mayTouch(const Polygon& footprint, const Twist& twist, const Disc& disc,
              double bounding_radius, double horizon) {
  const Motion& m = disc.motion;
  if (twist.angular != 0 || m.acceleration.x() != 0 || m.acceleration.y() != 0)
    return mayTouchBent(footprint, twist, disc, bounding_radius, horizon);
  const Vec2 p = m.position - footprint.centroid();
  const Vec2 v = m.velocity - twist.linear;
  const double reach = bounding_radius + footprint.boundingRadius();
  return mayTouch({p.x(), p.y(), v.x(), v.y(), reach}, disc.radius_rate, horizon);
}

bool mayComeWithin(double gap, const Polygon& footprint, const Disc& disc, double bounding_radius) {
  const double reach = bounding_radius + footprint.boundingRadius() + gap;
  const double p2 = (disc.motion.position - footprint.centroid()).squaredNorm();
  return reach >= 0 && p2 * (1 - kGenerous) <= reach * reach;
}

}  // namespace footprint_collision_predictor::core
