#include "broad_phase.hpp"

#include <algorithm>
#include <cmath>

#include "path.hpp"
#include "rounding.hpp"

namespace footprint_collision_predictor::core {
namespace {

/// An obstacle about the footprint's circle within a window: a point that moves straight, and how
/// near [m] to the origin it touches. Plain numbers, several of which share a register.
struct Chord {
  double px, py, vx, vy, reach;
};

/// Square of a reach, for comparisons: nothing is within a negative one, which is that of a gap
/// that only overlaps can have.
[[gnu::always_inline]] inline double squared(double reach) { return reach * std::abs(reach); }

/// By where the point is nearest.
[[gnu::always_inline]] inline bool mayTouch(const Chord& c, double duration) {
  const double nearest = -(c.px * c.vx + c.py * c.vy) / (c.vx * c.vx + c.vy * c.vy);
  const double from_now = nearest > 0 ? nearest : 0;  // also for NaN: it stands still
  const double t = from_now < duration ? from_now : duration;
  const double x = c.px + t * c.vx, y = c.py + t * c.vy;
  return x * x + y * y <= squared(c.reach);
}

/// By the ends of the way and, where it passes between them, how far away its line does: without a
/// division, which is quicker for a single one. With an allowance for rounding.
[[gnu::always_inline]] inline bool mayTouchWithoutDivision(const Chord& c, double duration) {
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
[[gnu::always_inline]] inline bool mayTouchGrowing(const Chord& c, double rate, double duration) {
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
[[gnu::always_inline]] inline bool mayTouch(const Chord& c, double rate, double duration) {
  return rate == 0 ? mayTouchWithoutDivision(c, duration) : mayTouchGrowing(c, rate, duration);
}

struct Arrays {
  const double *x, *y, *vx, *vy, *ax, *ay, *radius, *radius_rate;
};

/// What all obstacles are asked.
struct Question {
  Vec2 origin;  ///< [m] of the window's circle
  SweptFootprint::Window window;
  double reach;  ///< [m] beside an obstacle's own radius
};

/// What is true of all obstacles and the footprint, so that less has to be computed.
enum class Simple {
  kNow,       ///< no time passes
  kStraight,  ///< nothing accelerates, turns or grows
  kSteady,    ///< nothing grows
  kNothing,
};

[[gnu::always_inline]] inline Chord chordOf(const Arrays& a, std::size_t i, const Question& q) {
  const double t = q.window.start, duration = q.window.duration, middle = t + 0.5 * duration;
  const double bulge = 0.125 * duration * duration * (std::abs(a.ax[i]) + std::abs(a.ay[i]));
  return {a.x[i] - q.origin.x() + t * (a.vx[i] + 0.5 * t * a.ax[i]),
          a.y[i] - q.origin.y() + t * (a.vy[i] + 0.5 * t * a.ay[i]),
          a.vx[i] + middle * a.ax[i] - q.window.velocity.x(),
          a.vy[i] + middle * a.ay[i] - q.window.velocity.y(),
          a.radius[i] + q.reach + a.radius_rate[i] * t + bulge};
}

template <Simple kSimple>
[[gnu::always_inline]] inline bool mayTouch(const Arrays& a, std::size_t i, const Question& q) {
  const double duration = q.window.duration;
  if constexpr (kSimple == Simple::kNow || kSimple == Simple::kStraight) {
    const double x = a.x[i] - q.origin.x(), y = a.y[i] - q.origin.y();
    const double reach = a.radius[i] + q.reach;
    if constexpr (kSimple == Simple::kNow) return x * x + y * y <= squared(reach);
    const Vec2& own = q.window.velocity;
    return mayTouch({x, y, a.vx[i] - own.x(), a.vy[i] - own.y(), reach}, duration);
  }
  const Chord c = chordOf(a, i, q);
  if constexpr (kSimple == Simple::kSteady) return mayTouch(c, duration);
  return mayTouchGrowing(c, a.radius_rate[i], duration);
}

/// The marks are numbers like all others, so that a register holds as many of them.
template <Simple kSimple>
[[gnu::always_inline]] inline void mark(const Arrays& a, std::size_t count, const Question& q,
                                        double* marks) {
  for (std::size_t i = 0; i < count; ++i) marks[i] += mayTouch<kSimple>(a, i, q) ? 1.0 : 0.0;
}

template <Simple kSimple>
void markBaseline(const Arrays& a, std::size_t count, const Question& q, double* marks) {
  mark<kSimple>(a, count, q, marks);
}

#ifdef __x86_64__
template <Simple kSimple>
[[gnu::target("avx2")]] void markAvx2(const Arrays& a, std::size_t count, const Question& q,
                                      double* marks) {
  mark<kSimple>(a, count, q, marks);
}

template <Simple kSimple>
[[gnu::target("avx512f,avx512vl,avx512dq")]] void markAvx512(const Arrays& a, std::size_t count,
                                                             const Question& q, double* marks) {
  mark<kSimple>(a, count, q, marks);
}
#endif

using Mark = void (*)(const Arrays&, std::size_t, const Question&, double*);

template <Simple kSimple>
Mark markWith(InstructionSet set) {
#ifdef __x86_64__
  if (set == InstructionSet::kAvx512) return markAvx512<kSimple>;
  if (set == InstructionSet::kAvx2) return markAvx2<kSimple>;
#endif
  (void)set;
  return markBaseline<kSimple>;
}

Mark markWith(InstructionSet set, const ObstacleBatch& obstacles, const SweptFootprint& footprint) {
  if (footprint.horizon() == 0) return markWith<Simple::kNow>(set);
  if (obstacles.grows()) return markWith<Simple::kNothing>(set);
  if (footprint.turns() || obstacles.largestAcceleration() > 0)
    return markWith<Simple::kSteady>(set);
  return markWith<Simple::kStraight>(set);
}

/// \param farthest [m] that anything gets from the frame's origin, for rounding
Question questionOf(const SweptFootprint& footprint, const SweptFootprint::Window& window,
                    double gap, double farthest) {
  const double rounding = kGenerous * (farthest + footprint.centroid().lpNorm<1>());
  return {footprint.centroid() + window.centre, window, window.radius + gap + rounding};
}

}  // namespace

bool isSupported(InstructionSet set) {
  if (set == InstructionSet::kBaseline) return true;
#ifdef __x86_64__
  if (set == InstructionSet::kAvx2) return __builtin_cpu_supports("avx2");
  return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
         __builtin_cpu_supports("avx512dq");
#else
  return false;
#endif
}

InstructionSet widestInstructionSet() {
  static const InstructionSet widest =
      isSupported(InstructionSet::kAvx512) ? InstructionSet::kAvx512
      : isSupported(InstructionSet::kAvx2) ? InstructionSet::kAvx2
                                           : InstructionSet::kBaseline;
  return widest;
}

namespace {

/// The indices of those that are marked. Most are not, so whole groups are passed over.
std::size_t collect(const std::array<double, kBlock>& marks, std::size_t begin, std::size_t count,
                    std::array<std::size_t, kBlock>* candidates) {
  constexpr std::size_t kGroup = 8;
  std::size_t found = 0;
  for (std::size_t group = 0; group < count; group += kGroup) {
    double any = 0;
    for (std::size_t i = group; i < group + kGroup; ++i) any += marks[i];
    if (any == 0) continue;
    for (std::size_t i = group; i < group + kGroup; ++i) {
      (*candidates)[found] = begin + i;
      found += static_cast<std::size_t>(marks[i] > 0);
    }
  }
  return found;
}

}  // namespace

std::size_t findCandidates(const ObstacleBatch& obstacles, std::size_t begin, std::size_t end,
                           const SweptFootprint& footprint, double gap, InstructionSet set,
                           std::array<std::size_t, kBlock>* candidates) {
  std::array<double, kBlock> marks;
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
  const Mark mark_window = markWith(set, obstacles, footprint);
  const double farthest = obstacles.farthest(footprint.horizon());
  for (const auto& window : footprint)
    mark_window(arrays, count, questionOf(footprint, window, gap, farthest), marks.data());
  return collect(marks, begin, count, candidates);
}

bool mayComeWithin(double gap, const SweptFootprint& footprint, const Disc& disc,
                   double bounding_radius) {
  const Motion& m = disc.motion;
  const Arrays one{&m.position.x(),     &m.position.y(),     &m.velocity.x(),  &m.velocity.y(),
                   &m.acceleration.x(), &m.acceleration.y(), &bounding_radius, &disc.radius_rate};
  const double t = footprint.horizon();
  const double farthest =
      m.position.lpNorm<1>() + t * (m.velocity.lpNorm<1>() + 0.5 * t * m.acceleration.lpNorm<1>());
  const auto may_touch = [&](const SweptFootprint::Window& window) {
    const Question question = questionOf(footprint, window, gap, farthest);
    const Chord chord = chordOf(one, 0, question);
    return mayTouch(chord, disc.radius_rate, window.duration);
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
  const Chord chord{p.x(), p.y(), v.x(), v.y(), reach};
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
