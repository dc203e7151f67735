#include "polynomial.hpp"

namespace footprint_collision_predictor::test {
namespace {

/// Cheap start for Newton: sixty halvings in double. It may be wrong by rounding, never outside.
Quad roughRoot(const Polynomial& p, Quad low, Quad high, bool low_is_positive) {
  std::array<double, 5> c{};
  for (std::size_t i = 0; i < 5; ++i) c[i] = static_cast<double>(p.c[i]);
  double a = static_cast<double>(low);
  double b = static_cast<double>(high);
  for (int i = 0; i < 60; ++i) {
    const double m = a + 0.5 * (b - a);
    const double value = (((c[4] * m + c[3]) * m + c[2]) * m + c[1]) * m + c[0];
    ((value > 0) == low_is_positive ? a : b) = m;
  }
  return smaller(larger(low, a), high);
}

/// The sign change between low and high: Newton, or a bisection step where Newton leaves the
/// bracket or is slow.
Quad bracketedRoot(const Polynomial& p, Quad low, Quad high) {
  const bool low_is_positive = p.at(low) > 0;
  const Polynomial slope = p.derivative();
  const Quad precision = Quad(0x1p-106);
  Quad t = roughRoot(p, low, high, low_is_positive);
  Quad last_step = high - low;
  for (int i = 0; i < 500; ++i) {
    const Quad value = p.at(t);
    if (value == 0) return t;
    ((value > 0) == low_is_positive ? low : high) = t;
    const Quad steepness = slope.at(t);
    Quad next = steepness != 0 ? t - value / steepness : low;
    const bool slow = 2 * absolute(next - t) > absolute(last_step);
    if (!(next > low && next < high) || slow) next = low + (high - low) / 2;
    last_step = next - t;
    if (absolute(last_step) <= precision * absolute(next)) return next;
    t = next;
  }
  return t;
}

std::vector<Quad> monotonePieces(const Polynomial& p, Quad low, Quad high) {
  std::vector<Quad> knots{low};
  if (p.degree > 1) {
    const std::vector<Quad> turns = rootsBetween(p.derivative(), low, high);
    knots.insert(knots.end(), turns.begin(), turns.end());
  }
  knots.push_back(high);
  return knots;
}

}  // namespace

Polynomial::Polynomial(const std::array<Quad, 5>& coefficients) : c(coefficients) {
  while (degree > 0 && c[degree] == 0) --degree;
}

Quad Polynomial::at(Quad t) const {
  std::size_t i = degree;
  Quad value = c[i];
  while (i > 0) value = value * t + c[--i];
  return value;
}

Polynomial Polynomial::derivative() const { return {{c[1], 2 * c[2], 3 * c[3], 4 * c[4], 0}}; }

std::vector<Quad> rootsBetween(const Polynomial& p, Quad low, Quad high) {
  std::vector<Quad> roots;
  if (p.degree == 0 || !(low <= high)) return roots;
  const std::vector<Quad> knots = monotonePieces(p, low, high);
  Quad left = p.at(knots.front());
  for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
    const Quad right = p.at(knots[i + 1]);
    if (left == 0) roots.push_back(knots[i]);
    if ((left < 0 && right > 0) || (left > 0 && right < 0))
      roots.push_back(bracketedRoot(p, knots[i], knots[i + 1]));
    left = right;
  }
  if (left == 0) roots.push_back(knots.back());
  return roots;
}

std::optional<Quad> firstNotPositive(const Polynomial& p, Quad low, Quad high) {
  if (!(low <= high)) return std::nullopt;
  if (p.at(low) <= 0) return low;
  const std::vector<Quad> knots = monotonePieces(p, low, high);
  for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
    const Quad right = p.at(knots[i + 1]);
    if (right == 0) return knots[i + 1];
    if (right < 0) return bracketedRoot(p, knots[i], knots[i + 1]);
  }
  return std::nullopt;
}

}  // namespace footprint_collision_predictor::test
