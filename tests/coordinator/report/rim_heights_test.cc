#include "coordinator/report/rim_heights.h"

#include <gtest/gtest.h>

namespace tilemend {
namespace {

using Json = nlohmann::ordered_json;

Plan ThreeVertices() {
  Plan plan;
  plan.vertices.resize(3);
  plan.vertices[0].position = {0, 0, 1.2504};
  plan.vertices[1].position = {4, 0, -2};
  plan.vertices[2].position = {4, 4, 9};
  return plan;
}

// The last one is new.
Plan WithNewVertex() {
  Plan plan = ThreeVertices();
  plan.vertices[0].index = 5;
  plan.vertices[1].index = 0;
  return plan;
}

TEST(RimHeightTest, IsTheMeanOfTheBoundary) {
  PlannedHole hole;
  hole.segments = {{0, 1, false}, {1, 2, true}, {2, 0, true}};
  EXPECT_NEAR(RimHeight(ThreeVertices(), hole), (1.2504 - 2 + 9) / 3, 1e-12) << "of new vertices alone";
  EXPECT_NEAR(RimHeight(WithNewVertex(), hole), (1.2504 - 2) / 2, 1e-12);
}

TEST(RimHeightsJsonTest, IsTheRangeOfTheOriginalVertices) {
  PlannedHole hole;
  hole.segments = {{0, 1, false}, {1, 2, true}, {2, 0, true}};
  EXPECT_EQ(RimHeightsJson(WithNewVertex(), hole), Json({-2, 1.25}));
  hole.segments = {{0, 1, false}, {1, 2, false}, {2, 0, false}};  // along a tile's own outline
  EXPECT_EQ(RimHeightsJson(WithNewVertex(), hole), Json({-2, 1.25}));
}

TEST(RimHeightsJsonTest, HasTheRegionsThatTilesFillForThemselves) {
  PlannedHole hole;
  hole.segments = {{0, 2, false}, {2, 0, true}};
  EXPECT_EQ(RimHeightsJson(WithNewVertex(), hole), Json({1.25, 1.25}));
  hole.own_regions = {{{1, 2, false}, {2, 1, true}}};
  EXPECT_EQ(RimHeightsJson(WithNewVertex(), hole), Json({-2, 1.25}));
}

TEST(RimHeightsJsonTest, IsNotKnownOfSeamsAlone) {
  PlannedHole hole;
  hole.segments = {{0, 1, true}, {1, 2, true}, {2, 0, true}};
  EXPECT_TRUE(RimHeightsJson(ThreeVertices(), hole).is_null());
}

}  // namespace
}  // namespace tilemend
