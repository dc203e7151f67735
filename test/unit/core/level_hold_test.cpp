// The level rises at once and falls slowly; loss of data is never held back.
#include <gtest/gtest.h>

#include <string>

#include "footprint_collision_predictor/warning.hpp"

namespace footprint_collision_predictor::core {
namespace {

Level levelOf(char c) {
  switch (c) {
    case 'C':
      return Level::kClear;
    case 'W':
      return Level::kWarn;
    case '!':
      return Level::kCritical;
    default:
      return Level::kUnknown;
  }
}

char letterOf(Level level) { return "?CW!"[static_cast<int>(level)]; }

/// What is shown after each message. Messages: ? unknown, C clear, W warn, ! critical; | is a gap.
std::string shownAfter(LevelHold* hold, const std::string& messages) {
  std::string shown;
  for (const char c : messages) {
    if (c == '|') {
      hold->restartCount();
      shown += '|';
      continue;
    }
    hold->update(levelOf(c));
    shown += letterOf(hold->shown(levelOf(c)));
  }
  return shown;
}

std::string shownAfter(const std::string& messages, std::size_t clear_after = 3) {
  LevelHold hold(clear_after);
  return shownAfter(&hold, messages);
}

TEST(LevelHold, IsUnknownUntilEnoughGoodMessagesCame) {
  EXPECT_EQ(shownAfter("CCCC"), "??CC");
  EXPECT_EQ(shownAfter("WWWW"), "??WW");
  EXPECT_EQ(LevelHold(3).shown(Level::kClear), Level::kUnknown);
}

TEST(LevelHold, RisesAtOnce) {
  EXPECT_EQ(shownAfter("!"), "!");
  EXPECT_EQ(shownAfter("CCCW!"), "??CW!");
  EXPECT_EQ(shownAfter("CCC!"), "??C!");
}

TEST(LevelHold, FallsOnlyAfterEnoughLowerMessagesInARow) {
  EXPECT_EQ(shownAfter("CCC!CCC"), "??C!!!C");
  EXPECT_EQ(shownAfter("CCCWCCC"), "??CWWWC");
  EXPECT_EQ(shownAfter("CCC!WWW"), "??C!!!W");
  EXPECT_EQ(shownAfter("CCC!WCCC"), "??C!!!WC");  // the worst of the three lower ones
}

TEST(LevelHold, AnInterruptedCountStartsAgain) {
  EXPECT_EQ(shownAfter("!CC!CCC"), "!!!!!!C");
  EXPECT_EQ(shownAfter("CCCWCCWCCC"), "??CWWWWWWC");
}

TEST(LevelHold, TheNewestMayGetWorseAndIsHeldAsLongAsAnyOther) {
  LevelHold hold(3);
  shownAfter(&hold, "CCC");
  hold.replaceNewest(Level::kCritical);
  EXPECT_EQ(shownAfter(&hold, "CCC"), "!!C");
}

TEST(LevelHold, UnknownReplacesAHeldCriticalAtOnce) {
  EXPECT_EQ(shownAfter("!?"), "!?");
  EXPECT_EQ(shownAfter("CCC!C?CCC"), "??C!!???C");
  EXPECT_EQ(shownAfter("CCCW?W"), "??CW??");
  EXPECT_EQ(shownAfter("CCC!?CCC"), "??C!???C");  // and what was held is forgotten
}

TEST(LevelHold, ARepeatShowsUnknownInsteadOfAHeldCritical) {
  LevelHold hold(3);
  shownAfter(&hold, "CCC!");
  EXPECT_EQ(hold.shown(Level::kUnknown), Level::kUnknown);
  EXPECT_EQ(hold.shown(Level::kClear), Level::kCritical);
}

TEST(LevelHold, ARepeatShowsTheWorseAndChangesNothing) {
  LevelHold hold(3);
  shownAfter(&hold, "CCC");
  EXPECT_EQ(hold.shown(Level::kCritical), Level::kCritical);
  EXPECT_EQ(hold.shown(Level::kWarn), Level::kWarn);
  EXPECT_EQ(hold.shown(Level::kUnknown), Level::kUnknown);
  EXPECT_EQ(hold.shown(Level::kClear), Level::kClear);
}

TEST(LevelHold, AGapRestartsTheCountAndKeepsTheLevel) {
  EXPECT_EQ(shownAfter("CCC!CC|CCC"), "??C!!!|!!C");
  EXPECT_EQ(shownAfter("CC|CCC"), "??|??C");
  EXPECT_EQ(shownAfter("CCC|C"), "??C|C");
}

TEST(LevelHold, WithOneMessageNothingIsHeld) {
  EXPECT_EQ(shownAfter("C!C?WC", 1), "C!C?WC");
  EXPECT_EQ(LevelHold(1).shown(Level::kClear), Level::kUnknown);
}

TEST(LevelHold, ResetIsTheStart) {
  LevelHold hold(2);
  EXPECT_EQ(shownAfter(&hold, "CC!"), "?C!");
  hold.reset();
  EXPECT_EQ(shownAfter(&hold, "CC"), "?C");
}

TEST(LevelHold, AReplacementCountsWithWhatItReplacesAtTheWorseOfBoth) {
  LevelHold hold(2);
  hold.update(Level::kCritical);
  hold.update(Level::kClear);
  hold.replaceNewest(Level::kClear);
  EXPECT_EQ(hold.shown(Level::kClear), Level::kCritical) << "only one message since";
  hold.update(Level::kWarn);
  hold.replaceNewest(Level::kClear);
  EXPECT_EQ(hold.shown(Level::kClear), Level::kWarn);
  hold.replaceNewest(Level::kUnknown);
  EXPECT_EQ(hold.shown(Level::kClear), Level::kUnknown);
}

TEST(LevelHold, AnotherLengthKeepsWhatIsHeldAndCountsAnew) {
  LevelHold hold(3);
  hold.update(Level::kCritical);
  hold.update(Level::kClear);
  hold.update(Level::kClear);
  hold.setClearAfter(2);
  EXPECT_EQ(hold.shown(Level::kClear), Level::kCritical);
  hold.update(Level::kClear);
  EXPECT_EQ(hold.shown(Level::kClear), Level::kCritical);
  hold.update(Level::kClear);
  EXPECT_EQ(hold.shown(Level::kClear), Level::kClear);
  hold.setClearAfter(5);
  EXPECT_EQ(hold.shown(Level::kClear), Level::kClear);
}

}  // namespace
}  // namespace footprint_collision_predictor::core
