#include "coordinator/plan/seam/seams_along_rim.h"

#include <gtest/gtest.h>

#include "tests/support/rim_builders.h"

namespace tilemend {
namespace {

constexpr CellId kWestCell{0, 0}, kEastCell{1, 0};

// A hole, clockwise, over the line x = 10 between two cells; edge 1 -> 2 runs north at x, just beside the line.
struct Site {
  explicit Site(std::set<CellId> cells = AreaOf(2, 1), double x = 9.9)
      : area(std::move(cells)),
        lines(LinesOf(area, 10)),
        rim(RimOf({{{10, 2, 0}, {x, 3, 0}, {x, 5, 0}, {10, 6, 0}, {14, 6, 0}, {14, 2, 0}}})),
        index(rim),
        closing(OwnersOf(rim)) {}

  void Pass(const std::vector<Seam>& seams) {
    CloseAlongSeams({area, lines, rim, index, options, 0x1p-10}, seams, closing);
  }

  std::set<CellId> area;
  GridLines lines;
  Rim rim;
  RimIndex index;
  PlanOptions options;
  ClosingCells closing;
};

TEST(CloseAlongSeamsTest, GivesAnEdgeToTheCellOnItsHolesSideOfTheSeam) {
  Site site;
  site.Pass({{kWestCell, kEastCell, {0, 1, 2, 3}}});
  EXPECT_EQ(site.closing[0], kEastCell);
  EXPECT_EQ(site.closing[1], kEastCell);
  EXPECT_EQ(site.closing[2], kEastCell);
  EXPECT_EQ(site.closing[3], kWestCell) << "no seam runs along it";
}

TEST(CloseAlongSeamsTest, TakesTheEdgeTheOtherWayFromASeamThatRunsAgainstIt) {
  Site site;
  site.closing.assign(site.rim.edges.size(), kEastCell);
  site.Pass({{kWestCell, kEastCell, {5, 4}}});  // going south along the east side: with the seam, against the edge
  EXPECT_EQ(site.closing[4], kWestCell);
}

TEST(CloseAlongSeamsTest, PassesAnEdgeOnOverSeveralSeams) {
  Site site(AreaOf(2, 2));
  const CellId north_east{1, 1};
  // The second seam takes it from the cell that the first one gave it to, whatever their order.
  site.Pass({{kEastCell, north_east, {2, 1}}, {kWestCell, kEastCell, {1, 2}}});
  EXPECT_EQ(site.closing[1], north_east);
}

TEST(CloseAlongSeamsTest, LetsNoEdgeOutOfTheAreaThatIsOffItsBorder) {
  Site site({kWestCell});
  site.Pass({{kWestCell, kEastCell, {0, 1, 2, 3}}});
  EXPECT_EQ(site.closing[1], kWestCell);
}

TEST(CloseAlongSeamsTest, LetsEdgesOutOfTheAreaAlongItsBorder) {
  Site site({kWestCell}, 10);
  site.Pass({{kWestCell, kEastCell, {1, 2}}});
  EXPECT_EQ(site.closing[1], kEastCell);
}

TEST(CloseAlongSeamsTest, LetsEdgesOutOfTheAreaInAZigzag) {
  Site site({kWestCell});
  site.lines.zigzag = {{kWestCell, kEast}};
  site.Pass({{kWestCell, kEastCell, {0, 1, 2, 3}}});
  EXPECT_EQ(site.closing[1], kEastCell);
}

TEST(CloseAlongSeamsTest, LetsEdgesOfARaggedCutOutOfTheAreaWithinAnEdgesLengthOfItsBorder) {
  Site site({kWestCell});
  site.lines.clipped = false;
  site.Pass({{kWestCell, kEastCell, {0, 1, 2, 3}}});
  EXPECT_EQ(site.closing[1], kEastCell);
  Site far_off({kWestCell}, 5);
  far_off.lines.clipped = false;
  far_off.Pass({{kWestCell, kEastCell, {1, 2}}});
  EXPECT_EQ(far_off.closing[1], kWestCell);
}

}  // namespace
}  // namespace tilemend
