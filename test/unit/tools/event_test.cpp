// Where an approach begins and ends.
#include "analysis/event.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace footprint_collision_predictor::tools {
namespace {

using W = CollisionWarning;

constexpr double kNone = std::numeric_limits<double>::infinity();
constexpr double kWarnTime = 3;
constexpr double kLongestUnknown = 0.5;

class EventTest : public testing::Test {
 protected:
  /// One evaluation a tenth of a second after the one before.
  void then(std::uint8_t level, double time_to_collision, double clearance = 1) {
    Evaluation evaluation{elapsed_, false, {}};
    W& warning = evaluation.answer.warning;
    warning.header.stamp = ros::Time(1000 + elapsed_);
    warning.level = level;
    warning.time_to_collision = time_to_collision;
    warning.collision_predicted = std::isfinite(time_to_collision) ? 1 : 0;
    warning.clearance = clearance;
    finder_.take(evaluation);
    elapsed_ += 0.1;
  }
  void after(double seconds) { elapsed_ += seconds - 0.1; }
  std::vector<Event> events() { return finder_.finish(); }

 private:
  EventFinder finder_{kWarnTime, kLongestUnknown};
  double elapsed_ = 0;
};

TEST_F(EventTest, NothingNear) {
  then(W::CLEAR, kNone);
  then(W::CLEAR, 4);
  then(W::UNKNOWN, std::nan(""));
  EXPECT_TRUE(events().empty());
}

TEST_F(EventTest, LastsAsLongAsTheLevel) {
  then(W::CLEAR, 4);
  then(W::WARN, 2.5);
  then(W::WARN, kNone);
  then(W::WARN, kNone);
  then(W::CLEAR, kNone);
  then(W::CRITICAL, 1);
  const auto found = events();
  ASSERT_EQ(found.size(), 2u);
  EXPECT_NEAR(found[0].begin, 0.1, 1e-9);
  EXPECT_NEAR(found[0].end, 0.3, 1e-9);
  EXPECT_EQ(found[0].level, W::WARN);
  EXPECT_EQ(found[0].worst.time_to_collision, 2.5);
  EXPECT_EQ(found[0].ended, EventEnd::kClear);
  EXPECT_EQ(found[1].level, W::CRITICAL);
  EXPECT_EQ(found[1].ended, EventEnd::kRecording);
}

TEST_F(EventTest, CertainContactCountsAlthoughTheLevelIsUnknown) {
  then(W::UNKNOWN, 2.9);
  ASSERT_EQ(events().size(), 1u);
}

TEST_F(EventTest, WorstIsTheFirstOfTheSmallest) {
  then(W::WARN, 2);
  then(W::CRITICAL, 0);
  then(W::CRITICAL, 0);
  then(W::WARN, 3);
  EXPECT_NEAR(events().at(0).worst.elapsed, 0.1, 1e-9);
}

TEST_F(EventTest, ContactMustHaveBeenSeen) {
  then(W::CRITICAL, 0.001);
  EXPECT_FALSE(events().at(0).contact);
  then(W::CRITICAL, 0);
  EXPECT_TRUE(events().at(0).contact);
}

TEST_F(EventTest, ClosestDistanceIsTheSmallestThatIsKnown) {
  then(W::WARN, 2, std::nan(""));
  then(W::WARN, 2, 0.7);
  then(W::WARN, 2, std::nan(""));
  EXPECT_EQ(events().at(0).closest_distance, 0.7);
  then(W::WARN, 2, std::nan(""));
  EXPECT_TRUE(std::isnan(events().at(0).closest_distance));
}

TEST_F(EventTest, ShortUnknownBelongsToIt) {
  then(W::WARN, 2);
  then(W::UNKNOWN, std::nan(""));
  then(W::WARN, 2);
  const auto found = events();
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].end, 0.2, 1e-9);
}

TEST_F(EventTest, LongUnknownEndsIt) {
  then(W::WARN, 2);
  then(W::UNKNOWN, std::nan(""));
  after(0.6);
  then(W::WARN, 2);
  const auto found = events();
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].ended, EventEnd::kUnknown);
  EXPECT_NEAR(found[0].end, 0.0, 1e-9);
}

TEST_F(EventTest, UnknownToTheEnd) {
  then(W::WARN, 2);
  then(W::UNKNOWN, std::nan(""));
  EXPECT_EQ(events().at(0).ended, EventEnd::kUnknown);
}

}  // namespace
}  // namespace footprint_collision_predictor::tools
