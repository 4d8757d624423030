#include "worker/materials/textured_surface.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/codec/tree/tile_tree.h"
#include "tests/support/osgb_scene.h"

namespace tilemend {
namespace {

using testing::ElementsAre;

ObjFile FourTriangles() {
  ObjFile obj;
  obj.file.mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  obj.file.mesh.triangles.assign(5, {0, 1, 2});
  obj.textures.materials = {"image", "plain", "unknown"};
  obj.textures.runs = {{1, 0}, {3, 1}, {4, 2}};
  obj.textures.coordinates = {{0.F, 0.F}, {1.F, 0.F}, {0.F, 1.F}};
  obj.textures.corners = {{0, 1, 2}, {0, 1, 2}, {0, -1, 2}, {-1, -1, -1}, {0, 1, 2}};
  return obj;
}

TEST(TexturedSurfaceTest, GroupsTrianglesByImageAndColour) {
  TileLook look;
  look.materials = {{"image", {{}, "a.png"}}, {"plain", {Rgb{1, 2, 3}, ""}}};
  const TexturedSurface surface = TexturedSurfaceOf(FourTriangles(), look);
  ASSERT_EQ(surface.groups.size(), 3U);
  EXPECT_THAT(surface.groups[0].triangles, ElementsAre(0, 2, 4));
  EXPECT_EQ(surface.groups[0].image, "");
  EXPECT_EQ(surface.groups[0].colour, std::nullopt);
  EXPECT_EQ(surface.groups[1].colour, (Rgb{1, 2, 3}));
  EXPECT_THAT(surface.groups[1].triangles, ElementsAre(3));
  EXPECT_EQ(surface.groups[2].image, "a.png");
  EXPECT_THAT(surface.groups[2].triangles, ElementsAre(1));
  EXPECT_EQ(surface.PlacesOf(1)[1][0], 1);
}

TEST(TexturedSurfaceTest, ATreeGivesItsFinestLevel) {
  const std::string image = "\xff\xd8\xff of the ground", pack = OsgbScene(OsgbScene::Pond::kHole, 80, image).Pack(0);
  const auto tile = ReadTileTree(pack, "a/Tile.osgb");
  ASSERT_TRUE(tile.ok()) << tile.status();
  const auto of_tree = TexturedSurfaceOfTree(pack, "a/Tile.osgb");
  ASSERT_TRUE(of_tree.ok()) << of_tree.status();
  const TexturedSurface& surface = *of_tree;
  const TreeLevel finest = LevelOf(*tile, 2);
  EXPECT_EQ(surface.mesh.triangles, finest.mesh.triangles);
  ASSERT_EQ(surface.groups.size(), 4U) << "a file has an image of its own";
  size_t triangles = 0;
  for (const TexturedSurface::Group& group : surface.groups) {
    EXPECT_EQ(surface.encoded.at(group.image), image);
    triangles += group.triangles.size();
    const auto places = surface.PlacesOf(group.triangles[0]);
    EXPECT_GE(places[0][0], 0);
    EXPECT_LE(places[0][0], 1);
  }
  EXPECT_EQ(triangles, surface.mesh.triangles.size());
}

TEST(TexturedSurfaceTest, GeometryOfATreeWithoutAnImageHasTheColourOfItsMaterial) {
  const std::string image = "\xff\xd8\xff of the ground", pack = OsgbScene(OsgbScene::Pond::kHole, 80, image).Pack(0);
  const auto tile = ReadTileTree(pack, "a/Tile.osgb");
  ASSERT_TRUE(tile.ok()) << tile.status();
  const Rgb plain{51, 153, 77};
  std::vector<TreeEdit> edits(tile->files.size());
  const TreeLevel finest = LevelOf(*tile, tile->levels - 1);
  const TreePiece& piece = tile->pieces[static_cast<size_t>(finest.parts[0].piece)];
  edits[static_cast<size_t>(piece.file)].patches.push_back(
      {{{1, 1, 2}, {2, 1, 2}, {1, 2, 2}}, {{0, 1, 2}}, plain, piece.part});
  const auto changed = ChangeTileTree(*tile, edits, "a/Tile.osgb");
  ASSERT_TRUE(changed.ok()) << changed.status();
  const auto surface = TexturedSurfaceOfTree(*changed, "a/Tile.osgb");
  ASSERT_TRUE(surface.ok()) << surface.status();
  ASSERT_EQ(surface->groups.size(), 5U);
  EXPECT_EQ(surface->groups[0].image, "");
  EXPECT_EQ(surface->groups[0].colour, plain);
  EXPECT_EQ(surface->groups[0].triangles.size(), 1U);
  EXPECT_EQ(surface->groups[1].colour, std::nullopt);
}

}  // namespace
}  // namespace tilemend
