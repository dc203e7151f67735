// The table of hand-made cases, as it stands and under what must not matter.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <utility>

#include "guarantee.hpp"
#include "oracle.hpp"
#include "time_to_collision_cases.hpp"
#include "truth.hpp"
#include "turning_generators.hpp"

namespace footprint_collision_predictor::test {
namespace {

using core::Feature;

/// The same question elsewhere: turn is orthogonal.
NamedCase moved(NamedCase named, const Eigen::Matrix2d& turn, const Vec2& by) {
  named.question = fromOtherFrame(named.question, turn, by);
  named.point = turn * named.point + by;
  return named;
}

NamedCase swapped(NamedCase named) {
  std::swap(named.question.segment.start, named.question.segment.end);
  if (named.feature == Feature::kStart)
    named.feature = Feature::kEnd;
  else if (named.feature == Feature::kEnd)
    named.feature = Feature::kStart;
  return named;
}

/// Where rounding moves the inputs, contact exactly now or at the horizon becomes a matter of luck;
/// so does an exact graze: these are asked for less than certainty by the guarantee itself.
bool isOnTheEdge(const NamedCase& named) {
  return named.graze || (named.time && (*named.time == named.question.horizon ||
                                        (*named.time == 0 && trueGap(named.question, 0) > -1e-6)));
}

bool isNearEnd(const NamedCase& n) {
  const Segment& s = n.question.segment;
  return (n.point - s.start).norm() < 1e-6 || (n.point - s.end).norm() < 1e-6;
}

/// inexact: the pose rounded the inputs. Where the segment turns, 1e-6 m may be left: these cases
/// are made so that 1e-6 s are worth more.
void expectAnswer(const NamedCase& named, bool inexact) {
  const Case& c = named.question;
  SCOPED_TRACE(named.name + "\n" + asCode(c));
  expectGuarantee(c);
  const std::optional<core::Contact> contact = ask(c);
  if (inexact && isOnTheEdge(named)) return;
  ASSERT_EQ(contact.has_value(), named.time.has_value());
  if (!contact) return;
  if (named.graze) {  // reported early by a hair at most: metres decide, in expectGuarantee
    EXPECT_LE(contact->time, *named.time + 1e-9);
    return;
  }
  const double tolerance = c.twist.angular == 0 ? 1e-9 : 1e-6;
  EXPECT_NEAR(contact->time, *named.time, tolerance);
  const double rounding = 0x1p-52 * named.point.norm();  // of the point itself, far away
  EXPECT_LE((contact->point - named.point).norm(), tolerance + rounding);
  if (c.segment.start == c.segment.end) {  // both ends are right
    EXPECT_NE(static_cast<int>(contact->feature), static_cast<int>(Feature::kInside));
  } else if (named.feature != Feature::kInside || !isNearEnd(named)) {
    EXPECT_EQ(static_cast<int>(contact->feature), static_cast<int>(named.feature));
  }
}

TEST(TimeToCollision, AnswersTheTable) {
  for (const NamedCase& named : namedCases()) expectAnswer(named, false);
}

TEST(TimeToCollision, NamesAreUnique) {
  std::vector<std::string> names;
  for (const NamedCase& named : namedCases()) names.push_back(named.name);
  std::sort(names.begin(), names.end());
  EXPECT_TRUE(std::adjacent_find(names.begin(), names.end()) == names.end());
}

TEST(TimeToCollision, TheOracleAgreesWithTheTable) {
  for (const NamedCase& named : namedCases()) {
    SCOPED_TRACE(named.name);
    const Truth truth = truthOf(named.question);
    if (!truth.is_decided) {  // a graze, in intervals
      EXPECT_TRUE(named.graze);
      continue;
    }
    ASSERT_EQ(truth.contact.has_value(), named.time.has_value());
    if (truth.contact) {
      EXPECT_NEAR(static_cast<double>(*truth.contact), *named.time,
                  named.question.twist.angular == 0 ? 1e-15 : 1e-11);
    }
  }
}

TEST(TimeToCollision, DoesNotDependOnTheDirectionOfTheSegment) {
  for (const NamedCase& named : namedCases()) expectAnswer(swapped(named), false);
}

TEST(TimeToCollision, DoesNotDependOnTheAxes) {
  const Eigen::Matrix2d mirror = Eigen::Vector2d(1, -1).asDiagonal();
  Eigen::Matrix2d quarter;
  quarter << 0, -1, 1, 0;
  Eigen::Matrix2d turn = Eigen::Matrix2d::Identity();
  for (int i = 0; i < 4; ++i, turn = quarter * turn)
    for (const NamedCase& named : namedCases()) {
      expectAnswer(moved(named, turn, {0, 0}), false);
      expectAnswer(moved(named, turn * mirror, {0, 0}), false);
    }
}

TEST(TimeToCollision, DoesNotDependOnThePose) {
  Random random(suiteSeed());
  for (int i = 0; i < 20; ++i) {
    const Eigen::Matrix2d turn = Eigen::Rotation2Dd(random.angle()).toRotationMatrix();
    const Vec2 by = random.uniform(0, 100) * random.direction();
    for (const NamedCase& named : namedCases()) {
      expectAnswer(moved(named, turn, by), true);
      expectAnswer(moved(swapped(named), turn, by), true);
    }
  }
}

TEST(TimeToCollision, DoesNotDependOnTheOrigin) {
  for (const Vec2& by : {Vec2{1e6, -1e6}, Vec2{0x1p20, 3}, Vec2{-1e8 + 64, 1e8 - 64}})
    for (const NamedCase& named : namedCases()) {
      const NamedCase far = moved(named, Eigen::Matrix2d::Identity(), by);
      const bool turns = far.question.twist.angular != 0;  // its origin then is fast
      if (far.question.twist.linear.norm() <= core::kMaxRate) expectAnswer(far, turns);
    }
}

TEST(TimeToCollision, KeepsTheGuaranteeOnRoundedInputsFarAway) {
  Random random(suiteSeed());
  for (int i = 0; i < 20; ++i) {
    const Eigen::Matrix2d turn = Eigen::Rotation2Dd(random.angle()).toRotationMatrix();
    const Vec2 by = 1e6 * random.direction();
    for (const NamedCase& named : namedCases()) {
      const NamedCase far = moved(named, turn, by);
      SCOPED_TRACE(far.name);
      expectGuarantee(far.question);
    }
  }
}

}  // namespace
}  // namespace footprint_collision_predictor::test
