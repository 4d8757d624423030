#include "common/assemble/tree_levels.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "common/codec/tree/tile_tree.h"
#include "tests/support/osgb_scene.h"
#include "tests/support/pond_fan.h"
#include "tests/support/top_at.h"

namespace tilemend {
namespace {

std::string PackOf(OsgbScene::Pond pond) { return OsgbScene(pond).Pack(0); }

ClearArea PondArea() {
  ClearArea area;
  std::vector<Point2> ring;
  for (int k = 0; k < 60; ++k) {
    const double angle = k * M_PI / 30;
    ring.emplace_back(OsgbScene::kCell + OsgbScene::kRadius * std::cos(angle),
                      OsgbScene::kCell / 2 + OsgbScene::kRadius * std::sin(angle));
  }
  area.polygon.rings = {ring};
  area.top = OsgbScene::kLevel + 1.5;
  return area;
}

TEST(ClearTreeLevelsTest, EveryLevelLosesThePond) {
  const std::string pack = PackOf(OsgbScene::Pond::kNoise);
  const std::vector<ClearArea> areas = {PondArea()};
  const auto cleared = ClearTreeLevels(pack, areas, "a/Tile.osgb");
  ASSERT_TRUE(cleared.ok()) << cleared.status();
  const auto before = ReadTileTree(pack, "a/Tile.osgb"), after = ReadTileTree(cleared->bytes, "a/Tile.osgb");
  ASSERT_TRUE(after.ok()) << after.status();
  for (int32_t l = 0; l < 3; ++l) {
    const TreeLevel was = LevelOf(*before, l), is = LevelOf(*after, l);
    EXPECT_LT(is.mesh.triangles.size(), was.mesh.triangles.size()) << l;
    EXPECT_EQ(is.mesh.points.size(), was.mesh.points.size()) << "vertices stay, " << l;
    for (const int32_t by : AreasThatClear(is.mesh, areas)) EXPECT_EQ(by, -1);
    if (l == 2) {
      ASSERT_EQ(cleared->triangles.size(), 1u);
      EXPECT_EQ(cleared->triangles[0], static_cast<int64_t>(was.mesh.triangles.size() - is.mesh.triangles.size()));
      EXPECT_EQ(cleared->file.mesh.triangles, is.mesh.triangles);
    }
    const auto removed = static_cast<int64_t>(was.mesh.triangles.size() - is.mesh.triangles.size());
    EXPECT_EQ(cleared->levels[static_cast<size_t>(l)], (LevelCounts{0, 0, 0, removed})) << l;
    if (l < 2) {
      EXPECT_EQ(std::ssize(cleared->surfaces[static_cast<size_t>(l)].triangles), removed) << l;
    }
  }
  EXPECT_EQ(cleared->surfaces.size(), 2u) << "none of the finest level";
}

TEST(PatchTreeLevelsTest, CoarserLevelsHaveNoHoleAroundWhatWasCleared) {
  const std::string pack = PackOf(OsgbScene::Pond::kNoise);
  ClearArea area = PondArea();
  const Point2 middle(30, 20);
  for (Point2& p : area.polygon.rings[0]) {
    p = middle + (p - Point2(OsgbScene::kCell, OsgbScene::kCell / 2)) * 2 / OsgbScene::kRadius;
  }
  area.top = 100;
  const auto cleared = ClearTreeLevels(pack, {&area, 1}, "a/Tile.osgb");
  ASSERT_TRUE(cleared.ok()) << cleared.status();
  const auto before = ReadTileTree(pack, "a/Tile.osgb");
  // The triangles that were cleared in the finest level are the patch.
  const TreeLevel finest = LevelOf(*before, 2);
  FilePatch patch;
  const std::vector<int32_t> by = AreasThatClear(finest.mesh, {&area, 1});
  for (size_t t = 0; t < by.size(); ++t) {
    if (by[t] >= 0) patch.triangles.push_back(finest.mesh.triangles[t]);
  }
  const auto patched = PatchTreeLevels(cleared->bytes, patch, {}, "a/Tile.osgb", {}, "", cleared->surfaces);
  ASSERT_TRUE(patched.ok()) << patched.status();
  EXPECT_TRUE(patched->warnings.empty());
  const auto after = ReadTileTree(patched->pack, "a/Tile.osgb");
  ASSERT_TRUE(after.ok()) << after.status();
  for (int32_t l = 0; l < 3; ++l) {
    const TreeLevel is = LevelOf(*after, l);
    for (double x = middle.x() - 9.87; x < middle.x() + 10; x += 0.5) {
      for (double y = middle.y() - 9.81; y < middle.y() + 10; y += 0.5) {
        EXPECT_FALSE(std::isnan(TopAt(is.mesh, {x, y}))) << "level " << l << " at " << x << ", " << y;
      }
    }
  }
}

TEST(PatchTreeLevelsTest, EveryLevelGetsThePatch) {
  const std::string pack = PackOf(OsgbScene::Pond::kHole);
  const auto before = ReadTileTree(pack, "a/Tile.osgb");
  ASSERT_TRUE(before.ok()) << before.status();
  const TreeLevel finest = LevelOf(*before, 2);
  const FilePatch patch = FanInPond(static_cast<int32_t>(finest.mesh.points.size()));
  const std::vector<FillMaterial> materials = {{"water", {10, 20, 30}}};
  const auto patched = PatchTreeLevels(pack, patch, materials, "a/Tile.osgb");
  ASSERT_TRUE(patched.ok()) << patched.status();
  const auto after = ReadTileTree(patched->pack, "a/Tile.osgb");
  ASSERT_TRUE(after.ok()) << after.status();
  for (int32_t l = 0; l < 3; ++l) {
    const TreeLevel was = LevelOf(*before, l), is = LevelOf(*after, l);
    EXPECT_GT(is.mesh.triangles.size(), was.mesh.triangles.size()) << l;
    EXPECT_EQ(patched->levels[static_cast<size_t>(l)].added,
              static_cast<int64_t>(is.mesh.triangles.size() - was.mesh.triangles.size()));
  }
  ASSERT_EQ(patched->new_geometries.size(), before->pieces.size());
  for (size_t p = 0; p < before->pieces.size(); ++p) {
    const auto file = static_cast<size_t>(before->pieces[p].file);
    const auto count = [&](const TileTree& tile) {
      return std::ranges::count(tile.files[file].geometries, before->pieces[p].part, &TreeGeometry::part);
    };
    EXPECT_EQ(count(*after) - count(*before), patched->new_geometries[p]) << p;
  }
  EXPECT_EQ(patched->levels[0].filled, 1);
  EXPECT_GT(patched->levels[2].filled, 1);
  EXPECT_EQ(LevelOf(*after, 2).mesh.triangles.size(), finest.mesh.triangles.size() + 40);
}

TEST(PatchTreeLevelsTest, WithoutAPatchAllBytesStay) {
  const std::string pack = PackOf(OsgbScene::Pond::kHole);
  const auto patched = PatchTreeLevels(pack, {}, {}, "a/Tile.osgb");
  ASSERT_TRUE(patched.ok()) << patched.status();
  EXPECT_EQ(patched->pack, pack);
  EXPECT_THAT(patched->levels, ::testing::Each(LevelCounts{}));
}

}  // namespace
}  // namespace tilemend
