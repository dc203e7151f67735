#include "broad_phase.hpp"

#include <algorithm>
#include <cmath>

namespace footprint_collision_predictor::core {
namespace {

// Far more than what rounding can amount to in the squares below, relative to their terms.
constexpr double kRounding = 1e-12;

/// One obstacle, or the arrays of many.
struct Moving {
  double x, y, vx, vy, ax, ay, radius, radius_rate;
};

/// Whether two circles may touch within the window: the one of the obstacle, and the footprint's,
/// grown by `gap`.
/// \param o with the position relative to the centroid
[[gnu::always_inline]] inline bool mayTouch(const Moving& o, const SweptFootprint::Window& w,
                                            double gap) {
  const double t = w.start, duration = w.duration;
  const double middle = t + 0.5 * duration;
  const double px = o.x + t * (o.vx + 0.5 * t * o.ax) - w.centre.x();
  const double py = o.y + t * (o.vy + 0.5 * t * o.ay) - w.centre.y();
  const double vx = o.vx + middle * o.ax - w.velocity.x();
  const double vy = o.vy + middle * o.ay - w.velocity.y();
  const double bulge = 0.125 * duration * duration * (std::abs(o.ax) + std::abs(o.ay));
  const double reach = o.radius + o.radius_rate * t + w.radius + bulge + gap;
  const double rate = o.radius_rate;
  // |p + v t|^2 - (reach + rate t)^2 = f + 2 h t + m t^2, and its discriminant as a sum of squares
  // of cross products, which does not cancel far away.
  const double p2 = px * px + py * py;
  const double v2 = vx * vx + vy * vy;
  const double f = p2 - reach * reach;
  const double h = px * vx + py * vy - reach * rate;
  const double m = v2 - rate * rate;
  const double cross = px * vy - py * vx;
  const double sx = reach * vx - rate * px, sy = reach * vy - rate * py;
  const double discriminant = sx * sx + sy * sy - cross * cross;
  const double at_end = f + duration * (2 * h + duration * m);
  const double size = p2 + reach * reach + duration * duration * (v2 + rate * rate);
  const bool at_the_ends = (f <= kRounding * size) | (at_end <= kRounding * size);
  const bool between = (h <= 0) & (h + m * duration >= 0) &
                       (discriminant >= -kRounding * (p2 + reach * reach) * (v2 + rate * rate));
  // A negative reach is a gap that overlaps alone can have.
  return (at_the_ends | between) & (reach >= 0);
}

struct Arrays {
  const double *x, *y, *vx, *vy, *ax, *ay, *radius, *radius_rate;
};

/// What all obstacles are asked.
struct Question {
  double origin_x, origin_y;
  SweptFootprint::Window window;
  double gap;
};

[[gnu::always_inline]] inline void mark(const Arrays& a, std::size_t count, const Question& q,
                                        std::int64_t* marks) {
  for (std::size_t i = 0; i < count; ++i) {
    const Moving o{a.x[i] - q.origin_x, a.y[i] - q.origin_y, a.vx[i], a.vy[i], a.ax[i], a.ay[i],
                   a.radius[i],         a.radius_rate[i]};
    marks[i] |= mayTouch(o, q.window, q.gap) ? 1 : 0;
  }
}

void markBaseline(const Arrays& a, std::size_t count, const Question& q, std::int64_t* marks) {
  mark(a, count, q, marks);
}

#ifdef __x86_64__
[[gnu::target("avx2")]] void markAvx2(const Arrays& a, std::size_t count, const Question& q,
                                      std::int64_t* marks) {
  mark(a, count, q, marks);
}

[[gnu::target("avx512f,avx512vl,avx512dq,prefer-vector-width=512")]] void markAvx512(
    const Arrays& a, std::size_t count, const Question& q, std::int64_t* marks) {
  mark(a, count, q, marks);
}
#endif

using Mark = void (*)(const Arrays&, std::size_t, const Question&, std::int64_t*);

Mark markWith(InstructionSet set) {
#ifdef __x86_64__
  if (set == InstructionSet::kAvx512) return markAvx512;
  if (set == InstructionSet::kAvx2) return markAvx2;
#endif
  (void)set;
  return markBaseline;
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
                               double obstacle_acceleration) {
  centroid_ = footprint.centroid();
  const Twist centroid = atPoint(centroid_, twist);
  const double acceleration = std::abs(twist.angular) * centroid.linear.norm();
  const double radius = footprint.boundingRadius();
  // As many windows as make the bulges some tenths of the footprint: more cost more than they save.
  const double bulge = (acceleration + obstacle_acceleration) * horizon * horizon / 8;
  const double wanted = std::ceil(std::sqrt(2 * bulge / radius));
  count_ = static_cast<std::size_t>(std::clamp(wanted, 1.0, static_cast<double>(windows_.size())));
  const double duration = horizon / static_cast<double>(count_);
  Vec2 centre(0, 0);
  for (std::size_t i = 0; i < count_; ++i) {
    const double start = static_cast<double>(i) * duration;
    const Vec2 next = displacement(centroid, start + duration);
    const Vec2 velocity = duration > 0 ? Vec2((next - centre) / duration) : Vec2(0, 0);
    const double rounding = kRounding * (radius + (start + duration) * centroid.linear.norm());
    windows_[i] = {start, duration, centre, velocity,
                   radius + acceleration * duration * duration / 8 + rounding};
    centre = next;
  }
}

std::size_t findCandidates(const ObstacleBatch& obstacles, std::size_t begin, std::size_t end,
                           const SweptFootprint& footprint, double gap, InstructionSet set,
                           std::array<std::size_t, kBlock>* candidates) {
  std::array<std::int64_t, kBlock> marks;
  const std::size_t count = end - begin;
  std::fill_n(marks.begin(), count, 0);
  const Arrays arrays{&obstacles.x[begin],
                      &obstacles.y[begin],
                      &obstacles.vx[begin],
                      &obstacles.vy[begin],
                      &obstacles.ax[begin],
                      &obstacles.ay[begin],
                      &obstacles.bounding_radius[begin],
                      &obstacles.radius_rate[begin]};
  const Mark mark_window = markWith(set);
  const Vec2& origin = footprint.centroid();
  for (const auto& window : footprint)
    mark_window(arrays, count, {origin.x(), origin.y(), window, gap}, marks.data());
  std::size_t found = 0;
  for (std::size_t i = 0; i < count; ++i) {
    (*candidates)[found] = begin + i;
    found += static_cast<std::size_t>(marks[i]);
  }
  return found;
}

bool mayComeWithin(double gap, const SweptFootprint& footprint, const Disc& disc,
                   double bounding_radius) {
  const Motion& m = disc.motion;
  const Vec2 position = m.position - footprint.centroid();
  const Moving moving{position.x(),       position.y(),       m.velocity.x(),  m.velocity.y(),
                      m.acceleration.x(), m.acceleration.y(), bounding_radius, disc.radius_rate};
  return std::any_of(footprint.begin(), footprint.end(),
                     [&](const auto& window) { return mayTouch(moving, window, gap); });
}

}  // namespace footprint_collision_predictor::core
