#include "common/assemble/assemble.h"

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

const FillColours kColours = {{{0, {0, {1, 2, 3}, true}}, {4, {4, {7, 8, 9}, true}}}, false};

HolePatch Fan() {
  HolePatch patch;
  patch.new_points = {{9, 9, 9}};
  patch.triangles = {{0, 1, -1}, {1, 2, -1}, {2, 3, -1}, {3, 0, -1}};
  return patch;
}

TEST(MergePatchesTest, NamesOwnVerticesByTheirIndexInTheTile) {
  HolePatch patch;
  patch.triangles = {{0, 1, 2}};
  const FilePatch merged = MergePatches(kRim, std::vector{patch}, kCell, kTileVertices, kColours);
  EXPECT_THAT(merged.triangles, ElementsAre(Triangle{40, 7, kTileVertices}));
}

TEST(MergePatchesTest, AddsForeignSeamAndNewVerticesOnceEach) {
  const FilePatch merged = MergePatches(kRim, std::vector{Fan()}, kCell, kTileVertices, kColours);
  EXPECT_THAT(merged.new_points, ElementsAre(Point3(9, 9, 9), kRim[2].position, kRim[3].position));
  EXPECT_THAT(merged.triangles,
              ElementsAre(Triangle{40, 7, 50}, Triangle{7, 51, 50}, Triangle{51, 52, 50}, Triangle{52, 40, 50}));
}

TEST(MergePatchesTest, SharesForeignAndSeamVerticesBetweenPatches) {
  HolePatch second;
  second.triangles = {{3, 2, 0}};
  const FilePatch merged = MergePatches(kRim, std::vector{Fan(), second}, kCell, kTileVertices, kColours);
  EXPECT_EQ(merged.new_points.size(), 3u);
  EXPECT_EQ(merged.triangles.back(), (Triangle{52, 51, 40}));
}

TEST(MergePatchesTest, KeepsTheNewVerticesOfPatchesApart) {
  const FilePatch merged = MergePatches(kRim, std::vector{Fan(), Fan()}, kCell, kTileVertices, kColours);
  EXPECT_EQ(merged.new_points.size(), 4u);
  EXPECT_EQ(merged.triangles[4], (Triangle{40, 7, 53}));
}

TEST(MergePatchesTest, LeavesPatchesWithAFailureOut) {
  HolePatch failed = Fan();
  failed.failure = "for a reason";
  const FilePatch merged = MergePatches(kRim, std::vector{failed}, kCell, kTileVertices, kColours);
  EXPECT_THAT(merged.new_points, IsEmpty());
  EXPECT_THAT(merged.triangles, IsEmpty());
}

TEST(MergePatchesTest, GivesEachNewVertexATileVertexAsModel) {
  const FilePatch merged = MergePatches(kRim, std::vector{Fan()}, kCell, kTileVertices, kColours);
  EXPECT_THAT(merged.like, ElementsAre(40, 7, 40));
}

TEST(MergePatchesTest, HandsModelsOnThroughTheRingsOfAPatch) {
  HolePatch strip;
  for (int32_t k = 0; k < 5; ++k) strip.new_points.emplace_back(k, 5, 0);
  strip.triangles = {{-3, -4, -5}, {-2, -3, -4}, {-1, -2, -3}, {0, -1, -2}};
  const FilePatch merged = MergePatches(kRim, std::vector{strip}, kCell, kTileVertices, kColours);
  EXPECT_THAT(merged.like, ElementsAre(40, 40, 40, 40, 40));
}

TEST(MergePatchesTest, HasNoModelsInACellWithoutATile) {
  const FilePatch merged = MergePatches(kRim, std::vector{Fan()}, kCell, 0, kColours);
  EXPECT_THAT(merged.like, ElementsAre(-1, -1, -1, -1, -1));
  EXPECT_THAT(merged.triangles,
              ElementsAre(Triangle{0, 1, 2}, Triangle{1, 3, 2}, Triangle{3, 4, 2}, Triangle{4, 0, 2}));
}

TEST(MergePatchesTest, AddsNothingWithoutPatches) {
  EXPECT_THAT(MergePatches(kRim, {}, kCell, kTileVertices, kColours).triangles, IsEmpty());
}

TEST(MergePatchesTest, NamesTheMaterialOfEachHole) {
  HolePatch other = Fan();
  other.hole = 4;
  const FilePatch merged = MergePatches(kRim, std::vector{Fan(), Fan(), other}, kCell, kTileVertices, kColours);
  ASSERT_EQ(merged.materials.size(), 2U) << "one run for two patches of one hole";
  EXPECT_EQ(merged.materials[0].first, 0);
  EXPECT_EQ(merged.materials[0].material, "tilemend_fill_0_010203");
  EXPECT_EQ(merged.materials[0].colour, (Rgb{1, 2, 3}));
  EXPECT_EQ(merged.materials[1].first, 8);
  EXPECT_EQ(merged.materials[1].material, "tilemend_fill_4_070809");
  EXPECT_THAT(merged.colours, IsEmpty());
}

TEST(MergePatchesTest, ColoursNewVerticesIfAsked) {
  FillColours colours = kColours;
  colours.on_vertices = true;
  HolePatch other = Fan();
  other.hole = 4;
  const FilePatch merged = MergePatches(kRim, std::vector{Fan(), other}, kCell, kTileVertices, colours);
  EXPECT_THAT(merged.colours, ElementsAre(Rgb{1, 2, 3}, Rgb{1, 2, 3}, Rgb{1, 2, 3}, Rgb{7, 8, 9}))
      << "what two patches share has the colour of the first";
}

TEST(MaterialsOfTest, GivesTheMaterialsOfPatchesThatAreThere) {
  HolePatch other = Fan(), failed = Fan();
  other.hole = 4;
  failed.failure = "no";
  EXPECT_THAT(MaterialsOf(std::vector{failed, other, other}, kColours),
              ElementsAre(FillMaterial{"tilemend_fill_4_070809", {7, 8, 9}}));
}

}  // namespace
}  // namespace tilemend
