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

struct QuadTurn {
  Quad sine;
  Quad cosine;
};

/// Of an angle of up to 1e6 rad, to about 1e-33 and its own rounding: whole quarters of a turn are
/// taken off, the rest goes into the power series. Of a small angle, the sine has all its bits.
inline QuadTurn sineAndCosine(Quad angle) {
  const Quad quarter =
      Quad(0x1.921fb54442d18p+0) + Quad(0x1.1a62633145c07p-54) - Quad(0x1.f1976b7ed8fbcp-110);
  const double count = std::round(static_cast<double>(angle / quarter));
  const Quad x = angle - count * quarter;
  Quad sine = 0, cosine = 0, term = 1;  // term: x^n / n!
  for (int n = 0; n < 32; n += 4) {
    cosine += term - term * x * x / ((n + 1) * (n + 2));
    term *= x / (n + 1);
    sine += term - term * x * x / ((n + 2) * (n + 3));
    term *= x * x * x / ((n + 2) * (n + 3) * (n + 4));
  }
  const int side = static_cast<int>(std::fmod(count, 4) + 4) % 4;
  if (side % 2 == 1) return side == 1 ? QuadTurn{cosine, -sine} : QuadTurn{-cosine, sine};
  return side == 0 ? QuadTurn{sine, cosine} : QuadTurn{-sine, -cosine};
}

}  // namespace footprint_collision_predictor::test
