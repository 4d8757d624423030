#include "worker/delivery/obj_delivery.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/codec/obj.h"
#include "tests/support/osgb_scene.h"

namespace tilemend {
namespace {

TEST(ObjDeliveryTest, CoordinatesAndPlacesAreReadAsTheyWere) {
  const std::string pack = OsgbScene().Pack(1);
  const DeliveryTile tile = DeliveryOfTree(*ReadTileTree(pack, "a.osgb"), DeliveryLevels::kFinest);
  const std::vector<DeliveryFile> files = ObjFilesOf(tile, "a");
  ASSERT_EQ(files.size(), 6u);
  EXPECT_EQ(files[0].name, "a.obj");
  EXPECT_EQ(files[1].name, "a.mtl");
  EXPECT_EQ(files[2].name, "a_0.jpg");
  EXPECT_EQ(files[2].bytes, tile.images[0]);
  const auto read = ParseTexturedObj(files[0].bytes, "a.obj");
  ASSERT_TRUE(read.ok()) << read.status();
  size_t point = 0, triangle = 0;
  for (const DeliveryPiece& piece : tile.pieces) {
    for (const DeliverySurface& surface : piece.surfaces) {
      for (size_t v = 0; v < surface.mesh.points.size(); ++v) {
        EXPECT_EQ(read->file.mesh.points.at(point), surface.mesh.points[v]);
        EXPECT_EQ(read->textures.coordinates.at(point++), surface.uv[v]);
      }
      triangle += surface.mesh.triangles.size();
    }
  }
  EXPECT_EQ(read->file.mesh.triangles.size(), triangle);
  EXPECT_EQ(read->textures.materials.size(), 4u);
  EXPECT_EQ(read->textures.libraries, std::vector<std::string>{"a.mtl"});
}

TEST(ObjDeliveryTest, AFaceThatNamesAVertexTwiceIsKept) {
  DeliverySurface flat;
  flat.mesh = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 0}, {0, 1, 2}, {2, 2, 2}}};
  flat.uv = {{0, 0}, {1, 0}, {0, 1}};
  DeliveryTile tile;
  tile.pieces.resize(2, {-1, 0, {flat}});
  const auto read = ParseTexturedObj(ObjFilesOf(tile, "a")[0].bytes, "a.obj");
  ASSERT_TRUE(read.ok()) << read.status();
  ASSERT_EQ(read->file.mesh.triangles.size(), 6U);
  for (size_t t = 0; t < 6; ++t) {
    for (size_t k = 0; k < 3; ++k) {
      const auto v = static_cast<size_t>(read->file.mesh.triangles[t][k]);
      const auto place = static_cast<size_t>(read->textures.corners[t][k]);
      const auto own = static_cast<size_t>(flat.mesh.triangles[t % 3][k]);
      EXPECT_EQ(read->file.mesh.points.at(v), flat.mesh.points[own]);
      EXPECT_EQ(read->textures.coordinates.at(place), flat.uv[own]);
    }
  }
}

TEST(ObjDeliveryTest, AColourIsAMaterial) {
  const TriMesh mesh{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}, {{0, 1, 2}}};
  const std::vector<ColourRun> runs = {{0, {255, 0, 0}}};
  const std::vector<DeliveryFile> files = ObjFilesOf(DeliveryOfColours(mesh, runs), "a");
  ASSERT_EQ(files.size(), 2u);
  EXPECT_EQ(files[0].bytes,
            "mtllib a.mtl\ng tilemend_filled\nv 0 0 0\nv 1 0 0\nv 1 1 0\nusemtl colour_ff0000\nf 1 2 3\n");
  EXPECT_EQ(files[1].bytes, "newmtl colour_ff0000\nKd 1.000000 0.000000 0.000000\n");
}

TEST(ObjDeliveryTest, FilledSurfaceIsTheGroupAtTheEnd) {
  DeliverySurface own, filled;
  own.mesh = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  filled.mesh = {{{1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  filled.is_filled = true;
  DeliveryTile tile;
  tile.pieces.resize(2);
  tile.pieces[0].surfaces = {filled, own};
  tile.pieces[1].surfaces = {own, filled};
  const std::string obj = ObjFilesOf(tile, "a")[0].bytes;
  const auto read = ParseTexturedObj(obj, "a.obj");
  ASSERT_TRUE(read.ok()) << read.status();
  ASSERT_EQ(read->textures.groups.size(), 1u);
  EXPECT_EQ(read->textures.groups[0].first, 2);
  EXPECT_TRUE(read->textures.groups[0].is_filled);
  for (const size_t t : {size_t{2}, size_t{3}}) {
    EXPECT_EQ(read->file.mesh.points.at(static_cast<size_t>(read->file.mesh.triangles.at(t)[1])), Point3(1, 1, 0));
  }
}

}  // namespace
}  // namespace tilemend
