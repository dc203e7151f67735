// Which polygons are refused does not depend on how they lie or where their vertices begin.
#include <gtest/gtest.h>

#include <algorithm>

#include "footprint_collision_predictor/polygon.hpp"

namespace footprint_collision_predictor::core {
namespace {

using Vertices = std::vector<Vec2>;

bool isAccepted(const Vertices& vertices) {
  try {
    const Polygon polygon(vertices);
    return true;
  } catch (const InvalidPolygon&) {
    return false;
  }
}

/// Quarter turns and their mirror images, either winding, every first vertex.
void expectEverywhere(bool accepted, Vertices vertices) {
  for (int i = 0; i < 8; ++i) {
    for (Vec2& v : vertices) v = i == 4 ? Vec2{v.y(), v.x()} : leftNormal(v);
    for (std::size_t j = 0; j < 2 * vertices.size(); ++j) {
      std::rotate(vertices.begin(), vertices.begin() + 1, vertices.end());
      if (j == vertices.size()) std::reverse(vertices.begin(), vertices.end());
      EXPECT_EQ(isAccepted(vertices), accepted) << "orientation " << i << ", order " << j;
    }
  }
}

TEST(PolygonOrientation, SimpleShapesAreAcceptedEverywhere) {
  expectEverywhere(true, {{0, 0}, {4, 0}, {4, 3}});
  expectEverywhere(true, {{0, 0}, {2, 0}, {4, 0}, {4, 3}});  // a vertex on a straight line
  // Two edges on one line, apart: the arms of a U; and of different length.
  expectEverywhere(true, {{0, 0}, {5, 0}, {5, 2}, {4, 2}, {4, 1}, {1, 1}, {1, 2}, {0, 2}});
  expectEverywhere(true, {{0, 0}, {5, 0}, {5, 2}, {4, 2}, {4, 1}, {1, 1}, {1, 3}, {0, 3}});
}

TEST(PolygonOrientation, CrossingAndTouchingShapesAreRefusedEverywhere) {
  expectEverywhere(false, {{0, 0}, {2, 2}, {2, 0}, {0, 2}});                  // crosses itself
  expectEverywhere(false, {{0, 0}, {4, 0}, {4, 2}, {2, 0}, {0, 2}});          // a vertex on an edge
  expectEverywhere(false, {{0, 0}, {2, 1}, {4, 0}, {4, 3}, {2, 1}, {0, 3}});  // a vertex twice
  expectEverywhere(false, {{0, 0}, {4, 0}, {4, 3}, {4, 1}, {0, 1}});          // a spike
  expectEverywhere(false, {{0, 0}, {1, 1}, {2, 2}, {3, 3}});                  // a line
}

}  // namespace
}  // namespace footprint_collision_predictor::core
