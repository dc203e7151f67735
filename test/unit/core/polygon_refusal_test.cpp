// Every refusal of a footprint names the rule that is broken and the vertices that break it.
#include <gtest/gtest.h>

#include <limits>
#include <regex>

#include "footprint_collision_predictor/polygon.hpp"

namespace footprint_collision_predictor::core {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();

std::string refusalOf(const std::vector<Vec2>& vertices) {
  try {
    const Polygon accepted(vertices);
  } catch (const InvalidPolygon& e) {
    return e.what();
  }
  return "(accepted)";
}

/// The refusal holds the rule's word, and every one of the numbers as a number of its own.
void expectRefusal(const std::vector<Vec2>& vertices, const std::string& rule,
                   const std::vector<int>& numbers) {
  const std::string text = refusalOf(vertices);
  EXPECT_TRUE(std::regex_search(text, std::regex(rule))) << text << "\ndoes not say: " << rule;
  for (const int n : numbers)
    EXPECT_TRUE(std::regex_search(text, std::regex("\\b" + std::to_string(n) + "\\b")))
        << text << "\ndoes not name " << n;
}

TEST(PolygonRefusal, Fault03FewerThanThreeVertices) {
  expectRefusal({}, "vertices", {0, 3});
  expectRefusal({{0, 0}, {1, 0}}, "vertices", {2, 3});
}

TEST(PolygonRefusal, Fault01NotFinite) {
  expectRefusal({{0, 0}, {kNan, 0}, {1, 1}}, "finite", {1});
  expectRefusal({{0, 0}, {1, 0}, {1, kNan}}, "finite", {2});
  expectRefusal({{0, 0}, {1, 0}, {1, kInf}}, "finite", {2});
  expectRefusal({{-kInf, 0}, {1, 0}, {1, 1}}, "finite", {0});
}

TEST(PolygonRefusal, Fault06CoordinatesBeyondTheLimit) {
  expectRefusal({{0, 0}, {1, 0}, {1, 1.1e8}}, "1e\\+?0?8|100000000", {2});
  expectRefusal({{0, 0}, {-1.1e8, 0}, {1, 1}}, "1e\\+?0?8|100000000", {1});
}

TEST(PolygonRefusal, Fault06TooLarge) {
  expectRefusal({{0, 0}, {10001, 0}, {0, 1}}, "1e\\+?0?4|10000\\b", {});
  expectRefusal({{0, -6000}, {1, 0}, {0, 6000}}, "1e\\+?0?4|10000\\b", {});
  expectRefusal({{0, 0}, {-10001, 0}, {0, 1}}, "10001", {});  // where only the smallest tells
  expectRefusal({{-10001, 0}, {0, 0}, {-1, 1}}, "10001", {});
  expectRefusal({{1, 0}, {0, 1}, {0, -10000}}, "10001", {});
}

TEST(PolygonRefusal, Fault03EqualNeighbours) {
  expectRefusal({{0, 0}, {1, 0}, {1, 0}, {1, 1}}, "equal|same|repeat", {1, 2});
  expectRefusal({{0, 0}, {0, 0}, {1, 0}, {1, 1}}, "equal|same|repeat", {0, 1});
  EXPECT_EQ(refusalOf({{0, 0}, {0, 0}, {1, 0}}).find("leave it out"), std::string::npos);
  EXPECT_EQ(refusalOf({{0, 0}, {1, 0}, {1, 0}, {1, 1}}).find("leave it out"), std::string::npos);
}

TEST(PolygonRefusal, LastEqualsFirst) {
  expectRefusal({{0, 0}, {1, 0}, {1, 1}, {0, 0}}, "(equal|same|repeat).*leave it out", {0, 3});
}

TEST(PolygonRefusal, Fault03CrossingEdges) {
  expectRefusal({{0, 0}, {2, 2}, {2, 0}, {0, 2}},
                "segments 0 and 2 cross.*vertex 0 \\(0, 0\\) and vertex 2 \\(2, 0\\)", {});
  expectRefusal({{0, 0}, {4, 0}, {4, 4}, {2, -1}, {0, 4}}, "cross", {0, 2});
}

TEST(PolygonRefusal, TouchingEdges) {
  // Vertex 3 lies on edge 0; then two vertices in one place; then edges upon each other.
  expectRefusal({{0, 0}, {4, 0}, {4, 2}, {2, 0}, {0, 2}}, "touch", {0});
  expectRefusal({{0, 0}, {2, 1}, {4, 0}, {4, 3}, {2, 1}, {0, 3}}, "touch", {});
  expectRefusal({{0, 0}, {4, 0}, {4, 2}, {3, 2}, {3, 0}, {1, 0}, {1, 2}, {0, 2}}, "touch", {0});
}

TEST(PolygonRefusal, ASpike) {
  // Edge 2 runs back along edge 1.
  expectRefusal({{0, 0}, {4, 0}, {4, 3}, {4, 1}, {0, 1}}, "touch|back|overlap|spike", {1, 2});
  expectRefusal({{0, 0}, {4, 0}, {4, 3}, {4, 2.75}, {0, 1}},
                "segments 1 and 2 fold back.*at vertex 2 \\(4, 3\\)", {});
  // Edge 0 runs back along edge 4.
  expectRefusal({{1, 0}, {4, 0}, {4, 3}, {6, 3}, {6, 0}}, "touch|back|overlap|spike", {4});
}

// Once accepted: a spike that is open only by less than the smallest normal number.
TEST(PolygonRefusal, ASpikeOpenByADenormal) {
  constexpr double kTiny = -std::numeric_limits<double>::denorm_min();
  expectRefusal({{-2.6875, 2 * kTiny},
                 {4 * kTiny, 6 * kTiny},
                 {8 * kTiny, 10 * kTiny},
                 {12 * kTiny, 14 * kTiny},
                 {16 * kTiny, -0x1p-43},
                 {18 * kTiny, -43},
                 {20 * kTiny, 22 * kTiny},
                 {24 * kTiny, 24 * kTiny}},
                "touch|back", {});
}

TEST(PolygonRefusal, Fault03NoArea) {
  expectRefusal({{0, 0}, {1, 0}, {2, 0}}, "no area", {});
  expectRefusal({{0, 0}, {1, 1}, {2, 2}, {3, 3}}, "no area", {});
  expectRefusal({{1, 1}, {3, 3}, {2, 2}}, "no area", {});
  expectRefusal({{-2, 5}, {-1, 5}, {-3, 5}, {-2.5, 5}}, "no area", {});
}

}  // namespace
}  // namespace footprint_collision_predictor::core
