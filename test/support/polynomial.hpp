// Real roots of polynomials up to degree 4, isolated by the roots of their derivatives.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "quad.hpp"

namespace footprint_collision_predictor::test {

/// c[0] + c[1] t + ... + c[4] t^4
struct Polynomial {
  Polynomial(const std::array<Quad, 5>& coefficients);

  Quad at(Quad t) const;
  Polynomial derivative() const;

  std::array<Quad, 5> c;
  std::size_t degree = 4;  // of the last coefficient that is not 0; 0 for a constant
};

/// All roots in [low, high] at which the polynomial is exactly 0 or changes its sign, ascending.
std::vector<Quad> rootsBetween(const Polynomial& p, Quad low, Quad high);

/// The first t in [low, high] with p(t) <= 0. Between neighbouring roots of the derivative p is
/// monotone, so its values there decide whether there is one at all.
std::optional<Quad> firstNotPositive(const Polynomial& p, Quad low, Quad high);

}  // namespace footprint_collision_predictor::test
