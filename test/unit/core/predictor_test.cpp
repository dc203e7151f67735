// Which segment is touched first, by which obstacle, and when.
#include "footprint_collision_predictor/predictor.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <string>

#include "random.hpp"

namespace footprint_collision_predictor::core {
namespace {

using Vertices = std::vector<Vec2>;

// Segments: 0 below, 1 in front, 2 above, 3 behind.
const Vertices kBox{{-1, -0.5}, {1, -0.5}, {1, 0.5}, {-1, 0.5}};
// A foot 3 x 1 and a stem 1 x 2: segments 2 and 3 are the notch.
const Vertices kL{{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}};

Obstacle moving(const Vec2& position, const Vec2& velocity, double radius) {
  return {{position, velocity, {0, 0}}, radius};
}

Prediction predicted(const Vertices& vertices, const std::vector<Obstacle>& obstacles,
                     double horizon = 10) {
  return predict(Polygon(vertices), {}, obstacles, horizon);
}

void expectFirst(const Prediction& p, double time, std::size_t segment, std::size_t obstacle) {
  ASSERT_TRUE(p.first);
  EXPECT_NEAR(p.first->contact.time, time, 1e-9);
  EXPECT_EQ(p.first->segment, segment);
  EXPECT_EQ(p.first->obstacle, obstacle);
}

std::vector<std::size_t> touchedSegments(const Prediction& p) {
  std::vector<std::size_t> touched;
  for (std::size_t i = 0; i < p.segments.size(); ++i)
    if (p.segments[i]) touched.push_back(i);
  return touched;
}

TEST(Predict, EverySegmentHasItsOwnContact) {
  // 5 - 1 - 0.25 to the front; it goes on through the body and meets the back from inside.
  const Prediction p = predicted(kBox, {moving({5, 0}, {-1, 0}, 0.25)});
  expectFirst(p, 3.75, 1, 0);
  EXPECT_EQ(p.first->contact.feature, Feature::kInside);
  EXPECT_EQ(p.first->contact.point, Vec2(1, 0));
  EXPECT_EQ(touchedSegments(p), (std::vector<std::size_t>{1, 3}));
  EXPECT_NEAR(p.segments[1]->contact.time, 3.75, 1e-9);
  EXPECT_NEAR(p.segments[3]->contact.time, 5.75, 1e-9);
}

TEST(Predict, AnEndMetSquarelyIsNamed) {
  // 5 - 1 - 0.25 to the front, at the height of its upper end and of its lower one.
  const Polygon box(kBox);
  for (const double y : {0.5, -0.5}) {
    const auto first = firstContact(box, {}, moving({5, y}, {-1, 0}, 0.25), 10);
    ASSERT_TRUE(first);
    EXPECT_NEAR(first->contact.time, 3.75, 1e-9);
    EXPECT_EQ(first->contact.point, Vec2(1, y));
    EXPECT_EQ(first->segment, y > 0 ? 1u : 0u);  // the lower one of the two that meet there
    EXPECT_EQ(first->contact.feature, Feature::kEnd);
  }
}

TEST(Predict, OneThatFallsFromAbove) {
  // 2 m to fall at 1 m/s^2.
  const Obstacle falls({{0, 2.75}, {0, 0}, {0, -1}}, 0.25);
  const auto first = firstContact(Polygon(kBox), {}, falls, 10);
  ASSERT_TRUE(first);
  EXPECT_NEAR(first->contact.time, 2, 1e-9);
  EXPECT_EQ(first->segment, 2u);
  EXPECT_NEAR(first->closing_speed, 2, 1e-9);
}

TEST(Predict, TurningAcceleratingOrGrowingByOneBringsTheContact) {
  // Each of them is out of reach of what goes on as it does now.
  const auto expect = [](const Twist& twist, const Obstacle& obstacle, double time) {
    const Polygon footprint(kBox);
    const auto alone = firstContact(footprint, twist, obstacle, 10);
    const auto in_batch = firstContact(footprint, twist, ObstacleBatch({obstacle}), 10);
    ASSERT_TRUE(alone && in_batch);
    EXPECT_NEAR(alone->contact.time, time, 1e-8);
    EXPECT_EQ(in_batch->contact.time, alone->contact.time);
  };
  // Round (0, 1), from which the front reaches a post 1.5 m off with its point at (1, 1 -
  // sqrt(1.25)).
  expect({{1, 0}, 1}, {{{0, 2.5}, {0, 0}, {0, 0}}, 0}, M_PI / 2 + std::atan(std::sqrt(1.25)));
  expect({}, {{{-4, 0}, {0, 0}, {1, 0}}, 0.25}, std::sqrt(5.5));   // 2.75 m
  expect({}, {{{0, -3.25}, {0, 0}, {0, 1}}, 0.25}, std::sqrt(5));  // 2.5 m
  expect({}, {{{4, 0}, {0, 0}, {0, 0}}, 0.5, 1}, 2.5);
}

TEST(Predict, WithoutObstaclesNothingIsKnownToTouch) {
  const Prediction p = predicted(kBox, {});
  EXPECT_FALSE(p.first);
  EXPECT_FALSE(p.clearance);
  EXPECT_EQ(p.segments.size(), 4u);
  EXPECT_TRUE(touchedSegments(p).empty());
}

TEST(Predict, TheFootprintIsSolid) {
  const Prediction still = predicted(kBox, {moving({0.8, 0}, {0, 0}, 0.05)});
  expectFirst(still, 0, 1, 0);
  EXPECT_EQ(still.first->contact.point, Vec2(1, 0));
  EXPECT_TRUE(touchedSegments(still).empty());  // no segment is touched, and none says so
  const Prediction leaving = predicted(kBox, {moving({0.8, 0}, {-1, 0}, 0.05)});
  expectFirst(leaving, 0, 1, 0);
  EXPECT_EQ(touchedSegments(leaving), (std::vector<std::size_t>{3}));
  EXPECT_NEAR(leaving.segments[3]->contact.time, 1.75, 1e-9);  // 0.8 + 1 - 0.05
}

TEST(Predict, AnObstacleInsideComesBeforeALaterOneOutside) {
  const Prediction p =
      predicted(kBox, {moving({5, 0}, {-1, 0}, 0.25), moving({0, 0.4}, {0, 0}, 0.05)});
  expectFirst(p, 0, 2, 1);
}

TEST(Predict, TheNotchOfAConcaveFootprintIsOutside) {
  EXPECT_FALSE(predicted(kL, {moving({2, 2}, {0, 0}, 0.5)}).first);
  expectFirst(predicted(kL, {moving({2, 2}, {-1, 0}, 0.5)}), 0.5, 3, 0);
  expectFirst(predicted(kL, {moving({2, 2}, {0, -1}, 0.5)}), 0.5, 2, 0);
  // Into the inner corner, both sides at once: the lower one is named.
  expectFirst(predicted(kL, {moving({2, 2}, {-1, -1}, 0.5)}), 0.5, 2, 0);
}

TEST(Predict, ACornerNamesTheLowerSegment) {
  const Prediction two = predicted(kBox, {moving({7, 8.5}, {-3, -4}, 5)});
  expectFirst(two, 1, 1, 0);
  EXPECT_EQ(two.first->contact.feature, Feature::kEnd);
  EXPECT_EQ(two.first->contact.point, Vec2(1, 0.5));
  const Prediction zero = predicted(kBox, {moving({-7, -8.5}, {3, 4}, 5)});
  expectFirst(zero, 1, 0, 0);
  EXPECT_EQ(zero.first->contact.feature, Feature::kStart);
  EXPECT_EQ(zero.first->contact.point, Vec2(-1, -0.5));
}

TEST(Predict, ACornerNamesTheLowerSegmentFromEveryDirection) {
  const Vec2 outwards[] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  const std::size_t lower[] = {0, 0, 1, 2};
  for (std::uint64_t i = 0; i < 20000; ++i) {
    test::Random random(1, i);
    SCOPED_TRACE("Random(1, " + std::to_string(i) + ")");
    Eigen::Matrix2d turn = Eigen::Rotation2Dd(random.angle()).toRotationMatrix();
    if (random.chance(0.3)) turn.setIdentity();
    Vertices box;
    for (const Vec2& v : kBox) box.push_back(turn * v);
    const std::size_t k = i % 4;
    const Vec2 slant{random.uniform(0.1, 1), random.uniform(0.1, 1)};
    const Vec2 way = turn * outwards[k].cwiseProduct(slant.normalized());
    const double radius = random.uniform(0, 2);
    const double gap = random.chance(0.2) ? -0.5 * radius : random.uniform(1, 5);
    const Vec2 a = random.chance(0.5) ? Vec2{0, 0} : Vec2{-0.5 * way};
    const Obstacle o({box[k] + (radius + gap) * way, -random.uniform(1, 5) * way, a}, radius);
    const Prediction p = predicted(box, {o});
    ASSERT_TRUE(p.first);
    ASSERT_EQ(p.first->segment, lower[k]);
    ASSERT_EQ(p.first->contact.point, box[k]);
    ASSERT_EQ(p.first->contact.feature, k == 0 ? Feature::kStart : Feature::kEnd);
  }
}

TEST(Predict, TheEarliestOfSeveralObstaclesIsNamed) {
  const Obstacle front = moving({5, 0}, {-1, 0}, 0.5);   // 3.5 s
  const Obstacle above = moving({0, 3}, {0, -1}, 0.5);   // 2 s
  const Obstacle behind = moving({-4, 0}, {1, 0}, 0.5);  // 2.5 s
  const Obstacle never = moving({9, 9}, {1, 1}, 0.5);
  const Prediction p = predicted(kBox, {never, front, above, behind});
  expectFirst(p, 2, 2, 2);
  EXPECT_EQ(p.segments[1]->obstacle, 1u);
  EXPECT_EQ(p.segments[2]->obstacle, 2u);
  EXPECT_EQ(p.segments[3]->obstacle, 3u);
}

TEST(Predict, AmongEqualTimesTheSmallerGapThenTheLowerIndexIsNamed) {
  const Obstacle twin = moving({5, 0}, {-1, 0}, 0.5);
  expectFirst(predicted(kBox, {twin, twin}), 3.5, 1, 0);
  const Obstacle shallow = moving({1.25, 0}, {0, 0}, 0.5);
  const Obstacle deep = moving({1.125, 0}, {0, 0}, 0.5);
  const Prediction last = predicted(kBox, {shallow, deep});
  expectFirst(last, 0, 1, 1);
  EXPECT_EQ(last.segments[1]->obstacle, 1u);
  const Prediction first = predicted(kBox, {deep, shallow});
  expectFirst(first, 0, 1, 0);
  EXPECT_EQ(first.segments[1]->obstacle, 0u);
}

TEST(Predict, AFootprintThatMovesIsAnObstacleThatMoves) {
  const Prediction driving = predict(Polygon(kBox), {{1, 0}, 0}, {moving({5, 0}, {0, 0}, 0.5)}, 10);
  expectFirst(driving, 3.5, 1, 0);
  const Prediction meeting =
      predict(Polygon(kBox), {{1, 0.5}, 0}, {moving({5, 0}, {-0.75, 0.5}, 0.5)}, 10);
  expectFirst(meeting, 2, 1, 0);
  EXPECT_FALSE(predict(Polygon(kBox), {{-1, 0}, 0}, {moving({5, 0}, {-1, 0}, 0.5)}, 10).first);
}

TEST(Predict, NumbersTheSegmentsAsTheUserDidInEitherWinding) {
  const Vertices clockwise(kBox.rbegin(), kBox.rend());  // 0 above, 1 in front, 2 below, 3 behind
  const Obstacle above = moving({0, 3}, {0, -1}, 0.5);
  const Obstacle inside = moving({0, 0.4}, {0, 0}, 0.05);
  expectFirst(predicted(kBox, {above}), 2, 2, 0);
  expectFirst(predicted(clockwise, {above}), 2, 0, 0);
  expectFirst(predicted(kBox, {inside}), 0, 2, 0);
  expectFirst(predicted(clockwise, {inside}), 0, 0, 0);
}

TEST(Predict, TheHorizonIsIncluded) {
  const Obstacle front = moving({5, 0}, {-1, 0}, 0.5);
  expectFirst(predicted(kBox, {front}, 3.5), 3.5, 1, 0);
  EXPECT_FALSE(predicted(kBox, {front}, 3.499999).first);
}

TEST(Predict, HorizonZeroReportsOnlyWhatTouchesNow) {
  EXPECT_FALSE(predicted(kBox, {moving({1.75, 0}, {-9, 0}, 0.5)}, 0).first);
  expectFirst(predicted(kBox, {moving({1.5, 0}, {9, 0}, 0.5)}, 0), 0, 1, 0);
  expectFirst(predicted(kBox, {moving({0, 0.25}, {0, 0}, 0.125)}, 0), 0, 2, 0);
}

TEST(Predict, FarFromTheOriginNothingChanges) {
  const Vec2 far{1e6, -1e6};
  Vertices vertices = kBox;
  for (Vec2& v : vertices) v += far;
  const Prediction p = predicted(vertices, {moving(far + Vec2{5, 0}, {-1, 0}, 0.25)});
  expectFirst(p, 3.75, 1, 0);
  EXPECT_LE((p.first->contact.point - far - Vec2{1, 0}).norm(), 1e-9);
  EXPECT_NEAR(*p.clearance, 3.75, 1e-9);
  EXPECT_NEAR(p.segments[3]->contact.time, 5.75, 1e-9);
}

}  // namespace
}  // namespace footprint_collision_predictor::core
