// What is remembered of an input, by a clock of the test's own.
#include "input_record.hpp"

#include <gtest/gtest.h>

namespace footprint_collision_predictor {
namespace {

ros::SteadyTime at(double seconds) { return ros::SteadyTime(seconds); }

RawMessage from(const std::string& publisher) { return {"pkg/Type", "md5", {}, publisher}; }

Findings refusal(const std::string& words) {
  Findings findings;
  findings.add(CollisionWarning::REASON_OBSTACLES_INVALID, words);
  return findings;
}

TEST(InputRecord, RateFollowsTheMessagesAndFallsWhenTheyCease) {
  InputRecord input("/topic");
  EXPECT_EQ(input.rate(at(100)), 0);
  for (int i = 0; i <= 200; ++i) input.receive(from("/a"), at(100 + 0.1 * i));
  EXPECT_NEAR(input.rate(at(120)), 10, 0.3);
  EXPECT_NEAR(input.rate(at(125)), 5, 0.3);
  EXPECT_EQ(input.rate(at(200)), 0);
}

TEST(InputRecord, RateIsBoundedInMemoryNotInValue) {
  InputRecord input("/topic");
  for (int i = 0; i < 100000; ++i) input.receive(from("/a"), at(100 + 0.0001 * i));
  EXPECT_NEAR(input.rate(at(110)), 10000, 100);
  EXPECT_EQ(input.counts().received, 100000u);
}

TEST(InputRecord, ARefusalStandsUntilTheNextGoodMessageAndIsRememberedAfterIt) {
  InputRecord input("/topic");
  input.refuse(refusal("too red"), at(100));
  EXPECT_TRUE(input.refusal().makeUnknown());
  input.accept({ros::Time(101), at(101)});
  EXPECT_FALSE(input.refusal().makeUnknown());
  EXPECT_EQ(input.lastRefusal(), "too red");
  EXPECT_EQ(input.lastRefusalTime(), at(100));
  EXPECT_EQ(input.counts().accepted, 1u);
  EXPECT_EQ(input.counts().refused, 1u);
}

TEST(InputRecord, ForgettingKeepsTheCounts) {
  InputRecord input("/topic");
  input.accept({ros::Time(101), at(101)});
  input.refuse(refusal("too red"), at(102));
  input.forget();
  EXPECT_FALSE(input.newest());
  EXPECT_FALSE(input.refusal().makeUnknown());
  EXPECT_EQ(input.counts().accepted, 1u);
}

TEST(InputRecord, Fault30TwoThatSendAreNamedUntilOneHasBeenSilent) {
  InputRecord input("/topic");
  input.receive(from("/a"), at(100));
  EXPECT_TRUE(input.severalPublishers(at(100)).empty());
  input.receive(from("/b"), at(100.1));
  const Findings several = input.severalPublishers(at(100.1));
  EXPECT_EQ(several.reasons(), CollisionWarning::REASON_SEVERAL_PUBLISHERS);
  EXPECT_FALSE(several.makeUnknown());
  EXPECT_NE(several.text().find("/topic (/a, /b)"), std::string::npos) << several.text();
  EXPECT_FALSE(input.severalPublishers(at(102)).empty());
  EXPECT_TRUE(input.severalPublishers(at(102.05)).empty()) << "/a has said nothing for 2.05 s";
}

TEST(InputRecord, Fault30TwoThatTheMasterKnowsAreNamedThoughOneIsSilent) {
  InputRecord input("/topic");
  input.receive(from("/a"), at(100));
  input.setRegistered({"/a", "/b"});
  EXPECT_NE(input.severalPublishers(at(200)).text().find("(/a, /b)"), std::string::npos);
  input.setRegistered({});
  EXPECT_TRUE(input.severalPublishers(at(200)).empty());
}

TEST(InputRecord, NodesThatComeAndGoTakeNoMemory) {
  InputRecord input("/topic");
  for (int i = 0; i < 1000; ++i) input.receive(from("/a" + std::to_string(i)), at(100));
  EXPECT_LE(input.publishers(at(100)).size(), 20u);
}

}  // namespace
}  // namespace footprint_collision_predictor
