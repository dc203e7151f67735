// What RViz is told to show: the right look for each time, at the right place, with nothing left
// over.
#include "markers.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "marker_shapes.hpp"
#include "marker_style.hpp"
#include "pipeline_fixture.hpp"

namespace footprint_collision_predictor {
namespace {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;
using Warning = CollisionWarning;

constexpr core::Thresholds kThresholds{3, 1.5};
constexpr double kHorizon = 5;

/// A warning and what belongs to it, as the pipeline would have them.
struct Drawn {
  explicit Drawn(const std::vector<core::Obstacle>& obstacles = {}, const core::Twist& twist = {},
                 const core::Polygon& polygon = squareOfOneMetre())
      : footprint(polygon), picture{warning,
                                    kThresholds,
                                    &footprint,
                                    twist,
                                    obstacles,
                                    core::predict(footprint, twist, obstacles, kHorizon)} {
    warning.header.frame_id = "base_link";
    warning.footprint = "footprint";
    warning.level = Warning::CLEAR;
    warning.horizon = kHorizon;
  }
  Drawn(const Drawn&) = delete;

  Warning warning;
  core::Polygon footprint;
  Picture picture;
};

core::Obstacle circle(const core::Vec2& at, const core::Vec2& velocity, double radius = 0.5) {
  return core::Obstacle({at, velocity, {0, 0}}, radius);
}

const Marker& find(const MarkerArray& array, const std::string& content, int id) {
  const auto found = std::find_if(
      array.markers.begin(), array.markers.end(),
      [&](const Marker& marker) { return marker.ns == "footprint/" + content && marker.id == id; });
  if (found == array.markers.end()) throw std::out_of_range(content + std::to_string(id));
  return *found;
}

const Marker& find(const MarkerArray& array, const std::string& content, Outlook outlook) {
  return find(array, content, static_cast<int>(outlook));
}

/// Ids of those with something to show.
std::set<int> shown(const MarkerArray& array, const std::string& content) {
  std::set<int> ids;
  for (const Marker& marker : array.markers)
    if (marker.ns == "footprint/" + content && marker.action == Marker::ADD) ids.insert(marker.id);
  return ids;
}

std::set<int> only(Outlook outlook) { return {static_cast<int>(outlook)}; }

core::Vec2 xy(const geometry_msgs::Point& p) { return {p.x, p.y}; }

/// For whatever is drawn.
void expectSound(const MarkerArray& array) {
  for (const Marker& m : array.markers) {
    SCOPED_TRACE(m.ns + " " + std::to_string(m.id));
    EXPECT_EQ(m.header.frame_id, "base_link");
    EXPECT_TRUE(m.header.stamp.isZero());
    EXPECT_EQ(m.lifetime, ros::Duration(1));
    EXPECT_EQ(m.pose.orientation.w, 1);
    EXPECT_TRUE(m.action == Marker::ADD || m.action == Marker::DELETE);
    EXPECT_EQ(m.action == Marker::ADD, !m.points.empty() || !m.text.empty());
    if (m.action == Marker::DELETE) continue;
    EXPECT_GT(m.color.a, 0);
    EXPECT_GT(std::max(m.scale.x, m.scale.z), 0);
    for (const double value :
         {m.scale.x, m.scale.y, m.scale.z, m.pose.position.x, m.pose.position.y, m.pose.position.z})
      EXPECT_TRUE(std::isfinite(value));
    for (const auto& p : m.points)
      ASSERT_TRUE(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
  }
}

TEST(Markers, AlwaysTheSameOnesSoThatNothingFlickersOrIsLeftOver) {
  Drawn nothing, contact({circle({2, 0}, {-1, 0}), circle({0, 9}, {0, 0})}), unknown;
  unknown.warning.level = Warning::UNKNOWN;
  unknown.picture.footprint = nullptr;
  unknown.picture.prediction = {};
  std::set<std::tuple<std::string, int, int>> known;
  for (const Drawn* drawn : {&nothing, &contact, &unknown}) {
    const MarkerArray array = markers(drawn->picture);
    expectSound(array);
    std::set<std::tuple<std::string, int, int>> here;
    for (const Marker& m : array.markers) here.insert({m.ns, m.id, m.type});
    EXPECT_EQ(here.size(), array.markers.size()) << "two of one name";
    if (!known.empty()) {
      EXPECT_EQ(here, known);
    }
    known = here;
  }
}

TEST(Markers, ASegmentLooksLikeItsTime) {
  // The front (segment 3, from (0.5, -0.5) to (0.5, 0.5)) is touched after distance / speed.
  const std::pair<double, Outlook> cases[] = {{0.0, Outlook::kCritical}, {1.5, Outlook::kCritical},
                                              {1.501, Outlook::kWarn},   {3.0, Outlook::kWarn},
                                              {3.001, Outlook::kLater},  {5.0, Outlook::kLater},
                                              {5.001, Outlook::kFree}};
  for (const auto& [time, look] : cases) {
    const Drawn drawn({circle({1.0 + time, 0}, {-1, 0}, 0.5)});
    const MarkerArray array = markers(drawn.picture);
    const Marker& lines = find(array, "footprint", look);
    const bool found = std::any_of(lines.points.begin(), lines.points.end(),
                                   [](const auto& p) { return p.x == 0.5 && p.y < 0; });
    EXPECT_TRUE(found) << time;
    const auto obstacle = shown(array, "obstacles");
    EXPECT_EQ(obstacle, only(look == Outlook::kFree ? Outlook::kIrrelevant : look)) << time;
    EXPECT_EQ(shown(array, "obstacles_fill"), obstacle) << time;
  }
}

TEST(Markers, WithoutCertaintyNothingLooksFree) {
  Drawn drawn({circle({2, 0}, {-0.25, 0}), circle({0, 9}, {0, 0})});
  drawn.warning.reason = Warning::REASON_OBSTACLES_INVALID;
  const MarkerArray array = markers(drawn.picture);
  const std::set<int> looks = shown(array, "footprint");
  EXPECT_EQ(looks.count(static_cast<int>(Outlook::kFree)), 0u);
  EXPECT_EQ(looks.count(static_cast<int>(Outlook::kLater)), 1u);
  EXPECT_EQ(looks.count(static_cast<int>(Outlook::kUnknown)), 1u);
  EXPECT_EQ(shown(array, "obstacles").count(static_cast<int>(Outlook::kIrrelevant)), 0u);
}

TEST(Markers, ALevelThatIsStillHeldIsNoUncertainty) {
  Drawn drawn;
  drawn.warning.level = Warning::UNKNOWN;
  drawn.warning.reason = Warning::REASON_SETTLING;
  EXPECT_EQ(shown(markers(drawn.picture), "footprint"), only(Outlook::kFree));
}

TEST(Markers, WhatIsNotEvaluatedLooksUnknown) {
  Drawn drawn;
  drawn.warning.level = Warning::UNKNOWN;
  drawn.picture.prediction = {};
  EXPECT_EQ(shown(markers(drawn.picture), "footprint"), only(Outlook::kUnknown));
}

TEST(Markers, AnObstacleInsideTouchesTheSolidFootprint) {
  const Drawn drawn({circle({0.2, 0}, {0, 0}, 0.1)});
  const MarkerArray array = markers(drawn.picture);
  EXPECT_EQ(shown(array, "footprint").count(static_cast<int>(Outlook::kCritical)), 1u);
  EXPECT_EQ(shown(array, "obstacles"), only(Outlook::kCritical));
}

TEST(Markers, LooksDifferInWidthAndDashesNotInColourAlone) {
  for (std::size_t i = 0; i < kOutlooks; ++i)
    for (std::size_t j = i + 1; j < kOutlooks; ++j) {
      const Style& a = styleOf(static_cast<Outlook>(i));
      const Style& b = styleOf(static_cast<Outlook>(j));
      EXPECT_GE(b.width, 1.15 * a.width) << "the worse is wider: " << i << " " << j;
    }
  EXPECT_GT(styleOf(Outlook::kWarn).dash, 0);
  EXPECT_GT(styleOf(Outlook::kUnknown).dash, 0);
  EXPECT_EQ(styleOf(Outlook::kFree).dash, 0);
  EXPECT_EQ(styleOf(Outlook::kCritical).dash, 0);
}

TEST(Markers, GhostsAreWhereTheContactIs) {
  // The front, at 0.5 + t, meets the circle's rear, at 4.5 - 0.5 - t, at t = 1.75.
  const Drawn drawn({circle({4.5, 0.2}, {-1, 0})}, {{1, 0}, 0});
  const MarkerArray array = markers(drawn.picture);
  double front = -100, rear = 100;
  for (const auto& p : find(array, "ghosts", 0).points) {
    const bool of_circle = std::abs((xy(p) - core::Vec2(2.75, 0.2)).norm() - 0.5) < 0.01;
    if (of_circle) rear = std::min(rear, p.x);
    if (!of_circle) front = std::max(front, p.x);
  }
  EXPECT_NEAR(front, 2.25, 1e-9);
  EXPECT_NEAR(rear, 2.25, 0.01);  // chords lie inside of their circle
  const auto& contact = find(array, "contact", 0).points;
  ASSERT_EQ(contact.size(), 2u);
  EXPECT_LT((xy(contact[0]) - core::Vec2(2.25, 0.2)).norm(), 1e-9) << "then";
  EXPECT_LT((xy(contact[1]) - core::Vec2(0.5, 0.2)).norm(), 1e-9) << "on the body now";
}

TEST(Markers, AFootprintThatStandsHasNoGhostOfItsOwn) {
  const Drawn drawn({circle({4.5, 0}, {-1, 0})});
  const MarkerArray array = markers(drawn.picture);
  for (const auto& p : find(array, "ghosts", 0).points)
    EXPECT_NEAR((xy(p) - core::Vec2(1, 0)).norm(), 0.5, 0.01);
}

TEST(Markers, WhatTouchesNowHasNoGhosts) {
  const Drawn drawn({circle({0.9, 0}, {0, 0})});
  const MarkerArray array = markers(drawn.picture);
  EXPECT_EQ(find(array, "ghosts", 0).action, Marker::DELETE);
  ASSERT_EQ(find(array, "contact", 0).points.size(), 1u);
}

TEST(Markers, ArrowsShowASecondOfMotionOverGround) {
  const Drawn drawn({circle({0, 5}, {0.5, 1})}, {{0.6, 0}, 0});
  const MarkerArray array = markers(drawn.picture);
  const auto& points = find(array, "velocities", 0).points;
  ASSERT_EQ(points.size(), 12u);  // for each a shaft and two lines of the head
  EXPECT_EQ(xy(points[0]), core::Vec2(0, 5));
  EXPECT_EQ(xy(points[1]), core::Vec2(0.5, 6));
  EXPECT_EQ(xy(points[6]), core::Vec2(0, 0));
  EXPECT_EQ(xy(points[7]), core::Vec2(0.6, 0));
  const Drawn still({circle({0, 5}, {0, 0})});
  EXPECT_EQ(find(markers(still.picture), "velocities", 0).action, Marker::DELETE);
}

TEST(Markers, NothingBeyondTheRangeOfAPictureMakesANumberInfinite) {
  const Drawn drawn({core::Obstacle({{1e8, -1e8}, {1e6, -1e6}, {-1e6, 1e6}}, 1e6),
                     core::Obstacle({{-1e8, 1e8}, {0, 0}, {0, 0}}, 0)},
                    {{1e6, 1e6}, 0});
  Warning& warning = const_cast<Drawn&>(drawn).warning;
  warning.time_to_collision = warning.clearance = std::nan("");
  const MarkerArray array = markers(drawn.picture);
  expectSound(array);
  std::size_t points = 0;
  for (const Marker& m : array.markers) points += m.points.size();
  EXPECT_LT(points, 2000u) << "of so large a circle there would be millions of dashes";
}

TEST(Markers, OfManyObstaclesThoseThatMatterAndTheNearestAreDrawn) {
  std::vector<core::Obstacle> obstacles;
  for (int i = 0; i < 700; ++i) obstacles.push_back(circle({0, 700.0 - i}, {0, 0}, 0.1));
  obstacles.push_back(circle({1400, 0}, {-1000, 0}, 0.1));  // arrives after 1.4 s
  const Drawn drawn(obstacles);
  const MarkerArray array = markers(drawn.picture);
  EXPECT_EQ(find(array, "obstacles", Outlook::kCritical).action, Marker::ADD);
  double farthest = 0;
  for (const auto& p : find(array, "obstacles", Outlook::kIrrelevant).points)
    farthest = std::max(farthest, p.y);
  EXPECT_NEAR(farthest, 199 + 0.1, 0.01);
  EXPECT_NE(find(array, "text", 0).text.find("(501 obstacles are not drawn)"), std::string::npos);
}

TEST(Markers, OneLineOfText) {
  Drawn drawn;
  Warning& w = drawn.warning;
  const auto text = [&] { return find(markers(drawn.picture), "text", 0).text; };
  EXPECT_EQ(text(), "CLEAR: nothing within 5.0 s");
  w.level = Warning::WARN;
  w.collision_predicted = 1;
  w.time_to_collision = 2.345;
  w.segment = 3;
  w.obstacle_id = 7;
  EXPECT_EQ(text(), "WARN: contact in 2.35 s, segment 3, obstacle 7");
  w.level = Warning::CRITICAL;
  w.time_to_collision = 0;
  w.obstacle_id = -1;
  EXPECT_EQ(text(), "CRITICAL: contact now, segment 3");
  w = Warning();
  w.footprint = "footprint";
  w.message = "no odometry has come on /odom";
  EXPECT_EQ(text(), "UNKNOWN: no odometry has come on /odom");
  for (int i = 0; i < 20; ++i) w.message += ", and so on";
  EXPECT_LT(text().size(), 100u);
  EXPECT_EQ(text().substr(text().size() - 6), "so ...");
}

TEST(Markers, TheTextHasTheLevelsColour) {
  Drawn drawn;
  drawn.warning.level = Warning::CRITICAL;
  EXPECT_EQ(find(markers(drawn.picture), "text", 0).color, colourOf(Outlook::kCritical));
  drawn.warning.level = Warning::UNKNOWN;
  EXPECT_EQ(find(markers(drawn.picture), "text", 0).color, colourOf(Outlook::kUnknown));
}

class PipelinePicture : public PipelineFixture {
 protected:
  MarkerArray pictureAt(double now) {
    const Warning repeated = pipeline().repeat(at(now));
    return pipeline().picture(repeated, at(now));
  }
};

TEST_F(PipelinePicture, ShowsTheSceneCarriedOnToNow) {
  send(100, {circleAhead(5, 1)});
  const Marker now = find(pictureAt(100.4), "obstacles", Outlook::kLater);
  double nearest = 100;
  for (const auto& p : now.points) nearest = std::min(nearest, p.x);
  EXPECT_NEAR(nearest, 5 - 0.4 - 0.5, 0.03);
}

TEST_F(PipelinePicture, OldDataAreNoLongerShown) {
  send(100, {circleAhead(2, 1)});
  EXPECT_EQ(shown(pictureAt(100.5), "obstacles"), only(Outlook::kCritical));
  const MarkerArray old = pictureAt(100.6);
  EXPECT_TRUE(shown(old, "obstacles").empty());
  EXPECT_TRUE(shown(old, "ghosts").empty());
  EXPECT_EQ(shown(old, "footprint"), only(Outlook::kUnknown));
  EXPECT_EQ(find(old, "text", 0).text.substr(0, 8), "UNKNOWN:");
}

TEST_F(PipelinePicture, BeforeAnythingHasComeThereIsAText) {
  parameters.footprint.reset();
  const MarkerArray array = pictureAt(100);
  expectSound(array);
  EXPECT_TRUE(shown(array, "footprint").empty());
  EXPECT_EQ(shown(array, "text"), std::set<int>{0});
}

}  // namespace
}  // namespace footprint_collision_predictor
