#include "coordinator/plan/rim/shallow_runs.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/rim_builders.h"

namespace tilemend {
namespace {

constexpr CellId kWestCell{0, 0}, kEastCell{1, 0};

// A ragged cut: two cells of 10 m, and a hole of 16 edges in the eastern one whose west side leans `depth` metres over
// the line between them for `length` of its edges. These alone are closed by the western cell.
struct Bulge {
  Bulge(double depth, int32_t length, std::set<CellId> cells = AreaOf(2, 1))
      : area(std::move(cells)), input(CellsOf(area, 10)), lines(LinesOf(area, 10)) {
    lines.clipped = false;
    Loop3 loop;
    for (int32_t y = 0; y < 8; ++y) loop.emplace_back(y >= 1 && y <= 1 + length ? 10 - depth : 10.5, y + 1, 0);
    for (int32_t y = 7; y >= 0; --y) loop.emplace_back(16, y + 1, 0);
    rim = RimOf({loop});
    closing.assign(rim.edges.size(), kEastCell);
    for (int32_t e = 1; e < 1 + length; ++e) closing[e] = kWestCell;
  }

  std::vector<CellId> Close() {
    CloseShallowRuns(input, lines, rim, rim.loops[0], closing);
    return closing;
  }

  std::set<CellId> area;
  PlanInput input;
  GridLines lines;
  Rim rim;
  std::vector<CellId> closing;
};

bool AllEast(const std::vector<CellId>& closing) {
  return std::all_of(closing.begin(), closing.end(), [](CellId c) { return c == kEastCell; });
}

TEST(CloseShallowRunsTest, GivesARunToTheCellAroundItThatLiesWithinAnEdgesLengthOfIt) {
  EXPECT_TRUE(AllEast(Bulge(0.5, 3).Close()));
}

TEST(CloseShallowRunsTest, KeepsARunThatReachesDeep) { EXPECT_FALSE(AllEast(Bulge(4, 3).Close())); }

TEST(CloseShallowRunsTest, AllowsShortRunsTwiceTheDepth) {
  EXPECT_TRUE(AllEast(Bulge(1.5, 1).Close()));
  EXPECT_FALSE(AllEast(Bulge(1.5, 4).Close()));
}

TEST(CloseShallowRunsTest, KeepsARunLongerThanThoseBesideIt) {
  Bulge bulge(0.5, 3);
  for (size_t e = 0; e < bulge.closing.size(); ++e) {
    bulge.closing[e] = e % 8 < 4 ? kWestCell : kEastCell;  // runs of four
  }
  bulge.closing[4] = kWestCell;  // five western edges before three eastern ones, which are shallow in neither
  const std::vector<CellId> closed = bulge.Close();
  EXPECT_EQ(closed[4], kWestCell);
}

TEST(CloseShallowRunsTest, GivesNothingOutOfTheArea) {
  Bulge bulge(0.5, 3, {kWestCell});
  const std::vector<CellId> before = bulge.closing;
  EXPECT_EQ(bulge.Close(), before) << "the cell around is none of the area";
}

TEST(CloseShallowRunsTest, TakesAShallowRunInAZigzagForOutline) {
  Bulge bulge(0.5, 3, {kWestCell});
  bulge.lines.zigzag = {{kWestCell, kEast}};
  EXPECT_TRUE(AllEast(bulge.Close()));
}

// Edges 1 to `length` close out of the area, all others on the western cell.
Bulge OutlineBesideAHole(double depth, int32_t length) {
  Bulge bulge(depth, length, {kWestCell});
  bulge.lines.zigzag = {{kWestCell, kEast}};
  for (CellId& cell : bulge.closing) cell = cell == kWestCell ? kEastCell : kWestCell;
  return bulge;
}

TEST(CloseShallowRunsTest, TakesAToothInsideTheLineForTheRimOfTheHoleAroundIt) {
  EXPECT_EQ(OutlineBesideAHole(0.5, 2).Close()[1], kWestCell);
  EXPECT_EQ(OutlineBesideAHole(-0.5, 2).Close()[1], kEastCell) << "beyond the line it is outline";
  EXPECT_EQ(OutlineBesideAHole(0.5, 3).Close()[1], kEastCell) << "so are many edges";
}

TEST(CloseShallowRunsTest, PassesACornerOfTheAreaOnceHoweverTheOutlineFacesThere) {
  const CellId cell{0, 0}, beyond_east{1, 0}, beyond_north{0, 1};
  const PlanInput input = CellsOf({cell}, 10);
  GridLines lines = LinesOf({cell}, 10);
  lines.clipped = false;
  lines.zigzag = {{cell, kEast}, {cell, kNorth}};
  // Surface: up along the east side, a step before the corner, and back along the north side.
  const Rim rim = RimOf({{{0, 0, 0},
                          {9.8, 0, 0},
                          {9.9, 8.8, 0},
                          {9.4, 9.2, 0},
                          {9.5, 9.6, 0},
                          {8.5, 9.9, 0},
                          {7.5, 9.8, 0},
                          {0, 9.9, 0}}});
  std::vector<CellId> closing(8, cell);
  closing[1] = closing[3] = beyond_east;
  closing[2] = closing[4] = closing[5] = closing[6] = beyond_north;
  CloseShallowRuns(input, lines, rim, rim.loops[0], closing);
  int changes = 0;
  for (size_t e = 1; e < 6; ++e) changes += closing[e] != closing[e + 1];
  EXPECT_EQ(changes, 1);
  EXPECT_EQ(closing[1], beyond_east);
  EXPECT_EQ(closing[6], beyond_north);
}

TEST(CloseShallowRunsTest, KeepsOnAClippedCutWhatATileEndsAt) {
  Bulge bulge(0, 3);
  bulge.lines.clipped = true;
  for (RimEdge& e : bulge.rim.edges) e.owner = kEastCell;
  EXPECT_FALSE(AllEast(bulge.Close())) << "the eastern tile ends at the line, with the hole beyond";
}

TEST(CloseShallowRunsTest, DoesNotDependOnWhereTheLoopStarts) {
  const Bulge bulge(0.5, 3);
  for (size_t start = 0; start < bulge.rim.loops[0].size(); ++start) {
    Bulge turned = bulge;
    std::rotate(turned.rim.loops[0].begin(), turned.rim.loops[0].begin() + static_cast<ptrdiff_t>(start),
                turned.rim.loops[0].end());
    EXPECT_TRUE(AllEast(turned.Close())) << start;
  }
}

TEST(CloseShallowRunsTest, LeavesALoopOfOneCellAsItIs) {
  Bulge bulge(0.5, 0);
  EXPECT_TRUE(AllEast(bulge.Close()));
}

}  // namespace
}  // namespace tilemend
