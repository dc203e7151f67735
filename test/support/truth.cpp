#include "truth.hpp"

#include "interval_oracle.hpp"
#include "oracle.hpp"

namespace footprint_collision_predictor::test {
namespace {

/// What intervals bracket, narrowed down in 113 bits: by the gap or, where a point has crossed the
/// segment in between, by the side on which it is.
Quad narrowed(const Case& c, Quad apart, Quad touching) {
  const bool was_left = trueSide(c, apart) > 0;
  const bool is_apart_again = trueGap(c, touching) > 0;
  if (is_apart_again && (trueSide(c, touching) > 0) == was_left) return touching;
  while (touching - apart > Quad(1e-12) * larger(1, touching)) {
    const Quad middle = apart + (touching - apart) / 2;
    const bool is_late =
        is_apart_again ? (trueSide(c, middle) > 0) != was_left : trueGap(c, middle) <= 0;
    (is_late ? touching : apart) = middle;
  }
  return touching;
}

}  // namespace

Truth truthOf(const Case& c) {
  if (c.twist.angular == 0) return {trueContact(c), true};
  const Proof proof = prove(c);
  if (!proof.contact_at) return {std::nullopt, !proof.isUndecided()};
  return {narrowed(c, proof.free_until, *proof.contact_at), !proof.isUndecided()};
}

}  // namespace footprint_collision_predictor::test
