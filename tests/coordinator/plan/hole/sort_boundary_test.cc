#include "coordinator/plan/hole/sort_boundary.h"

#include <gtest/gtest.h>

#include <set>

#include "tests/support/rim_builders.h"

namespace tilemend {
namespace {

constexpr CellId kWestCell{0, 0}, kEastCell{1, 0};

// A hole of the western tile over the line x = 10; its edge 2 -> 3 lies on the line.
struct Scene {
  Scene() : rim(RimOf({{{5, 2, 0}, {5, 8, 0}, {10, 8, 0}, {10, 2, 0}}})), closing(OwnersOf(rim)) {}

  CellBoundaries AddLoopOnce() const {
    CellBoundaries boundaries;
    AddLoop(input, lines, rim, closing, rim.loops[0], boundaries);
    return boundaries;
  }

  PlanInput input = CellsOf(AreaOf(2, 1), 10);
  GridLines lines = LinesOf(AreaOf(2, 1), 10);
  Rim rim;
  ClosingCells closing;
};

TEST(AddLoopTest, KeepsALoopWholeThatOneCellOwnsAndClosesOn) {
  const CellBoundaries boundaries = Scene().AddLoopOnce();
  ASSERT_EQ(boundaries.size(), 1U);
  const CellBoundary& west = boundaries.at(kWestCell);
  ASSERT_EQ(west.closed_loops.size(), 1U);
  EXPECT_EQ(west.closed_loops[0].size(), 4U);
  EXPECT_TRUE(west.open.empty());
}

TEST(AddLoopTest, GivesEachEdgeOfAnyOtherToTheCellThatClosesOnIt) {
  Scene scene;
  scene.closing[2] = kEastCell;
  const CellBoundaries boundaries = scene.AddLoopOnce();
  EXPECT_EQ(boundaries.at(kWestCell).open.size(), 3U);
  const std::vector<BoundarySegment>& east = boundaries.at(kEastCell).open;
  ASSERT_EQ(east.size(), 1U);
  EXPECT_EQ(east[0].segment.from, 3) << "against the edge: the hole is on the left";
  EXPECT_EQ(east[0].segment.to, 2);
  EXPECT_EQ(east[0].side, kWest);
  EXPECT_EQ(east[0].across, kWestCell);
}

TEST(AddLoopTest, TakesTheNearerSideTowardsADiagonalNeighbour) {
  Scene scene;
  scene.input = CellsOf(AreaOf(2, 2), 10);
  scene.lines = LinesOf(AreaOf(2, 2), 10);
  scene.closing[1] = {1, 1};  // begins at (5, 8): 2 m off the line to the south, 5 m off that to the west
  const CellBoundaries boundaries = scene.AddLoopOnce();
  EXPECT_EQ(boundaries.at({1, 1}).open.at(0).side, kSouth);
}

TEST(AddLoopTest, DropsEdgesThatNobodyInTheAreaClosesOn) {
  Scene scene;
  scene.closing[0] = {-1, 0};
  const CellBoundaries boundaries = scene.AddLoopOnce();
  EXPECT_EQ(boundaries.size(), 1U);
  EXPECT_EQ(boundaries.at(kWestCell).open.size(), 3U);
}

TEST(AddSeamTest, GivesASeamToBothSidesInOppositeDirections) {
  const Scene scene;
  CellBoundaries boundaries;
  AddSeam(scene.input, scene.rim, RimIndex(scene.rim), {kWestCell, kEastCell, {3, 4, 5, 2}}, boundaries);
  const auto &west = boundaries.at(kWestCell).open, &east = boundaries.at(kEastCell).open;
  ASSERT_EQ(west.size(), 3U);
  ASSERT_EQ(east.size(), 3U);
  for (size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(west[i].segment.from, east[i].segment.to);
    EXPECT_EQ(west[i].segment.to, east[i].segment.from);
    EXPECT_TRUE(west[i].segment.seam && east[i].segment.seam);
    EXPECT_EQ(west[i].side, kEast);
    EXPECT_EQ(east[i].side, kWest);
  }
  EXPECT_EQ(west[0].segment.from, 3) << "going north the western cell is on the left";
}

TEST(AddSeamTest, GivesTheNorthernCellTheWayEast) {
  const Scene scene;
  const std::set<CellId> area = AreaOf(1, 2);
  CellBoundaries boundaries;
  AddSeam(CellsOf(area, 10), scene.rim, RimIndex(scene.rim), {{0, 0}, {0, 1}, {1, 4, 2}}, boundaries);
  EXPECT_EQ(boundaries.at({0, 1}).open.at(0).segment.from, 1);
  EXPECT_EQ(boundaries.at({0, 1}).open.at(0).side, kSouth);
  EXPECT_EQ(boundaries.at({0, 0}).open.at(0).segment.from, 4);
  EXPECT_EQ(boundaries.at({0, 0}).open.at(0).side, kNorth);
}

TEST(AddSeamTest, SkipsWhatFollowsARimEdge) {
  const Scene scene;
  CellBoundaries boundaries;
  AddSeam(scene.input, scene.rim, RimIndex(scene.rim), {kWestCell, kEastCell, {3, 2}}, boundaries);
  EXPECT_TRUE(boundaries.empty());
}

TEST(AddSeamTest, GivesNothingToCellsOutsideTheArea) {
  const Scene scene;
  CellBoundaries boundaries;
  AddSeam(CellsOf({kWestCell}, 10), scene.rim, RimIndex(scene.rim), {kWestCell, kEastCell, {3, 4, 2}}, boundaries);
  EXPECT_EQ(boundaries.size(), 1U);
}

}  // namespace
}  // namespace tilemend
