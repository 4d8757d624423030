#include "coordinator/plan/seam/pieces_beside_seams.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/rim_builders.h"

namespace tilemend {
namespace {

using ::testing::Each;

constexpr CellId kSouthCell{0, 0}, kNorthCell{0, 1};

// A triangle of surface, counter-clockwise: points 0 and 1 south of the line y = 10, 2 north of it. The seam along the
// line has vertices 3 at its west end and 4 at its east end.
struct Site {
  explicit Site(std::set<CellId> cells = AreaOf(1, 2), const Loop3& piece = {{4, 9, 0}, {6, 9.5, 0}, {5, 12, 0}})
      : area(std::move(cells)), lines(LinesOf(area, 10)), rim(RimOf({piece})), index(rim), closing(OwnersOf(rim)) {
    for (const double x : {0, 10}) seams.vertices.push_back({Point2(x, 10)});
  }

  ClosingCells Give(const std::vector<int32_t>& way) {
    seams.seams = {{kSouthCell, kNorthCell, way}};
    ClosingCells given = closing;
    GivePiecesToTheirSide({area, lines, rim, index, options, 0x1p-10}, seams, given);
    return given;
  }

  std::set<CellId> area;
  GridLines lines;
  Rim rim;
  RimIndex index;
  PlanOptions options;
  SeamLayout seams;
  ClosingCells closing;
};

TEST(GivePiecesToTheirSideTest, GivesAPieceToTheCellWhereASeamLeavesIt) {
  Site site;
  EXPECT_THAT(site.Give({3, 0, 1, 4}), Each(kNorthCell)) << "the seam runs south of it";
  EXPECT_THAT(site.Give({3, 0, 4}), Each(kNorthCell)) << "and touches it at one point";
  EXPECT_THAT(site.Give({3, 2, 1, 4}), Each(kSouthCell)) << "north of it";
  EXPECT_THAT(site.Give({3, 2, 4}), Each(kSouthCell));
}

TEST(GivePiecesToTheirSideTest, TakesItBackFromTheOtherCell) {
  Site site;
  site.closing.assign(3, kNorthCell);
  EXPECT_THAT(site.Give({3, 2, 4}), Each(kSouthCell));
  EXPECT_THAT(site.Give({3, 0, 1, 4}), Each(kNorthCell));
}

TEST(GivePiecesToTheirSideTest, LeavesPiecesOffTheSeamsAndThoseThatBeginOrEndOne) {
  Site site;
  EXPECT_THAT(site.Give({3, 4}), Each(kSouthCell));
  EXPECT_THAT(site.Give({0, 4}), Each(kSouthCell));
  EXPECT_THAT(site.Give({3, 0}), Each(kSouthCell));
}

TEST(GivePiecesToTheirSideTest, LeavesPiecesThatSeveralCellsCloseOn) {
  Site site;
  site.closing[1] = kNorthCell;
  EXPECT_EQ(site.Give({3, 0, 1, 4}), site.closing) << "there junctions part the seam";
}

TEST(GivePiecesToTheirSideTest, LeavesHoles) {
  Site site(AreaOf(1, 2), {{4, 9, 0}, {5, 12, 0}, {6, 9.5, 0}});
  EXPECT_THAT(site.Give({3, 0, 2, 4}), Each(kSouthCell));
}

TEST(GivePiecesToTheirSideTest, TakesPiecesInsideASeamAlongTheAreasBorderForPartsOfTheArea) {
  Site site({kNorthCell});
  EXPECT_THAT(site.Give({3, 0, 1, 4}), Each(kNorthCell));
}

TEST(GivePiecesToTheirSideTest, LetsNoPieceOutOfTheArea) {
  Site site({kSouthCell});
  EXPECT_THAT(site.Give({3, 0, 1, 4}), Each(kSouthCell));
}

}  // namespace
}  // namespace tilemend
