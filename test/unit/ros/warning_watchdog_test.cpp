// When a consumer of warnings may go on: only with a new, fresh, known and low enough warning.
#include "footprint_collision_predictor/ros/warning_watchdog.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace footprint_collision_predictor {
namespace {

constexpr double kEpoch = 1.7e9;  // [s] ROS time at steady time 0
constexpr double kPeriod = 0.05;  // [s] of the heartbeat
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

ros::SteadyTime steadyAt(double t) { return ros::SteadyTime(1000 + t); }

class Watchdog : public testing::Test {
 protected:
  /// Published and received at t, with data from 0.1 s before.
  CollisionWarning warningAt(double t) {
    CollisionWarning warning;
    warning.footprint = "footprint";
    warning.level = CollisionWarning::CLEAR;
    warning.header.stamp = ros::Time(kEpoch + t);
    warning.data_age = 0.1;
    warning.session = session;
    warning.sequence = ++sequence;
    return warning;
  }

  void take(const CollisionWarning& warning, double t) {
    watchdog.take(warning, ros::Time(kEpoch + t), steadyAt(t));
  }

  /// Heartbeats without a fault from one time to another, both inclusive.
  void hear(double from, double to) {
    for (int i = 0; from + i * kPeriod <= to + 1e-9; ++i)
      take(warningAt(from + i * kPeriod), from + i * kPeriod);
  }

  bool isSafe(double t) const { return watchdog.safeToGoOn(steadyAt(t)).safe; }
  std::string why(double t) const { return watchdog.safeToGoOn(steadyAt(t)).why; }

  /// Heartbeats until 1 s, the last of them changed: whether it is safe then.
  template <typename Change>
  bool isSafeWith(const Change& change) {
    hear(0, 1 - kPeriod);
    CollisionWarning last = warningAt(1);
    change(last);
    take(last, 1);
    return isSafe(1);
  }

