// 113-bit floating point for the oracle: arithmetic comes with the compiler, the rest is here.
#pragma once

#include <cmath>

namespace footprint_collision_predictor::test {

__extension__ typedef __float128 Quad;

inline Quad absolute(Quad x) { return x < 0 ? -x : x; }
inline Quad larger(Quad a, Quad b) { return a < b ? b : a; }
inline Quad smaller(Quad a, Quad b) { return b < a ? b : a; }

/// Newton from the double root. Exact for squares of integers, 0 for x <= 0.
inline Quad squareRoot(Quad x) {
  if (!(x > 0)) return 0;
  const double tiny = 1e-200;  // below, the double seed would be denormal: scale by a power of 4
  if (x < Quad(tiny)) return squareRoot(x * Quad(0x1p600) * Quad(0x1p600)) * Quad(0x1p-600);
  Quad root = std::sqrt(static_cast<double>(x));
  for (int i = 0; i < 3 && root * root != x; ++i) root = (root + x / root) / 2;
  return root;
}

}  // namespace footprint_collision_predictor::test
