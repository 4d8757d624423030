#include "coordinator/plan/pieces/outline_sides.h"

#include <gtest/gtest.h>

#include "tests/support/rim_builders.h"

namespace tilemend {
namespace {

GridLines TileOfTenMetres() {
  GridLines lines = LinesOf({{0, 0}}, 10);
  lines.tolerance = 0.1;
  return lines;
}

TEST(OnOneSideTest, HoldsWithinTheToleranceOfOneSide) {
  const GridLines lines = TileOfTenMetres();
  EXPECT_TRUE(OnOneSide({10.05, 2, 0}, {9.95, 7, 40}, {0, 0}, lines));
  EXPECT_TRUE(OnOneSide({3, 0, 0}, {8, 0.1, 0}, {0, 0}, lines));
  EXPECT_FALSE(OnOneSide({10, 2, 0}, {9.5, 7, 0}, {0, 0}, lines));
}

TEST(OnOneSideTest, DoesNotHoldOnTwoSidesThatMeet) {
  const GridLines lines = TileOfTenMetres();
  EXPECT_FALSE(OnOneSide({10, 2, 0}, {7, 10, 0}, {0, 0}, lines));
  EXPECT_TRUE(OnOneSide({10, 2, 0}, {10, 10, 0}, {0, 0}, lines)) << "the corner is on both";
}

TEST(FaceEachOtherTest, HoldsInOnePlaneAcrossAnAxis) {
  const GridLines lines = TileOfTenMetres();
  EXPECT_TRUE(FaceEachOther({4, 2, 1}, {4.01, 7, 3}, {0, 0}, lines, kSamePlane));
  EXPECT_TRUE(FaceEachOther({4, 2, 1}, {6, 7, 1}, {0, 0}, lines, kSamePlane));
  EXPECT_FALSE(FaceEachOther({4, 2, 1}, {4.1, 7, 3}, {0, 0}, lines, kSamePlane));
  EXPECT_TRUE(FaceEachOther({4, 2, 1}, {4.1, 7, 3}, {0, 0}, lines, kLoosePlane));
}

TEST(FaceEachOtherTest, HoldsOnOneSideOfTheTile) {
  EXPECT_TRUE(FaceEachOther({10.05, 2, 0}, {9.95, 7, 40}, {0, 0}, TileOfTenMetres(), kSamePlane));
}

}  // namespace
}  // namespace tilemend
