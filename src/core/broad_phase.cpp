#include "broad_phase.hpp"

#include <algorithm>
#include <cmath>

#include "path.hpp"
#include "rounding.hpp"

namespace footprint_collision_predictor::core {
namespace {

/// A point and a circle of this size about the origin, at the start of a window: whether they may
/// touch within its duration.
/// \param rate at which the circle grows
template <bool kGrows>
[[gnu::always_inline]] inline bool mayTouch(double px, double py, double vx, double vy,
                                            double reach, double rate, double duration) {
  // |p + v t|^2 - (reach + rate t)^2 = f + 2 h t + m t^2, and its discriminant as a sum of squares
  // of cross products, which does not cancel far away.
  const double p2 = px * px + py * py, v2 = vx * vx + vy * vy;
  const double reach2 = reach * reach;
  const double cross = px * vy - py * vx;
  const double f = p2 - reach2;
  double h = px * vx + py * vy;
  double m = v2, speeds = v2;
  double discriminant = reach2 * v2 - cross * cross;
  if constexpr (kGrows) {
    h -= reach * rate;
    m -= rate * rate;
    speeds += rate * rate;
    const double x = reach * vx - rate * px, y = reach * vy - rate * py;
    discriminant = x * x + y * y - cross * cross;
  }
  const double at_end = f + duration * (2 * h + duration * m);
  const double size = kGenerous * (p2 + reach2);
  const double rounding = size + kGenerous * duration * duration * speeds;
  const bool at_the_ends = (f <= rounding) | (at_end <= rounding);
  const bool between = (h <= 0) & (h + m * duration >= 0) & (discriminant >= -size * speeds);
  // A negative reach is that of a gap which only overlaps can have.
  return (at_the_ends | between) & (reach >= 0);
}

struct Arrays {
  const double *x, *y, *vx, *vy, *ax, *ay, *radius, *radius_rate;
};

/// What all obstacles are asked.
struct Question {
  Vec2 origin;
  SweptFootprint::Window window;
  double gap;
};

/// Any obstacle i.
[[gnu::always_inline]] inline bool mayTouch(const Arrays& a, std::size_t i, const Question& q) {
  const double t = q.window.start, duration = q.window.duration;
  const double middle = t + 0.5 * duration;
  const double x = a.x[i] - q.origin.x(), y = a.y[i] - q.origin.y();
  const double bulge = 0.125 * duration * duration * (std::abs(a.ax[i]) + std::abs(a.ay[i]));
  const double rate = a.radius_rate[i];
  return mayTouch<true>(x + t * (a.vx[i] + 0.5 * t * a.ax[i]) - q.window.centre.x(),
                        y + t * (a.vy[i] + 0.5 * t * a.ay[i]) - q.window.centre.y(),
                        a.vx[i] + middle * a.ax[i] - q.window.velocity.x(),
                        a.vy[i] + middle * a.ay[i] - q.window.velocity.y(),
                        a.radius[i] + rate * t + (q.window.radius + q.gap) + bulge, rate, duration);
}

/// One that neither accelerates nor grows, in the only window of a footprint that does not turn.
[[gnu::always_inline]] inline bool mayTouchStraight(const Arrays& a, std::size_t i,
                                                    const Question& q) {
  return mayTouch<false>(a.x[i] - q.origin.x(), a.y[i] - q.origin.y(),
                         a.vx[i] - q.window.velocity.x(), a.vy[i] - q.window.velocity.y(),
                         a.radius[i] + (q.window.radius + q.gap), 0, q.window.duration);
}

template <bool kStraight>
[[gnu::always_inline]] inline void mark(const Arrays& a, std::size_t count, const Question& q,
                                        std::int64_t* marks) {
  for (std::size_t i = 0; i < count; ++i) {
    const bool may_touch = kStraight ? mayTouchStraight(a, i, q) : mayTouch(a, i, q);
    marks[i] |= may_touch ? 1 : 0;
  }
}

template <bool kStraight>
void markBaseline(const Arrays& a, std::size_t count, const Question& q, std::int64_t* marks) {
  mark<kStraight>(a, count, q, marks);
}

#ifdef __x86_64__
template <bool kStraight>
[[gnu::target("avx2")]] void markAvx2(const Arrays& a, std::size_t count, const Question& q,
                                      std::int64_t* marks) {
  mark<kStraight>(a, count, q, marks);
}

template <bool kStraight>
[[gnu::target("avx512f,avx512vl,avx512dq")]] void markAvx512(const Arrays& a, std::size_t count,
                                                             const Question& q,
                                                             std::int64_t* marks) {
  mark<kStraight>(a, count, q, marks);
}
#endif

using Mark = void (*)(const Arrays&, std::size_t, const Question&, std::int64_t*);

template <bool kStraight>
Mark markWith(InstructionSet set) {
#ifdef __x86_64__
  if (set == InstructionSet::kAvx512) return markAvx512<kStraight>;
  if (set == InstructionSet::kAvx2) return markAvx2<kStraight>;
#endif
  (void)set;
  return markBaseline<kStraight>;
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

SweptFootprint::SweptFootprint(const Polygon& footprint, const Twist& twist, double horizon,
                               double obstacle_acceleration)
    : centroid_(footprint.centroid()), count_(1), turns_(twist.angular != 0) {
  const Twist centroid = atPoint(centroid_, twist);
  const double speed = centroid.linear.norm();
  const double acceleration = std::abs(twist.angular) * speed;
  const double radius = footprint.boundingRadius();
  // As many as make the bulges some tenths of the footprint: more cost more than they save.
  const double bulge = (acceleration + obstacle_acceleration) * horizon * horizon / 8;
  while (count_ < kMostWindows && bulge > 0.5 * radius * static_cast<double>(count_ * count_))
    ++count_;
  const double duration = horizon / static_cast<double>(count_);
  const double own_bulge = acceleration * duration * duration / 8;
  const Turn turn(twist.angular * duration);
  Vec2 centre(0, 0), velocity = turn.displacement(centroid.linear);
  for (std::size_t i = 0; i < count_; ++i) {
    const double start = static_cast<double>(i) * duration;
    const double rounding = kGenerous * (radius + (start + duration) * speed);
    windows_[i] = {start, duration, centre, velocity, radius + own_bulge + rounding};
    centre += duration * velocity;
    velocity = turn(velocity);
  }
}

namespace {

/// The indices of those that are marked. Most are not, so whole groups are passed over.
std::size_t collect(const std::array<std::int64_t, kBlock>& marks, std::size_t begin,
                    std::size_t count, std::array<std::size_t, kBlock>* candidates) {
  constexpr std::size_t kGroup = 8;
  std::size_t found = 0;
  for (std::size_t group = 0; group < count; group += kGroup) {
    std::int64_t any = 0;
    for (std::size_t i = group; i < group + kGroup; ++i) any |= marks[i];
    if (any == 0) continue;
    for (std::size_t i = group; i < group + kGroup; ++i) {
      (*candidates)[found] = begin + i;
      found += static_cast<std::size_t>(marks[i]);
    }
  }
  return found;
}

}  // namespace

std::size_t findCandidates(const ObstacleBatch& obstacles, std::size_t begin, std::size_t end,
                           const SweptFootprint& footprint, double gap, InstructionSet set,
                           std::array<std::size_t, kBlock>* candidates) {
  std::array<std::int64_t, kBlock> marks;
  const std::size_t count = end - begin;
  marks.fill(0);
  const Arrays arrays{&obstacles.x[begin],
                      &obstacles.y[begin],
                      &obstacles.vx[begin],
                      &obstacles.vy[begin],
                      &obstacles.ax[begin],
                      &obstacles.ay[begin],
                      &obstacles.bounding_radius[begin],
                      &obstacles.radius_rate[begin]};
  const bool straight = !footprint.turns() && !obstacles.bends();
  const Mark mark_window = straight ? markWith<true>(set) : markWith<false>(set);
  for (const auto& window : footprint)
    mark_window(arrays, count, {footprint.centroid(), window, gap}, marks.data());
  return collect(marks, begin, count, candidates);
}

bool mayComeWithin(double gap, const SweptFootprint& footprint, const Disc& disc,
                   double bounding_radius) {
  const Motion& m = disc.motion;
  const Arrays one{&m.position.x(),     &m.position.y(),     &m.velocity.x(),  &m.velocity.y(),
                   &m.acceleration.x(), &m.acceleration.y(), &bounding_radius, &disc.radius_rate};
  const auto may_touch = [&](const SweptFootprint::Window& window) {
    return mayTouch(one, 0, {footprint.centroid(), window, gap});
  };
  return std::any_of(footprint.begin(), footprint.end(), may_touch);
}

bool mayTouch(const Polygon& footprint, const Twist& twist, const Disc& disc, double horizon) {
  const Motion& m = disc.motion;
  if (twist.angular == 0) {  // most are settled by a single window
    const Vec2 p = m.position - footprint.centroid();
    const Vec2 v = m.velocity - twist.linear + 0.5 * horizon * m.acceleration;
    const double bulge = 0.125 * horizon * horizon * m.acceleration.lpNorm<1>();
    const double reach = disc.radius + footprint.boundingRadius() * (1 + kGenerous) + bulge;
    const bool may_touch =
        disc.radius_rate == 0
            ? mayTouch<false>(p.x(), p.y(), v.x(), v.y(), reach, 0, horizon)
            : mayTouch<true>(p.x(), p.y(), v.x(), v.y(), reach, disc.radius_rate, horizon);
    if (!may_touch) return false;
    if (bulge == 0) return true;
  }
  const SweptFootprint swept(footprint, twist, horizon, m.acceleration.norm());
  return mayComeWithin(0, swept, disc, disc.radius);
}

bool mayComeWithin(double gap, const Polygon& footprint, const Disc& disc, double bounding_radius) {
  const double reach = bounding_radius + footprint.boundingRadius() + gap;
  const double p2 = (disc.motion.position - footprint.centroid()).squaredNorm();
  return reach >= 0 && p2 * (1 - kGenerous) <= reach * reach;
}

}  // namespace footprint_collision_predictor::core
