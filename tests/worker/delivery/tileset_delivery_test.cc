#include "worker/delivery/tileset_delivery.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/codec/tree/tile_tree.h"
#include "common/util/file_pack.h"
#include "tests/support/osgb_scene.h"

namespace tilemend {
namespace {

std::string PackOf(const std::vector<DeliveryFile>& files) {
  std::vector<PackedFile> packed;
  for (const DeliveryFile& file : files) packed.push_back({file.name, file.bytes});
  return PackFiles(packed);
}

TEST(TilesetDeliveryTest, AllLevelsAreReadAsTheyWere) {
  const std::string pack = OsgbScene().Pack(1);
  const TileTree before = *ReadTileTree(pack, "a.osgb");
  const auto files = TilesetFilesOf(DeliveryOfTree(before, DeliveryLevels::kAll), "a", Point3::Zero());
  ASSERT_TRUE(files.ok()) << files.status();
  ASSERT_EQ(files->size(), 10u);
  EXPECT_EQ((*files)[0].name, "a.json");
  const std::string written = PackOf(*files);
  const auto after = ReadTileTree(written, "a.json");
  ASSERT_TRUE(after.ok()) << after.status();
  ASSERT_EQ(after->levels, 3);
  for (int32_t l = 0; l < 3; ++l) {
    const TreeLevel was = LevelOf(before, l), is = LevelOf(*after, l);
    ASSERT_EQ(is.mesh.triangles.size(), was.mesh.triangles.size());
    for (size_t t = 0; t < was.mesh.triangles.size(); ++t) {
      for (size_t k = 0; k < 3; ++k) {
        EXPECT_EQ(is.mesh.points[static_cast<size_t>(is.mesh.triangles[t][k])],
                  was.mesh.points[static_cast<size_t>(was.mesh.triangles[t][k])])
            << "to the bit";
      }
    }
  }
  for (const DeliveryFile& file : *files) {
    if (file.name.ends_with(".glb")) {
      EXPECT_EQ(TreeImageIn(file.bytes, 0, file.name), "\xff\xd8\xff no image");
    }
  }
}

TEST(TilesetDeliveryTest, AFarOriginKeepsMillimetres) {
  const Point3 far(512000, 5400000, 0);
  TriMesh mesh{{{0.001, 0, 3}, {1, 0.002, 3}, {0, 1, 3.003}}, {{0, 1, 2}}};
  for (Point3& point : mesh.points) point += far;
  const std::vector<ColourRun> runs = {{0, {}}};
  const auto files = TilesetFilesOf(DeliveryOfColours(mesh, runs), "a", far);
  ASSERT_TRUE(files.ok()) << files.status();
  const std::string written = PackOf(*files);
  const auto tree = ReadTileTree(written, "a.json");
  ASSERT_TRUE(tree.ok()) << tree.status();
  const TreeLevel level = LevelOf(*tree, 0);
  for (size_t v = 0; v < 3; ++v) EXPECT_LT((level.mesh.points.at(v) - mesh.points[v]).norm(), 1e-6);
}

}  // namespace
}  // namespace tilemend
