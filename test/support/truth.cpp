#include "truth.hpp"

#include "interval_oracle.hpp"
#include "oracle.hpp"

namespace footprint_collision_predictor::test {
namespace {

/// What intervals bracket, narrowed down in 113 bits: by the gap, which for a point never falls below
/// 0, and for a point by the side on which it is.
Quad narrowed(const Case& c, Quad apart, Quad touching) {
  const bool is_point = c.radius == 0 && c.radius_rate == 0;
  const bool was_left = trueSide(c, apart) > 0;
  if (is_point && (trueSide(c, touching) > 0) == was_left) return touching;
  while (touching - apart > Quad(1e-12) * larger(1, touching)) {
    const Quad middle = apart + (touching - apart) / 2;
    const bool touches = is_point ? (trueSide(c, middle) > 0) != was_left : trueGap(c, middle) <= 0;
    (touches ? touching : apart) = middle;
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
