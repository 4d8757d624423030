#include "worker/fill/patch_crossings.h"

#include <gtest/gtest.h>

#include <vector>

namespace tilemend {
namespace {

const SpaceTriangle kFlat = {Point3(0, 0, 0), Point3(4, 0, 0), Point3(0, 4, 0)};
const SpaceTriangle kThrough = {Point3(1, 1, -1), Point3(1, 1, 1), Point3(9, 9, 0)};
const SpaceTriangle kAbove = {Point3(0, 0, 3), Point3(4, 0, 3), Point3(0, 4, 3)};
const SpaceTriangle kNeighbour = {Point3(4, 0, 0), Point3(0, 0, 0), Point3(2, -3, 1)};
const SpaceTriangle kFoldedBack = {Point3(4, 0, 0), Point3(0, 0, 0), Point3(1, 3, 0)};
const SpaceTriangle kAtACorner = {Point3(0, 0, 0), Point3(-3, 1, 0), Point3(-3, -1, 2)};
const SpaceTriangle kThroughFromACorner = {Point3(0, 0, 0), Point3(1, 1, 2), Point3(2, 2, -2)};

bool Crosses(const std::vector<SpaceTriangle>& patch, const std::vector<SpaceTriangle>& surface = {}) {
  return PatchCrosses(patch, surface);
}

TEST(PatchCrossingsTest, SeesAnEdgeThatPassesThrough) {
  EXPECT_TRUE(Crosses({kFlat, kThrough}));
  EXPECT_TRUE(Crosses({kThrough, kFlat}));
  EXPECT_TRUE(Crosses({kFlat}, {kThrough}));
  EXPECT_TRUE(Crosses({kFlat, kThroughFromACorner}));
}

TEST(PatchCrossingsTest, SeesATriangleFoldedOntoItsNeighbour) { EXPECT_TRUE(Crosses({kFlat, kFoldedBack})); }

TEST(PatchCrossingsTest, LetsNeighboursBe) {
  EXPECT_FALSE(Crosses({kFlat, kAbove, kNeighbour, kAtACorner}));
  EXPECT_FALSE(Crosses({kFlat}, {kAbove, kNeighbour, kAtACorner}));
}

TEST(PatchCrossingsTest, LeavesTheSurfaceToItself) { EXPECT_FALSE(Crosses({kAbove}, {kFlat, kThrough})); }

}  // namespace
}  // namespace tilemend
