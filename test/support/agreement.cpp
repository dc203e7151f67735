#include "agreement.hpp"

#include <algorithm>

#include "guarantee.hpp"
#include "oracle.hpp"

namespace footprint_collision_predictor::test {

bool notLater(const Answer& answer, double time) {
  return answer && answer->time <= time + 1e-9 * std::max(1.0, time);
}

bool hairIsLeft(const Case& c, double time, double more) {
  const Quad gap = trueGap(c, time);
  return gap > 0 && gap <= Quad(allowedGap(c, time)) + more;
}

std::string disagreement(const Case& one, const Answer& a, const Case& other, const Answer& b,
                         double off_at_a, double off_at_b) {
  if (!a && !b) return "";
  const bool fine =
      (!a || notLater(b, a->time) || hairIsLeft(other, a->time, off_at_a)) &&
      (!b || notLater(a, b->time) || hairIsLeft(one, b->time, off_at_b));
  return fine ? "" : asCode(one) + "\nand\n" + asCode(other);
}

std::string disagreement(const Case& one, const Case& other) {
  return disagreement(one, ask(one), other, ask(other));
}

}  // namespace footprint_collision_predictor::test
