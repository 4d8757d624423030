#include "coordinator/plan/pieces/piece_borders.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/hole_scene.h"

namespace tilemend {
namespace {

std::vector<double> Borders(const Rim& rim, double reach) {
  return FindPieceBorders(rim, RimIndex(rim), OwnersOf(rim), reach);
}

// Two pieces side by side, `gap` metres apart (overlapping if it is negative).
Rim TwoPieces(double gap) { return RimOf({PieceLoop(0, 0, 4, 4), PieceLoop(4 + gap, 0, 8, 4)}); }

TEST(FindPieceBordersTest, FindsEdgesThatRunAlongAnotherPiece) {
  for (const double gap : {0.05, -0.05}) {
    const std::vector<double> borders = Borders(TwoPieces(gap), 0.2);
    // Edge 1 is the east side of the western piece, edge 7 the west side of the eastern one.
    EXPECT_NEAR(borders[1], 0.05, 1e-12) << gap;
    EXPECT_NEAR(borders[7], 0.05, 1e-12) << gap;
    EXPECT_EQ(std::count_if(borders.begin(), borders.end(), [](double d) { return d >= 0; }), 2);
  }
}

TEST(FindPieceBordersTest, FindsNoneOutOfReach) {
  for (const double border : Borders(TwoPieces(0.5), 0.2)) EXPECT_EQ(border, -1);
}

TEST(FindPieceBordersTest, LeavesTheTilesOwnOutline) {
  const Rim rim = TwoPieces(0.05);
  ClosingCells closing = OwnersOf(rim);
  closing[1] = {1, 0};
  const std::vector<double> borders = FindPieceBorders(rim, RimIndex(rim), closing, 0.2);
  EXPECT_EQ(borders[1], -1);
  EXPECT_GE(borders[7], 0);
}

TEST(FindPieceBordersTest, LeavesEdgesThatRunTheSameWay) {
  // The second loop is a hole: its west side runs north, as the east side of the piece does.
  for (const double border : Borders(RimOf({PieceLoop(0, 0, 4, 4), HoleLoop(4.05, 0, 8, 4)}), 0.1)) {
    EXPECT_EQ(border, -1);
  }
}

TEST(FindPieceBordersTest, LeavesTheSidesOfACrack) {
  // One loop, hole between the sides: the other side lies away from the surface.
  for (const double border : Borders(RimOf({HoleLoop(4, 0, 4.05, 6)}), 0.1)) EXPECT_EQ(border, -1);
}

TEST(FindPieceBordersTest, LeavesEdgesInNoPlaneAcrossAnAxis) {
  Rim rim = TwoPieces(0.05);
  for (RimPoint& p : rim.points) {
    p.position = Point3(p.position.x() + 0.3 * p.position.y(), p.position.y(), 0.2 * p.position.y());
  }
  for (const double border : Borders(rim, 0.2)) EXPECT_EQ(border, -1);
}

TEST(FindPieceBordersTest, TurnsWithThePieces) {
  Rim rim = TwoPieces(0.05);
  const std::vector<double> before = Borders(rim, 0.2);
  for (RimPoint& p : rim.points) p.position = Point3(-p.position.y(), p.position.x(), p.position.z());
  const std::vector<double> after = Borders(rim, 0.2);
  for (size_t e = 0; e < before.size(); ++e) EXPECT_NEAR(after[e], before[e], 1e-12);
}

}  // namespace
}  // namespace tilemend
