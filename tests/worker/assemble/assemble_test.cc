#include "worker/assemble/assemble.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr CellId kCell{2, 1};
constexpr int32_t kTileVertices = 50;

RimVertex Own(int32_t index) {
  RimVertex v;
  v.tile = kCell;
  v.index = index;
  v.position = Point3(index, 0, 0);
  return v;
}

RimVertex Foreign(int32_t index) {
  RimVertex v = Own(index);
  v.tile = {3, 1};
  v.position = Point3(index, 1, 0);
  return v;
}

RimVertex Seam(int32_t number) {
  RimVertex v;
  v.seam_vertex = number;
  v.position = Point3(number, 2, 0);
  return v;
}

// Two own vertices, a foreign one and a seam vertex around one new vertex, which is corner -1.
const std::vector<RimVertex> kRim = {Own(40), Own(7), Foreign(3), Seam(11)};

HolePatch Fan() {
  HolePatch patch;
  patch.new_points = {{9, 9, 9}};
  patch.triangles = {{0, 1, -1}, {1, 2, -1}, {2, 3, -1}, {3, 0, -1}};
  return patch;
}

TEST(MergePatchesTest, NamesOwnVerticesByTheirIndexInTheTile) {
  HolePatch patch;
  patch.triangles = {{0, 1, 2}};
  const FilePatch merged = MergePatches(kRim, std::vector{patch}, kCell, kTileVertices);
  EXPECT_THAT(merged.triangles, ElementsAre(Triangle{40, 7, kTileVertices}));
}

TEST(MergePatchesTest, AddsForeignSeamAndNewVerticesOnceEach) {
  const FilePatch merged = MergePatches(kRim, std::vector{Fan()}, kCell, kTileVertices);
  EXPECT_THAT(merged.new_points, ElementsAre(Point3(9, 9, 9), kRim[2].position, kRim[3].position));
  EXPECT_THAT(merged.triangles,
              ElementsAre(Triangle{40, 7, 50}, Triangle{7, 51, 50}, Triangle{51, 52, 50}, Triangle{52, 40, 50}));
}

TEST(MergePatchesTest, SharesForeignAndSeamVerticesBetweenPatches) {
  HolePatch second;
  second.triangles = {{3, 2, 0}};
  const FilePatch merged = MergePatches(kRim, std::vector{Fan(), second}, kCell, kTileVertices);
  EXPECT_EQ(merged.new_points.size(), 3u);
  EXPECT_EQ(merged.triangles.back(), (Triangle{52, 51, 40}));
}

TEST(MergePatchesTest, KeepsTheNewVerticesOfPatchesApart) {
  const FilePatch merged = MergePatches(kRim, std::vector{Fan(), Fan()}, kCell, kTileVertices);
  EXPECT_EQ(merged.new_points.size(), 4u);
  EXPECT_EQ(merged.triangles[4], (Triangle{40, 7, 53}));
}

TEST(MergePatchesTest, LeavesPatchesWithAFailureOut) {
  HolePatch failed = Fan();
  failed.failure = "for a reason";
  const FilePatch merged = MergePatches(kRim, std::vector{failed}, kCell, kTileVertices);
  EXPECT_THAT(merged.new_points, IsEmpty());
  EXPECT_THAT(merged.triangles, IsEmpty());
}

TEST(MergePatchesTest, GivesEachNewVertexATileVertexAsModel) {
  const FilePatch merged = MergePatches(kRim, std::vector{Fan()}, kCell, kTileVertices);
  EXPECT_THAT(merged.like, ElementsAre(40, 7, 40));
}

TEST(MergePatchesTest, HandsModelsOnThroughTheRingsOfAPatch) {
  HolePatch strip;
  for (int32_t k = 0; k < 5; ++k) strip.new_points.emplace_back(k, 5, 0);
  strip.triangles = {{-3, -4, -5}, {-2, -3, -4}, {-1, -2, -3}, {0, -1, -2}};
  const FilePatch merged = MergePatches(kRim, std::vector{strip}, kCell, kTileVertices);
  EXPECT_THAT(merged.like, ElementsAre(40, 40, 40, 40, 40));
}

TEST(MergePatchesTest, HasNoModelsInACellWithoutATile) {
  const FilePatch merged = MergePatches(kRim, std::vector{Fan()}, kCell, 0);
  EXPECT_THAT(merged.like, ElementsAre(-1, -1, -1, -1, -1));
  EXPECT_THAT(merged.triangles,
              ElementsAre(Triangle{0, 1, 2}, Triangle{1, 3, 2}, Triangle{3, 4, 2}, Triangle{4, 0, 2}));
}

TEST(MergePatchesTest, AddsNothingWithoutPatches) {
  EXPECT_THAT(MergePatches(kRim, {}, kCell, kTileVertices).triangles, IsEmpty());
}

}  // namespace
}  // namespace tilemend