  WarningWatchdog watchdog;
  std::uint32_t session = 5;
  std::uint32_t sequence = 40;
};

/// Both words and no: an answer without a reason helps nobody.
#define EXPECT_UNSAFE(t, words) \
  EXPECT_FALSE(isSafe(t));      \
  EXPECT_NE(why(t).find(words), std::string::npos) << why(t)

TEST_F(Watchdog, BeforeTheFirstWarningNothingIsSafe) {
  EXPECT_UNSAFE(0, "no collision warning has come yet");
}

TEST_F(Watchdog, SafeWithFreshWarnings) {
  hear(0, 1);
  EXPECT_TRUE(isSafe(1));
  EXPECT_EQ(why(1), "");
}

TEST_F(Watchdog, SilenceIsUnsafeAfter200Milliseconds) {
  hear(0, 1);
  EXPECT_TRUE(isSafe(1.199));
  EXPECT_UNSAFE(1.201, "no collision warning for 0.201 s");
  EXPECT_UNSAFE(1000, "has predictor_node ended");
  hear(1000, 1000);
  EXPECT_TRUE(isSafe(1000));
}

TEST_F(Watchdog, ARepeatedSequenceIsSilence) {
  hear(0, 1);
  for (double t = 1.05; t < 1.5; t += kPeriod) {
    --sequence;
    take(warningAt(t), t);
  }
  EXPECT_TRUE(isSafe(1.199));
  EXPECT_UNSAFE(1.201, "repeat sequence 61");
}

TEST_F(Watchdog, AnOlderSequenceIsSilenceEvenIfItSaysClear) {
  hear(0, 1 - kPeriod);
  CollisionWarning critical = warningAt(1);
  critical.level = CollisionWarning::CRITICAL;
  take(critical, 1);
  sequence -= 10;
  take(warningAt(1.01), 1.01);
  EXPECT_UNSAFE(1.02, "CRITICAL");
}

TEST_F(Watchdog, SequencesWrapRound) {
  sequence = std::numeric_limits<std::uint32_t>::max() - 10;
  hear(0, 1);
  EXPECT_LT(sequence, 20u);
  EXPECT_TRUE(isSafe(1.1));
}

TEST_F(Watchdog, LostWarningsAreNoFault) {
  hear(0, 1);
  sequence += 1000;
  hear(1.05, 1.05);
  EXPECT_TRUE(isSafe(1.2));
}

TEST_F(Watchdog, ANewSessionIsReliedOnAfterAWhile) {
  hear(0, 1);
  session = 6;
  sequence = 0;
  hear(1.05, 1.20);
  EXPECT_UNSAFE(1.24, "a predictor has started 0.190 s ago");
  hear(1.25, 1.25);
  EXPECT_TRUE(isSafe(1.25));
}

TEST_F(Watchdog, TwoPredictorsInTurnAreNeverReliedOn) {
  const std::uint32_t sequences[] = {100, 7000};
  for (int i = 0; i < 100; ++i) {
    session = i % 2 == 0 ? 5 : 6;
    sequence = sequences[i % 2] + static_cast<std::uint32_t>(i);
    hear(i * kPeriod, i * kPeriod);
    EXPECT_FALSE(isSafe(i * kPeriod + 0.01)) << i;
  }
  EXPECT_UNSAFE(99 * kPeriod, "two publish in turn");
}

TEST_F(Watchdog, LevelsFromClearToWarnAreSafe) {
  struct Case {
    std::uint8_t level;
    bool safe[4];  // with highest_level of the same number
  };
  const Case cases[] = {{CollisionWarning::UNKNOWN, {false, false, false, false}},
                        {CollisionWarning::CLEAR, {false, true, true, true}},
                        {CollisionWarning::WARN, {false, false, true, true}},
                        {CollisionWarning::CRITICAL, {false, false, false, true}},
                        {4, {false, false, false, false}},
                        {255, {false, false, false, false}}};
  for (const Case& c : cases)
    for (std::uint8_t highest = CollisionWarning::CLEAR; highest <= CollisionWarning::CRITICAL;
         ++highest) {
      WatchdogLimits limits;
      limits.highest_level = highest;
      watchdog = WarningWatchdog(limits);
      EXPECT_EQ(isSafeWith([&](CollisionWarning& w) { w.level = c.level; }), c.safe[highest])
          << int{c.level} << " where up to " << int{highest} << " is safe";
    }
}

TEST_F(Watchdog, ByDefaultWarnIsTheHighestThatIsSafe) {
  EXPECT_TRUE(isSafeWith([](CollisionWarning& w) { w.level = CollisionWarning::WARN; }));
  EXPECT_FALSE(isSafeWith([](CollisionWarning& w) { w.level = CollisionWarning::CRITICAL; }));
}

TEST_F(Watchdog, CriticalIsNotSafeWhileAnythingIsUnknown) {
  WatchdogLimits limits;
  limits.highest_level = CollisionWarning::CRITICAL;
  watchdog = WarningWatchdog(limits);
  EXPECT_FALSE(isSafeWith([](CollisionWarning& w) {
    w.level = CollisionWarning::CRITICAL;
    w.reason = CollisionWarning::REASON_OBSTACLES_INVALID;
  }));
  EXPECT_TRUE(isSafeWith([](CollisionWarning& w) {
    w.level = CollisionWarning::CRITICAL;
    w.reason = CollisionWarning::REASON_DUPLICATE_ID;  // merely degraded
  }));
}

TEST_F(Watchdog, SaysWhatTheWarningSays) {
  isSafeWith([](CollisionWarning& w) {
    w.level = CollisionWarning::UNKNOWN;
    w.message = "no odometry has come on /odom";
  });
  EXPECT_EQ(why(1), "level UNKNOWN: no odometry has come on /odom");
  isSafeWith([](CollisionWarning& w) {
    w.level = CollisionWarning::CRITICAL;
    w.collision_predicted = 1;
    w.time_to_collision = 1.25;
  });
  EXPECT_UNSAFE(1, "level CRITICAL, contact in 1.250 s");
}

TEST_F(Watchdog, OldDataAreUnsafeCountedUntilNow) {
  EXPECT_TRUE(isSafeWith([](CollisionWarning& w) { w.data_age = 0.69; }));
  EXPECT_TRUE(isSafe(1.005));
  EXPECT_UNSAFE(1.02, "data are 0.710 s old");
  EXPECT_FALSE(isSafeWith([](CollisionWarning& w) { w.data_age = kNaN; }));
  EXPECT_FALSE(isSafeWith(
      [](CollisionWarning& w) { w.data_age = std::numeric_limits<double>::infinity(); }));
}

TEST_F(Watchdog, Fault31WarningsThatWaitedInAQueueAreOld) {
  hear(0, 1);
  for (double t = 1.05; t < 3; t += kPeriod) {  // all of them arrive at 4 s, within a moment
    take(warningAt(t), 4);
    EXPECT_UNSAFE(4, "stamped");
  }
  hear(4, 4);
  EXPECT_TRUE(isSafe(4));
}

TEST_F(Watchdog, AnOldStampIsUnsafeCountedUntilNow) {
  EXPECT_TRUE(isSafeWith([](CollisionWarning& w) { w.header.stamp -= ros::Duration(0.69); }));
  EXPECT_UNSAFE(1.02, "stamped 0.710 s ago");
}

TEST_F(Watchdog, AStampAheadOfTheClockIsUnsafe) {
  EXPECT_TRUE(isSafeWith([](CollisionWarning& w) { w.header.stamp += ros::Duration(0.09); }));
  EXPECT_FALSE(isSafeWith([](CollisionWarning& w) { w.header.stamp += ros::Duration(0.11); }));
  EXPECT_UNSAFE(1, "0.110 s ahead of this machine's clock");
}

TEST_F(Watchdog, UnsafeWhileSimulatedTimeHasNotStarted) {
  for (int i = 0; i < 20; ++i) watchdog.take(warningAt(0), ros::Time(), steadyAt(i * kPeriod));
  EXPECT_UNSAFE(1, "has simulated time started");
}

TEST_F(Watchdog, EveryFootprintThatWasHeardHasToBeSafe) {
  hear(0, 0.95);
  CollisionWarning trailer = warningAt(0.95);
  trailer.footprint = "trailer";
  take(trailer, 0.95);
  hear(1, 1.15);
  EXPECT_UNSAFE(1.1, "footprint \"trailer\": a predictor has started");
  EXPECT_UNSAFE(1.16, "footprint \"trailer\": no collision warning for 0.210 s");
}

TEST_F(Watchdog, FootprintsAskedForHaveToBeHeard) {
  watchdog = WarningWatchdog({}, {"footprint", "trailer"});
  EXPECT_UNSAFE(0, "no collision warning has come yet");
  hear(0, 1);
  EXPECT_UNSAFE(1, "footprint \"trailer\": no collision warning has come yet");
}

TEST_F(Watchdog, LimitsThatLimitNothingAreRefused) {
  for (const double wrong : {0.0, -1.0, kNaN, std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW(WarningWatchdog({wrong, 0.7, 0.1, 2}), std::invalid_argument) << wrong;
    EXPECT_THROW(WarningWatchdog({0.2, wrong, 0.1, 2}), std::invalid_argument) << wrong;
    EXPECT_THROW(WarningWatchdog({0.2, 0.7, wrong, 2}), std::invalid_argument) << wrong;
  }
  EXPECT_THROW(WarningWatchdog({0.2, 0.7, 0.1, CollisionWarning::UNKNOWN}), std::invalid_argument);
  EXPECT_THROW(WarningWatchdog({0.2, 0.7, 0.1, 4}), std::invalid_argument);
}

}  // namespace
}  // namespace footprint_collision_predictor
