#include "worker/fill/hole/local_patch.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

namespace tilemend {
namespace {

using ::testing::ElementsAre;

LocalHole HoleWith(std::vector<int32_t> vertices) {
  LocalHole hole;
  for (size_t v = 0; v < vertices.size(); ++v) hole.positions.emplace_back(static_cast<double>(v), 0, 0);
  hole.vertices = std::move(vertices);
  return hole;
}

TEST(LocalPatchTest, LeavesWithTheNumbersOfTheCell) {
  const LocalHole hole = HoleWith({7, 3, 9});
  LocalPatch patch;
  patch.new_points = {Point3(1, 1, 1), Point3(2, 2, 2)};
  patch.triangles = {{0, 1, 3}, {2, 4, 3}};
  EXPECT_EQ(InSpace(hole, patch, {2, 4, 3}), (SpaceTriangle{Point3(2, 0, 0), Point3(2, 2, 2), Point3(1, 1, 1)}));
  const HolePatch out = ToHolePatch(hole, patch);
  EXPECT_THAT(out.triangles, ElementsAre(Triangle{7, 3, -1}, Triangle{9, -2, -1}));
  EXPECT_EQ(out.new_points, patch.new_points);
  EXPECT_EQ(out.failure, "");
}

TEST(LocalPatchTest, TakesAPartInBehindWhatItHas) {
  const LocalHole hole = HoleWith({7, 3, 9, 4});
  LocalPatch patch;
  patch.new_points = {Point3(1, 0, 0), Point3(2, 0, 0)};  // on a crease
  HolePart part{HoleWith({9, -1, -1}), {2, 4, 5}};
  LocalPatch of_part;
  of_part.new_points = {Point3(5, 5, 5)};
  of_part.triangles = {{0, 1, 3}, {1, 2, 3}};
  AddPart(part, of_part, hole, patch);
  EXPECT_THAT(patch.triangles, ElementsAre(Triangle{2, 4, 6}, Triangle{4, 5, 6}));
  EXPECT_THAT(patch.new_points, ElementsAre(Point3(1, 0, 0), Point3(2, 0, 0), Point3(5, 5, 5)));
}

TEST(LocalPatchTest, DropsPointsThatNoTriangleHas) {
  const LocalHole hole = HoleWith({7, 3, 9});
  LocalPatch patch;
  patch.new_points = {Point3(1, 1, 1), Point3(2, 2, 2), Point3(3, 3, 3)};
  patch.triangles = {{0, 1, 3}, {2, 5, 3}};
  DropUnusedPoints(hole, patch);
  EXPECT_THAT(patch.new_points, ElementsAre(Point3(1, 1, 1), Point3(3, 3, 3)));
  EXPECT_THAT(patch.triangles, ElementsAre(Triangle{0, 1, 3}, Triangle{2, 4, 3}));
}

}  // namespace
}  // namespace tilemend
