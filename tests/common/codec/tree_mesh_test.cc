#include "common/codec/tree_mesh.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tilemend {
namespace {

TileTree OneTriangle() {
  TileTree tile;
  TreeFile file;
  file.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  file.uv.resize(3);
  file.triangles = {{0, 1, 2}};
  file.geometries.resize(1);
  file.geometries[0].vertex_count = 3;
  file.geometries[0].triangle_count = 1;
  tile.files = {file};
  tile.packed.resize(1);
  tile.pieces = {TreePiece()};
  tile.levels = 1;
  return tile;
}

TEST(FinestMeshTest, IsThatOfTheLastLevel) {
  const auto file = FinestMesh(OneTriangle(), 99, "T", NoFaces::kRefuse);
  ASSERT_TRUE(file.ok()) << file.status();
  EXPECT_EQ(file->mesh.triangles.size(), 1u);
  EXPECT_EQ(file->file_bytes, 99);
  EXPECT_THAT(file->level_nodes, testing::ElementsAre(1));
}

TEST(FinestMeshTest, RefusesATileWithoutTrianglesUnlessItMayHaveNone) {
  TileTree tile = OneTriangle();
  tile.files[0].triangles.clear();
  tile.files[0].geometries[0].triangle_count = 0;
  EXPECT_EQ(FinestMesh(tile, 1, "T", NoFaces::kRefuse).status().message(), "T: the file has no triangles");
  EXPECT_TRUE(FinestMesh(tile, 1, "T", NoFaces::kAccept).ok());
}

}  // namespace
}  // namespace tilemend
