#include "worker/materials/tree_look.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/image_builders.h"
#include "tests/support/osgb_scene.h"

namespace tilemend {
namespace {

using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::string Green() {
  return PngImage(4, 4, [](int32_t, int32_t) { return Rgb{20, 120, 40}; });
}

// Spots of vertices 0 and 1, in the first and the last triangle of the finest level.
std::vector<RimSpot> Spots(const TreeLevel& finest) {
  const auto last = static_cast<int32_t>(finest.mesh.triangles.size()) - 1;
  return {{0, 0, {0.4, 0.3, 0.3}}, {1, last, {0.4, 0.3, 0.3}}};
}

TEST(OsgbLookTest, TakesTexelsFromTheFilesThemselves) {
  const std::string pack = OsgbScene(OsgbScene::Pond::kHole, 80, Green()).Pack(0);
  const auto tile = ReadTileTree(pack, "a/Tile.osgb");
  ASSERT_TRUE(tile.ok()) << tile.status();
  const TreeLevel finest = LevelOf(*tile, 2);
  const RimColours rim = SampleTreeRim(*tile, finest, Spots(finest), 3, "a/Tile.osgb");
  EXPECT_THAT(rim.colours, ElementsAre(Rgb{20, 120, 40}, Rgb{20, 120, 40}, std::nullopt));
  EXPECT_THAT(rim.warnings, IsEmpty());
}

TEST(OsgbLookTest, AnImageThatCannotBeReadGivesAWarningAndNoColour) {
  const std::string pack = OsgbScene().Pack(0);
  const auto tile = ReadTileTree(pack, "a/Tile.osgb");
  ASSERT_TRUE(tile.ok()) << tile.status();
  const TreeLevel finest = LevelOf(*tile, 2);
  const RimColours rim = SampleTreeRim(*tile, finest, Spots(finest), 2, "a/Tile.osgb");
  EXPECT_THAT(rim.colours, Each(std::nullopt));
  EXPECT_THAT(rim.warnings, ElementsAre(HasSubstr("a/Tile.osgb: image \"tile_0.jpg\""), HasSubstr("tile_0.jpg")));
}

// One triangle of each of two geometries without an image: the first has a material.
TileTree PlainTile() {
  TileTree tile;
  tile.packed = {{"Tile.osgb", ""}};
  TreeFile& file = tile.files.emplace_back();
  file.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 1, 0}, {1, 2, 0}};
  file.uv.resize(6);
  file.triangles = {{0, 1, 2}, {3, 4, 5}};
  file.geometries = {{0, 3, 0, 1, -1, {51, 153, 77}, 0, true}, {3, 3, 1, 1, -1, {255, 255, 255}, 0, false}};
  tile.pieces.emplace_back();
  tile.levels = 1;
  return tile;
}

TEST(OsgbLookTest, WithoutAnImageTheColourOfTheMaterialCounts) {
  const TileTree tile = PlainTile();
  const TreeLevel finest = LevelOf(tile, 0);
  const RimColours rim = SampleTreeRim(tile, finest, Spots(finest), 2, "a/Tile.osgb");
  EXPECT_THAT(rim.colours, ElementsAre(Rgb{51, 153, 77}, std::nullopt));
  EXPECT_THAT(rim.warnings, IsEmpty());
}

TEST(OsgbLookTest, TheOtherFilesOfTheTileGoWithIt) {
  const std::string pack = OsgbScene().Pack(1);
  const auto tile = ReadTileTree(pack, "a/Tile.osgb");
  ASSERT_TRUE(tile.ok()) << tile.status();
  const TileLook look = ReadTreeLook("Data/Tile_+001_+000/Tile_+001_+000.osgb", *tile);
  EXPECT_EQ(look.files.images.size(), 5u);
  EXPECT_THAT(look.files.images, Each(HasSubstr("Data/Tile_+001_+000/Tile_+001_+000_L")));
}

}  // namespace
}  // namespace tilemend
