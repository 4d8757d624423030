#include "common/codec/face_looks.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_replace.h"
#include "tests/support/osgb_scene.h"

namespace tilemend {
namespace {

using ::testing::SizeIs;

constexpr char kTexturedObj[] =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0.1 0.2\nvt 0.3 0.4\nusemtl wall\nf 1/1 2/2 3/1\nusemtl roof\nf 3/1 2/2 1/1\n";

std::vector<uint64_t> ObjLooks(const std::string& text) {
  const auto obj = ParseTexturedObj(text, "a.obj");
  EXPECT_TRUE(obj.ok()) << obj.status();
  return ObjFaceLooks(obj->textures, obj->file.mesh.triangles);
}

TEST(FaceLooksTest, MaterialsAndTextureCoordinatesOfAnObjCount) {
  const std::vector<uint64_t> looks = ObjLooks(kTexturedObj);
  ASSERT_THAT(looks, SizeIs(2));
  const auto other_name = ObjLooks(absl::StrReplaceAll(kTexturedObj, {{"roof", "rood"}}));
  EXPECT_EQ(other_name[0], looks[0]);
  EXPECT_NE(other_name[1], looks[1]);
  const auto other_place = ObjLooks(absl::StrReplaceAll(kTexturedObj, {{"0.4", "0.5"}}));
  EXPECT_NE(other_place[0], looks[0]);
  // The number of a texture coordinate is not what counts.
  EXPECT_EQ(ObjLooks(absl::StrReplaceAll(kTexturedObj, {{"vt 0.1 0.2\n", "vt 0.1 0.2\nvt 0.1 0.2\n"}, {"2/2", "2/3"}})),
            looks);
}

TEST(FaceLooksTest, ColoursOfTheVerticesOfAnObjCount) {
  const std::string coloured =
      "v 0 0 0\nv 1 0 0 0.1 0.2 0.3\nv 0 1 0 0.4 0.5 0.6\nv 1 1 0\nv 2 1 0\nf 1 2 3\nf 2 4 3\nf 4 5 1\n";
  const std::vector<uint64_t> looks = ObjLooks(coloured);
  ASSERT_THAT(looks, SizeIs(3));
  const auto changed = ObjLooks(absl::StrReplaceAll(coloured, {{"0.3", "0.4"}}));
  EXPECT_NE(changed[0], looks[0]);
  EXPECT_NE(changed[1], looks[1]);
  EXPECT_EQ(changed[2], looks[2]);
  EXPECT_NE(ObjLooks(absl::StrReplaceAll(coloured, {{" 0.4 0.5 0.6", ""}}))[0], looks[0]);
  EXPECT_EQ(ObjLooks(absl::StrReplaceAll(coloured, {{"0.6\n", " 0.6 # green\r\n"}})), looks);
}

TEST(FaceLooksTest, AppendPatchLeavesTheLooksOfAnObj) {
  const std::string coloured = "v 0 0 0\nv 1 0 0 0.1 0.2 0.3\nv 0 1 0 0.4 0.5 0.6\nf 1 2 3\n";
  FilePatch patch;
  patch.new_points = {{1, 1, 0}};
  patch.like = {1};
  patch.triangles = {{2, 1, 3}};
  const auto appended = AppendPatch(MeshFormat::kObj, coloured, patch, "a.obj");
  ASSERT_TRUE(appended.ok()) << appended.status();
  const std::vector<uint64_t> looks = ObjLooks(*appended);
  ASSERT_THAT(looks, SizeIs(2));
  EXPECT_EQ(looks[0], ObjLooks(coloured)[0]);
}

std::string Ply(const std::string& marks, const std::string& colour = "9") {
  const bool marked = !marks.empty();
  return absl::StrCat(
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
      "property uchar red\nelement face 2\nproperty list uchar int vertex_indices\nproperty int label\n",
      marked ? "property uchar tilemend_filled\n" : "", "end_header\n0 0 0 9\n1 0 0 ", colour,
      "\n0 1 0 9\n1 1 1 9\n3 0 1 2 5", marked ? " 0" : "", "\n3 2 0 3 6", marked ? " 0" : "", "\n");
}

std::vector<uint64_t> PlyLooks(const std::string& text) {
  const auto looks = PlyFaceLooks(text, "a.ply");
  EXPECT_TRUE(looks.ok()) << looks.status();
  return looks.value_or(std::vector<uint64_t>());
}

TEST(FaceLooksTest, PropertiesOfVerticesAndFacesOfAPlyCount) {
  const std::vector<uint64_t> looks = PlyLooks(Ply(""));
  ASSERT_THAT(looks, SizeIs(2));
  const auto other = PlyLooks(Ply("", "8"));
  EXPECT_NE(other[0], looks[0]);
  EXPECT_EQ(other[1], looks[1]);
  EXPECT_NE(PlyLooks(absl::StrReplaceAll(Ply(""), {{"2 5", "2 7"}}))[0], looks[0]);
}

TEST(FaceLooksTest, TheMarkOfFilledFacesDoesNotCount) { EXPECT_EQ(PlyLooks(Ply("marked")), PlyLooks(Ply(""))); }

TEST(FaceLooksTest, AppendPatchLeavesTheLooksOfABinaryPly) {
  FilePatch mesh;
  mesh.new_points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  mesh.like = {-1, -1, -1, -1};
  mesh.triangles = {{0, 1, 2}, {2, 1, 3}};
  const std::string file = NewPlyFile(mesh, NumberType::kFloat32, FaceMark::kNone);
  FilePatch patch;
  patch.new_points = {{2, 2, 0}};
  patch.like = {0};
  patch.triangles = {{3, 4, 2}};
  const auto appended = AppendPatch(MeshFormat::kPly, file, patch, "a.ply");
  ASSERT_TRUE(appended.ok()) << appended.status();
  std::vector<uint64_t> looks = PlyLooks(*appended);
  ASSERT_THAT(looks, SizeIs(3));
  looks.pop_back();
  EXPECT_EQ(looks, PlyLooks(file));
}

TEST(FaceLooksTest, ACutOffPlyIsRefused) {
  EXPECT_FALSE(PlyFaceLooks(Ply("").substr(0, Ply("").size() - 6), "a.ply").ok());
}

TEST(TreeFaceLooksTest, ImagesAndTextureCoordinatesTell) {
  const std::string pack = OsgbScene(OsgbScene::Pond::kHole, 80, "image a").Pack(0);
  const std::string other = OsgbScene(OsgbScene::Pond::kHole, 80, "image b").Pack(0);
  const auto tile = ReadTileTree(pack, "a.osgb"), same = ReadTileTree(pack, "b.osgb"),
             changed = ReadTileTree(other, "c");
  ASSERT_TRUE(tile.ok() && same.ok() && changed.ok());
  const std::vector<uint64_t> looks = TreeFaceLooks(*tile, LevelOf(*tile, 2));
  EXPECT_EQ(looks.size(), LevelOf(*tile, 2).mesh.triangles.size());
  EXPECT_EQ(looks, TreeFaceLooks(*same, LevelOf(*same, 2)));
  EXPECT_NE(looks[0], TreeFaceLooks(*changed, LevelOf(*changed, 2))[0]);
  EXPECT_NE(looks[0], looks[5]) << "other texture coordinates";
}

TEST(TreeFaceLooksTest, TheColourOfTheMaterialTells) {
  const std::string pack = OsgbScene().Pack(0);
  auto tile = ReadTileTree(pack, "a.osgb");
  ASSERT_TRUE(tile.ok()) << tile.status();
  const TreeLevel level = LevelOf(*tile, 0);
  const std::vector<uint64_t> looks = TreeFaceLooks(*tile, level);
  TreeGeometry& geometry =
      tile->files[tile->pieces[level.parts[0].piece].file].geometries[level.parts[0].geometries[0]];
  geometry.colour = {1, 2, 3};
  EXPECT_NE(TreeFaceLooks(*tile, level)[0], looks[0]);
  geometry.colour = {1, 2, 4};
  const uint64_t other = TreeFaceLooks(*tile, level)[0];
  geometry.has_colour = !geometry.has_colour;
  EXPECT_NE(TreeFaceLooks(*tile, level)[0], other);
}

}  // namespace
}  // namespace tilemend
