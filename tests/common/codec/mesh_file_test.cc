#include "common/codec/mesh_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "absl/strings/str_cat.h"

namespace tilemend {
namespace {

TEST(MeshFormatOfTest, GoesByTheExtensionInAnyCase) {
  EXPECT_EQ(*MeshFormatOf("a/b.c/tile.PLY"), MeshFormat::kPly);
  EXPECT_EQ(*MeshFormatOf("Tile_+000_+014.obj"), MeshFormat::kObj);
  EXPECT_EQ(*MeshFormatOf("x.y.Off"), MeshFormat::kOff);
  EXPECT_EQ(*MeshFormatOf("Tile.osgb"), MeshFormat::kTileTree);
}

TEST(MeshFormatOfTest, RefusesOthersByName) {
  for (const char* extension : {".glb", ".gltf", ".b3dm", ".las", ".fbx", ".dae", ".gz", ".3ds"}) {
    const absl::Status status = MeshFormatOf(absl::StrCat("dir/tile", extension)).status();
    EXPECT_EQ(status.code(), absl::StatusCode::kInvalidArgument);
    EXPECT_EQ(status.message(),
              absl::StrCat("dir/tile", extension, ": ", extension,
                           " files are not read; accepted: .ply, .obj, .off, .stl, .osgb, .json (a tileset)"));
  }
  EXPECT_EQ(MeshFormatOf("a.ply/tile").status().message(),
            "a.ply/tile: no file extension; accepted: .ply, .obj, .off, .stl, .osgb, .json (a tileset)");
  EXPECT_FALSE(MeshFormatOf(".ply").ok());
}

TEST(ReadMeshFileTest, ReadsWhatIsThere) {
  const std::string path = ::testing::TempDir() + "/mesh_file_test.obj";
  const std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  std::ofstream(path) << text;
  const auto file = ReadMeshFile(path);
  ASSERT_TRUE(file.ok()) << file.status();
  EXPECT_EQ(file->format, MeshFormat::kObj);
  EXPECT_EQ(file->mesh.points.size(), 3u);
  EXPECT_EQ(file->file_bytes, static_cast<int64_t>(text.size()));
  EXPECT_EQ(ReadMeshFile(path + "x.obj").status().code(), absl::StatusCode::kNotFound);
  EXPECT_EQ(ReadMeshFile(::testing::TempDir() + "/x.glb").status().code(), absl::StatusCode::kInvalidArgument);
}

}  // namespace
}  // namespace tilemend
