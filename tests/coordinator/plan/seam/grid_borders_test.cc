#include "coordinator/plan/seam/grid_borders.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "tests/support/rim_builders.h"

namespace tilemend {
namespace {

using ::testing::ElementsAre;

TEST(ForCornersTest, CallsForEveryCornerOnce) {
  std::vector<Corner> corners;
  ForCorners({{0, 0}, {1, 0}, {1, 1}}, [&](Corner c) { corners.push_back(c); });
  std::sort(corners.begin(), corners.end());
  EXPECT_THAT(corners, ElementsAre(Corner{0, 0}, Corner{0, 1}, Corner{1, 0}, Corner{1, 1}, Corner{1, 2}, Corner{2, 0},
                                   Corner{2, 1}, Corner{2, 2}));
}

TEST(BordersAtTest, BeginOrEndAtTheCorner) {
  const Corner corner{3, 2};
  const auto borders = BordersAt(corner);
  for (const Border& b : borders) {
    EXPECT_TRUE(LowCorner(b) == corner || HighCorner(b) == corner);
    EXPECT_EQ(std::count(borders.begin(), borders.end(), b), 1);
  }
  EXPECT_TRUE(IsOfArea(borders[0], {{3, 1}}));
  EXPECT_FALSE(IsOfArea(borders[0], {{3, 2}}));
}

TEST(GridBordersTest, RunFromCornerToCorner) {
  const Border vertical{{0, 0}, {1, 0}}, horizontal{{0, 0}, {0, 1}};
  EXPECT_EQ(LowCorner(vertical), (Corner{1, 0}));
  EXPECT_EQ(HighCorner(vertical), (Corner{1, 1}));
  EXPECT_EQ(LowCorner(horizontal), (Corner{0, 1}));
  EXPECT_EQ(HighCorner(horizontal), (Corner{1, 1}));
}

TEST(GridBordersTest, HaveTheWesternOrNorthernCellOnTheLeft) {
  EXPECT_EQ(LeftOf({{0, 0}, {1, 0}}), (CellId{0, 0}));
  EXPECT_EQ(RightOf({{0, 0}, {1, 0}}), (CellId{1, 0}));
  EXPECT_EQ(LeftOf({{0, 0}, {0, 1}}), (CellId{0, 1}));
  EXPECT_EQ(RightOf({{0, 0}, {0, 1}}), (CellId{0, 0}));
}

TEST(LineOfTest, AsksACellOfTheArea) {
  const std::set<CellId> area = {{1, 0}};
  const GridLines lines = LinesOf(area, 10);
  EXPECT_EQ(LineOf({{0, 0}, {1, 0}}, area, lines), 10);
  EXPECT_EQ(LineOf({{1, 0}, {2, 0}}, area, lines), 20);
  EXPECT_EQ(LineOf({{1, 0}, {1, 1}}, area, lines), 10);
  EXPECT_EQ(LineOf({{1, -1}, {1, 0}}, area, lines), 0);
}

TEST(CornerPositionTest, HoldsForAllCornersOfAnArea) {
  const std::set<CellId> area = {{0, 0}, {1, 0}, {1, 1}};
  const GridLines lines = LinesOf(area, 10);
  for (const Corner c : {Corner{0, 0}, {1, 0}, {2, 0}, {0, 1}, {1, 1}, {2, 1}, {1, 2}, {2, 2}}) {
    EXPECT_EQ(CornerPosition(c, area, lines), Point2(10 * c.col, 10 * c.row));
  }
}

TEST(OverlapAtTest, IsThatOfTheTileWhichReachesFarthest) {
  const std::set<CellId> area = AreaOf(2, 2);
  GridLines lines = LinesOf(area, 10);
  EXPECT_EQ(OverlapAt({1, 1}, 0, lines), 0);
  lines.outline = lines.coordinate;
  lines.outline.at({0, 1})[kEast] = 10.5;   // over x = 10
  lines.outline.at({1, 0})[kWest] = 9;      // over x = 10, from the other side
  lines.outline.at({1, 1})[kSouth] = 10.7;  // ends before y = 10
  EXPECT_EQ(OverlapAt({1, 1}, 0, lines), 1);
  EXPECT_EQ(OverlapAt({1, 1}, 1, lines), 0);
  EXPECT_EQ(OverlapAt({1, 2}, 0, lines), 0.5);
  EXPECT_EQ(OverlapAt({0, 1}, 0, lines), 0);
}

TEST(TouchesOutsideTest, HoldsAtTheRimOfTheArea) {
  const std::set<CellId> area = AreaOf(2, 2);
  EXPECT_FALSE(TouchesOutside({1, 1}, area));
  for (const Corner c : {Corner{0, 0}, {1, 0}, {2, 1}, {2, 2}}) EXPECT_TRUE(TouchesOutside(c, area));
}

}  // namespace
}  // namespace tilemend
