#include "worker/service/delivery_stage.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/codec/ply_colours.h"
#include "common/codec/tree/tile_tree.h"
#include "common/util/file_pack.h"
#include "tests/support/osgb_scene.h"

namespace tilemend {
namespace {

v1::AssembleInput InputFor(const std::string& path, const std::string& format, const std::string& output) {
  v1::AssembleInput input;
  input.mutable_tile()->set_root("/scene");
  input.mutable_tile()->set_path(path);
  input.set_output_format(format);
  input.set_output(output);
  input.set_x_middle(100.4);
  input.set_y_middle(200);
  return input;
}

TEST(DeliverTileTest, ATreeIsWrittenInOtherFormats) {
  const std::string pack = OsgbScene().Pack(0);
  const auto tileset = DeliverTile(InputFor("a/a.osgb", "3dtiles", "a/b.json"), {pack, nullptr, {}, ""});
  ASSERT_TRUE(tileset.ok()) << tileset.status();
  EXPECT_EQ(tileset->files.size(), 10u);
  EXPECT_EQ(tileset->files[0].name, "b.json");
  const auto obj = DeliverTile(InputFor("a/a.osgb", "obj", "a/b.obj"), {pack, nullptr, {}, ""});
  ASSERT_TRUE(obj.ok()) << obj.status();
  EXPECT_EQ(obj->files.size(), 6u);
  EXPECT_EQ(obj->files[0].name, "b.obj");
  const auto ply = DeliverTile(InputFor("a/a.osgb", "ply", "a/b.ply"), {pack, nullptr, {}, ""});
  ASSERT_TRUE(ply.ok()) << ply.status();
  EXPECT_EQ(ply->files.size(), 5u);
  EXPECT_EQ(ply->files[0].name, "b.ply");
}

TEST(DeliverTileTest, ACellWithoutATileIsItsPatch) {
  TilePatch patch;
  patch.patch.new_points = {{100, 200, 3}, {101, 200, 3}, {100, 201, 3}};
  patch.patch.triangles = {{0, 1, 2}};
  patch.runs = {{0, true, {1, 2, 3}}};
  const auto made = DeliverTile(InputFor("", "3dtiles", "a/b.json"), {"", &patch, {}, ""});
  ASSERT_TRUE(made.ok()) << made.status();
  const std::string pack =
      PackFiles({{made->files[0].name, made->files[0].bytes}, {made->files.at(1).name, made->files[1].bytes}});
  const auto tree = ReadTileTree(pack, "b.json");
  ASSERT_TRUE(tree.ok()) << tree.status();
  EXPECT_EQ(LevelOf(*tree, 0).mesh.points, patch.patch.new_points);
}

TEST(DeliverTileTest, ColoursOfVerticesAreInPlyAndElseInAWarning) {
  const std::string obj = "v 0 0 0 0 0.2 0\nv 1 0 0 0 0.4 0\nv 0 1 0 0 0.6 0\nf 1 2 3\n";
  for (const std::string format : {"ply", "3dtiles", "osgb"}) {
    const auto made = DeliverTile(InputFor("a/a.obj", format, "a/b"), {obj, nullptr, {}, ""});
    ASSERT_TRUE(made.ok()) << made.status();
    if (format == "ply") {
      EXPECT_TRUE(made->warnings.empty());
      EXPECT_THAT(PlyVertexColours(made->files[0].bytes, {0, 1, 2}, "b").value(),
                  testing::ElementsAre(Rgb{0, 51, 0}, Rgb{0, 102, 0}, Rgb{0, 153, 0}));
    } else {
      EXPECT_THAT(made->warnings, testing::ElementsAre(testing::HasSubstr("colours of vertices are not written")));
    }
  }
}

TEST(DeliverTileTest, NewGeometryOfATreeIsMarked) {
  const std::string pack = OsgbScene().Pack(0);
  std::vector<int32_t> new_geometries(ReadTileTree(pack, "a.osgb")->pieces.size());
  new_geometries.back() = 1;
  const AssembledTile tile = {pack, nullptr, {}, "", new_geometries};
  const auto obj = DeliverTile(InputFor("a/a.osgb", "obj", "a/b.obj"), tile);
  ASSERT_TRUE(obj.ok()) << obj.status();
  EXPECT_THAT(obj->files[0].bytes, testing::HasSubstr("\ng tilemend_filled\n"));
  const auto ply = DeliverTile(InputFor("a/a.osgb", "ply", "a/b.ply"), tile);
  ASSERT_TRUE(ply.ok()) << ply.status();
  EXPECT_THAT(ply->files[0].bytes, testing::HasSubstr("property uchar tilemend_filled\n"));
}

TEST(DeliverTileTest, AnotherFormatIsAnError) {
  const std::string pack = OsgbScene().Pack(0);
  const auto made = DeliverTile(InputFor("a/a.osgb", "fbx", "a/b.fbx"), {pack, nullptr, {}, ""});
  EXPECT_EQ(made.status().code(), absl::StatusCode::kInvalidArgument);
}

}  // namespace
}  // namespace tilemend
