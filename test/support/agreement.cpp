#include "agreement.hpp"

#include <algorithm>

#include "guarantee.hpp"
#include "oracle.hpp"

namespace footprint_collision_predictor::test {

bool notLater(const Answer& answer, double time) {
  return answer && answer->time <= time + 1e-9 * std::max(1.0, time);
}

bool hairIsLeft(const Case& c, double time, double hair) {
  const Quad gap = trueGap(c, time);
  return gap > 0 && gap <= Quad(hair);
}

std::string disagreement(const Case& one, const Answer& a, const Case& other, const Answer& b,
                         double off_at_a, double off_at_b) {
  const auto mayBeEarly = [](const Case& early, double time, const Case& late, double off) {
    return hairIsLeft(late, time, allowedGap(early, time) + off);
  };
  const bool fine = (!a || notLater(b, a->time) || mayBeEarly(one, a->time, other, off_at_a)) &&
                    (!b || notLater(a, b->time) || mayBeEarly(other, b->time, one, off_at_b));
  return fine ? "" : asCode(one) + "\nand\n" + asCode(other);
}

std::string disagreement(const Case& one, const Case& other) {
  return disagreement(one, ask(one), other, ask(other));
}

}  // namespace footprint_collision_predictor::test
