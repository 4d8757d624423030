#include "worker/delivery/osgb_delivery.h"

#include <gtest/gtest.h>

#include "common/codec/tree/tile_tree.h"
#include "common/util/file_pack.h"
#include "tests/support/osgb_scene.h"

namespace tilemend {
namespace {

std::string OsgbPackOf(const std::vector<DeliveryFile>& files) {
  std::vector<PackedFile> packed;
  for (const DeliveryFile& file : files) packed.push_back({file.name, file.bytes});
  return PackFiles(packed);
}

std::string ImageOf(const TileTree& tree, const TreePiece& piece, const TreeGeometry& geometry) {
  const auto file = static_cast<size_t>(piece.file);
  const TreeImage& image = tree.files[file].images.at(static_cast<size_t>(geometry.texture));
  return std::string(tree.packed[file].bytes.substr(image.offset, image.size));
}

TEST(OsgbDeliveryTest, AllLevelsAreReadAsTheyWere) {
  const std::string pack = OsgbScene().Pack(0);
  const TileTree was = *ReadTileTree(pack, "a.osgb");
  const auto files = OsgbFilesOf(DeliveryOfTree(was, DeliveryLevels::kAll), "b");
  ASSERT_TRUE(files.ok()) << files.status();
  EXPECT_EQ(files->at(0).name, "b.osgb");
  const std::string again = OsgbPackOf(*files);
  const auto is = ReadTileTree(again, "b.osgb");
  ASSERT_TRUE(is.ok()) << is.status();
  ASSERT_EQ(is->levels, was.levels);
  ASSERT_EQ(is->pieces.size(), was.pieces.size());
  for (size_t p = 0; p < was.pieces.size(); ++p) {
    EXPECT_EQ(is->pieces[p].parent, was.pieces[p].parent) << p;
    EXPECT_EQ(is->pieces[p].is_finest, was.pieces[p].is_finest) << p;
    EXPECT_NEAR(is->pieces[p].geometric_error, was.pieces[p].geometric_error, 1e-6 * was.pieces[p].geometric_error);
  }
  for (int32_t l = 0; l < was.levels; ++l) {
    const TreeLevel a = LevelOf(*is, l), b = LevelOf(was, l);
    ASSERT_EQ(a.mesh.triangles.size(), b.mesh.triangles.size());
    for (size_t t = 0; t < a.mesh.triangles.size(); ++t) {
      for (size_t k = 0; k < 3; ++k) {
        ASSERT_EQ(a.mesh.points[a.mesh.triangles[t][k]], b.mesh.points[b.mesh.triangles[t][k]]);
      }
    }
  }
}

TEST(OsgbDeliveryTest, ImagesAndPlacesKeepTheirBytes) {
  DeliveryTile tile;
  tile.images = {"\xff\xd8\xff a photograph"};
  DeliverySurface surface;
  surface.mesh = {{{0.1F, 0.2F, 0.3F}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  surface.uv = {{0.1F, 0.2F}, {1, 0}, {0, 1}};
  surface.image = 0;
  DeliverySurface plain;
  plain.mesh = surface.mesh;
  plain.colour = {10, 20, 30};
  tile.pieces.emplace_back().surfaces = {surface, plain};
  const auto files = OsgbFilesOf(tile, "a");
  ASSERT_TRUE(files.ok()) << files.status();
  ASSERT_EQ(files->size(), 1U);
  const std::string pack = OsgbPackOf(*files);
  const auto tree = ReadTileTree(pack, "a.osgb");
  ASSERT_TRUE(tree.ok()) << tree.status();
  const TreeFile& file = tree->files.at(0);
  ASSERT_EQ(file.geometries.size(), 2U);
  EXPECT_EQ(ImageOf(*tree, tree->pieces[0], file.geometries[0]), tile.images[0]);
  EXPECT_EQ(file.images[0].name, "a_0.jpg");
  EXPECT_EQ(file.uv[0], surface.uv[0]);
  EXPECT_EQ(file.points[0], surface.mesh.points[0]);
  EXPECT_EQ(file.geometries[1].texture, -1);
  EXPECT_EQ(file.geometries[1].colour, plain.colour);
}

}  // namespace
}  // namespace tilemend
