// The answers are the same to the last bit whatever instructions the processor has.
#include <gtest/gtest.h>

#include "batch.hpp"
#include "guarantee.hpp"
#include "scene.hpp"

namespace footprint_collision_predictor::test {
namespace {

using core::BatchQuery;
using core::InstructionSet;

using Contacts = std::vector<std::optional<core::SegmentContact>>;

struct Answers {
  std::optional<core::FootprintContact> first;
  Contacts segments;
  std::optional<core::NearestObstacle> nearest;
  std::optional<core::ClosestApproach> closest;
};

Answers answersTo(const Scene& scene, InstructionSet set) {
  const core::Polygon footprint(scene.footprint);
  const core::ObstacleBatch batch(scene.obstacles);
  const BatchQuery query{footprint, scene.twist, batch, scene.horizon, set};
  Answers answers;
  answers.first = firstContact(query);
  firstContacts(query, &answers.segments);
  answers.nearest = nearestObstacle(query, HUGE_VAL);
  if (!answers.first) answers.closest = closestApproach(query, answers.nearest->nearest.gap);
  return answers;
}

template <typename SomeContact>
bool areSame(const std::optional<SomeContact>& a, const std::optional<SomeContact>& b) {
  if (!a || !b) return a.has_value() == b.has_value();
  return a->obstacle == b->obstacle && a->contact.time == b->contact.time &&
         a->contact.feature == b->contact.feature && a->contact.point == b->contact.point;
}

std::string difference(const Answers& a, const Answers& b) {
  if (!areSame(a.first, b.first)) return "first contact";
  if (a.first && a.first->closing_speed != b.first->closing_speed) return "closing speed";
  for (std::size_t i = 0; i < a.segments.size(); ++i)
    if (!areSame(a.segments[i], b.segments[i])) return "segment " + std::to_string(i);
  if (a.nearest->obstacle != b.nearest->obstacle) return "nearest obstacle";
  if (!a.closest && !b.closest) return "";
  const bool same = a.closest && b.closest && a.closest->distance == b.closest->distance &&
                    a.closest->time == b.closest->time;
  return same ? "" : "closest approach";
}

void compareWithBaseline(InstructionSet set) {
  if (!core::isSupported(set)) GTEST_SKIP() << "this processor does not have it";
  forEachCase("instruction sets", {1000, 50000}, [set](Random& random) -> std::string {
    const Scene scene = anyScene(random);
    const std::string text =
        difference(answersTo(scene, InstructionSet::kBaseline), answersTo(scene, set));
    return text.empty() ? "" : text + " differs";
  });
}

TEST(InstructionSet, BaselineIsSupportedEverywhere) {
  EXPECT_TRUE(core::isSupported(InstructionSet::kBaseline));
  EXPECT_TRUE(core::isSupported(core::widestInstructionSet()));
}

TEST(InstructionSet, Avx2ChangesNothing) { compareWithBaseline(InstructionSet::kAvx2); }
TEST(InstructionSet, Avx512ChangesNothing) { compareWithBaseline(InstructionSet::kAvx512); }

}  // namespace
}  // namespace footprint_collision_predictor::test
