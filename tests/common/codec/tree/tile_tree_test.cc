#include "common/codec/tree/tile_tree.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/support/osgb_scene.h"
#include "tests/support/tileset_scene.h"

namespace tilemend {
namespace {

struct Case {
  std::string pack, name;
  size_t coarsest = 0;  // parts of the coarsest level
};

std::vector<Case> Cases() {
  return {{OsgbScene(OsgbScene::Pond::kHole, 80).Pack(0), "a/Tile.osgb", 1},
          {OsgbScene(OsgbScene::Pond::kHole, 161).Pack(0), "a/Tile.osgb", 1},
          {TilesetScene().Pack(), "a/tileset.json", 2}};
}

// A case's tile with one patch in its last piece.
struct Patched {
  explicit Patched(const Case& tile) : before(*ReadTileTree(tile.pack, tile.name)), edits(before.files.size()) {
    const TreePiece& piece = before.pieces.back();
    file = static_cast<size_t>(piece.file);
    TreePatch& patch = edits[file].patches.emplace_back();
    patch.points = {{1, 1, 2}, {2, 1, 2}, {1, 2, 2}};
    patch.triangles = {{0, 1, 2}};
    patch.colour = {10, 20, 30};
    patch.part = piece.part;
  }
  TileTree before;
  std::vector<TreeEdit> edits;
  size_t file = 0;
};

TEST(TileTreeTest, LevelsAreFinerAndFiner) {
  for (const Case& tile : Cases()) {
    SCOPED_TRACE(tile.name);
    const auto tree = ReadTileTree(tile.pack, tile.name);
    ASSERT_TRUE(tree.ok()) << tree.status();
    ASSERT_EQ(tree->levels, 3);
    size_t coarser = 0;
    for (int32_t l = 0; l < 3; ++l) {
      const TreeLevel level = LevelOf(*tree, l);
      EXPECT_EQ(level.parts.size(), l == 2 ? 4 * tile.coarsest : l == 0 ? tile.coarsest : level.parts.size());
      EXPECT_GT(level.mesh.triangles.size(), 3 * coarser);
      coarser = level.mesh.triangles.size();
    }
  }
}

TEST(TileTreeTest, APieceThatNothingReplacesIsInTheFinestLevel) {
  const std::string pack = OsgbScene().Pack(0, "_L2_3.osgb");
  const auto tree = ReadTileTree(pack, "a/Tile.osgb");
  ASSERT_TRUE(tree.ok()) << tree.status();
  const TreeLevel finest = LevelOf(*tree, 2);
  ASSERT_EQ(finest.parts.size(), 4u);
  EXPECT_EQ(tree->pieces[static_cast<size_t>(finest.parts[0].piece)].level, 1);
}

TEST(TileTreeTest, ChangesAreReadBack) {
  for (const Case& tile : Cases()) {
    SCOPED_TRACE(tile.name);
    Patched patched(tile);
    const size_t f = patched.file;
    const TreeFile& was = patched.before.files[f];
    std::vector<bool>& drop = patched.edits[f].drop;
    drop.assign(was.triangles.size(), false);
    drop[0] = drop[1] = true;
    const auto bytes = ChangeTileTree(patched.before, patched.edits, tile.name);
    ASSERT_TRUE(bytes.ok()) << bytes.status();
    const auto after = ReadTileTree(*bytes, tile.name);
    ASSERT_TRUE(after.ok()) << after.status();
    EXPECT_EQ(after->files[f].triangles.size() + 1, was.triangles.size());
    EXPECT_EQ(after->files[f].points.size(), was.points.size() + 3);
    const TreeGeometry& added = after->files[f].geometries.back();
    EXPECT_EQ(after->files[f].points[static_cast<size_t>(added.first_vertex)], Point3(1, 1, 2));
    EXPECT_TRUE(added.has_colour);
    EXPECT_EQ(added.colour, (Rgb{10, 20, 30}));
  }
}

TEST(TileTreeTest, NewGeometryHasItsImage) {
  for (const Case& tile : Cases()) {
    SCOPED_TRACE(tile.name);
    Patched patched(tile);
    TreePatch& patch = patched.edits[patched.file].patches[0];
    patch.uv = {{0.25F, 0.5F}, {1, 0}, {0, 1}};
    patch.image = "\xff\xd8\xff of the fill";
    patch.image_name = "fill.jpg";
    const auto bytes = ChangeTileTree(patched.before, patched.edits, tile.name);
    ASSERT_TRUE(bytes.ok()) << bytes.status();
    const auto after = ReadTileTree(*bytes, tile.name);
    ASSERT_TRUE(after.ok()) << after.status();
    const TreeFile& file = after->files[patched.file];
    const TreeGeometry& added = file.geometries.back();
    ASSERT_GE(added.texture, 0);
    const TreeImage& image = file.images[static_cast<size_t>(added.texture)];
    EXPECT_EQ(after->packed[patched.file].bytes.substr(image.offset, image.size), patch.image);
    EXPECT_EQ(file.uv[static_cast<size_t>(added.first_vertex)], (std::array<float, 2>{0.25F, 0.5F}));
  }
}

TEST(TileTreeTest, WithoutChangesTheBytesStay) {
  for (const Case& tile : Cases()) {
    const auto tree = ReadTileTree(tile.pack, tile.name);
    ASSERT_TRUE(tree.ok()) << tree.status();
    EXPECT_EQ(*ChangeTileTree(*tree, std::vector<TreeEdit>(tree->files.size()), tile.name), tile.pack);
  }
}

TEST(TileTreeTest, GivesTheImagesOfAFile) {
  const std::string image = "\x89PNG of a test";
  for (const Case& tile : {Case{OsgbScene(OsgbScene::Pond::kHole, 80, image).Pack(0), "a/Tile.osgb"},
                           Case{TilesetScene{.image = image}.Pack(), "a/tileset.json"}}) {
    const auto tree = ReadTileTree(tile.pack, tile.name);
    ASSERT_TRUE(tree.ok()) << tree.status();
    const PackedFile& file = tree->packed[static_cast<size_t>(tree->pieces.front().file)];
    EXPECT_EQ(TreeImageIn(file.bytes, 0, file.name), image);
    EXPECT_EQ(TreeImageIn(file.bytes, 1, file.name), "");
    EXPECT_EQ(TreeImageIn("damaged", 0, file.name), "");
  }
}

}  // namespace
}  // namespace tilemend
