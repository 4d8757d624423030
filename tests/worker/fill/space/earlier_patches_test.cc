#include "worker/fill/space/earlier_patches.h"

#include <gtest/gtest.h>

#include <vector>

namespace tilemend {
namespace {

// A patch of one triangle at (x, 0, 0).
HolePatch PatchAt(double x) {
  HolePatch patch;
  patch.new_points = {Point3(x, 0, 0), Point3(x + 0.5, 0, 0), Point3(x, 0.5, 0)};
  patch.triangles = {{-1, -2, -3}};
  return patch;
}

TEST(EarlierPatchesTest, FindsThoseNearInTheirOrderHoweverManyThereAre) {
  const CellHoles cell;
  std::vector<HolePatch> patches;
  EarlierPatches earlier(cell, patches);
  for (int count = 1; count <= 40; ++count) {
    patches.push_back(PatchAt((7 * count) % 40));  // in no order of places
    earlier.TakeLast();
    std::vector<SpaceTriangle> found, expected;
    earlier.AppendNear({Point3(9.8, -1, -1), Point3(13.2, 1, 1)}, found);
    for (const HolePatch& patch : patches) {
      const double x = patch.new_points[0].x();
      if (x >= 10 && x <= 13) expected.push_back({patch.new_points[0], patch.new_points[1], patch.new_points[2]});
    }
    EXPECT_EQ(found, expected) << count;
  }
}

TEST(EarlierPatchesTest, APatchWithoutTrianglesIsNowhere) {
  const CellHoles cell;
  std::vector<HolePatch> patches(1);
  EarlierPatches earlier(cell, patches);
  earlier.TakeLast();
  std::vector<SpaceTriangle> found;
  earlier.AppendNear({Point3(-9, -9, -9), Point3(9, 9, 9)}, found);
  EXPECT_TRUE(found.empty());
}

}  // namespace
}  // namespace tilemend
