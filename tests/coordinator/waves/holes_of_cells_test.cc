#include "coordinator/waves/holes_of_cells.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::Pair;

PlannedHole HoleIn(CellId cell, int32_t cluster, int32_t layer = 1) {
  PlannedHole hole;
  hole.cell = cell;
  hole.cluster = cluster;
  hole.layer = layer;
  hole.segments.resize(3);
  return hole;
}

// A cluster over two cells, a closed hole beside it, another cluster, and a hole that cannot be filled.
Plan Made() {
  Plan plan;
  plan.holes = {HoleIn({0, 0}, 0), HoleIn({1, 0}, 0, 2), HoleIn({1, 0}, -1), HoleIn({2, 0}, 1), HoleIn({0, 0}, 2)};
  plan.holes[4].failure = "no";
  return plan;
}

TEST(HolesOfCellsTest, AllThatCanBeFilledWithoutAChoice) {
  EXPECT_THAT(HolesToFill(Made(), {}),
              ElementsAre(Pair(CellId{0, 0}, ElementsAre(0)), Pair(CellId{1, 0}, ElementsAre(1, 2)),
                          Pair(CellId{2, 0}, ElementsAre(3))));
}

TEST(HolesOfCellsTest, OfCellsThatAreNotChosenThoseOfClustersThatReachChosenOnes) {
  EXPECT_THAT(HolesToFill(Made(), {{0, 0}}),
              ElementsAre(Pair(CellId{0, 0}, ElementsAre(0)), Pair(CellId{1, 0}, ElementsAre(1))));
}

// The patch of a closed hole may end at a seam of a cluster in the next cell.
TEST(HolesOfCellsTest, ACellAwaitsTheClustersWhoseVerticesItHas) {
  Plan plan = Made();
  plan.vertices.resize(6);  // new ones, but 4
  plan.vertices[4].index = 7;
  plan.vertices[5].follows = 3;
  plan.holes[0].segments = {{0, 1}, {1, 4}};
  plan.holes[1].segments = {{1, 2}};
  plan.holes[2].segments = {{4, 4}};
  plan.holes[3].segments = {{3, 3}};
  const std::map<int32_t, std::vector<int32_t>> clusters = {{0, {0, 1}}, {1, {3}}};
  const auto await = [&] { return CellsThatAwait(plan, HolesToFill(plan, {}), clusters); };
  EXPECT_THAT(await(),
              ElementsAre(Pair(0, ElementsAre(CellId{0, 0}, CellId{1, 0})), Pair(1, ElementsAre(CellId{2, 0}))));
  plan.holes[2].own_regions = {{{4, 5}}};
  EXPECT_THAT(await().at(1), ElementsAre(CellId{1, 0}, CellId{2, 0})) << "it follows a vertex of that cluster";
  plan.holes[2].own_regions.clear();
  plan.holes[3].inner_edges = {{4, 0}};
  EXPECT_THAT(await().at(0), ElementsAre(CellId{0, 0}, CellId{1, 0}, CellId{2, 0}));
}

TEST(HolesOfCellsTest, CountsCellsSegmentsAndLayers) {
  Plan plan = Made();
  EXPECT_THAT(CellsOf(plan, {0, 1, 2}), ElementsAre(CellId{0, 0}, CellId{1, 0}));
  EXPECT_EQ(SegmentsOf(plan, {0, 1}), 6U);
  EXPECT_EQ(LastLayerOf(plan, {0, 1}), 2);
  plan.holes[1].water = 0;
  EXPECT_EQ(LastLayerOf(plan, {0, 1}), 1);
}

}  // namespace
}  // namespace tilemend
