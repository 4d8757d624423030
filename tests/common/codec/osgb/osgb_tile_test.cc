#include "common/codec/osgb/osgb_tile.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/support/osgb_builder.h"
#include "tests/support/osgb_scene.h"

namespace tilemend {
namespace {

using ::testing::HasSubstr;

std::string PackOfVersion(uint32_t version, const std::string& without = "none") {
  return OsgbScene(OsgbScene::Pond::kHole, version).Pack(0, without);
}

TEST(OsgbTileTest, HasTheLevelsOfItsFiles) {
  for (const uint32_t version : {80u, 161u}) {
    const std::string pack = PackOfVersion(version);
    const auto tile = ReadOsgbTile(pack, "a/Tile.osgb");
    ASSERT_TRUE(tile.ok()) << tile.status();
    EXPECT_EQ(tile->levels, 3);
    ASSERT_EQ(tile->pieces.size(), 1u + 4 + 4);
    EXPECT_FALSE(tile->pieces[0].is_finest);
    EXPECT_FALSE(tile->pieces[4].is_finest);
    EXPECT_TRUE(tile->pieces[5].is_finest);
  }
}

TEST(OsgbTileTest, APieceWithoutItsFinerFileIsTheFinest) {
  const std::string pack = PackOfVersion(80, "_L2_3.osgb");
  const auto tile = ReadOsgbTile(pack, "a/Tile.osgb");
  ASSERT_TRUE(tile.ok()) << tile.status();
  EXPECT_TRUE(tile->pieces[4].is_finest);
  ASSERT_EQ(tile->missing.size(), 1u);
  EXPECT_THAT(tile->missing[0], HasSubstr("_L2_3.osgb"));
}

TEST(OsgbTileTest, AFinerFileMayBeNamedInOtherWays) {
  for (const char* name : {"b_L1.osgb", "./b_L1.osgb", ".\\b_L1.osgb", "../Tile_1/b_L1.osgb", "B_l1.osgb"}) {
    OsgbBuilder builder;
    const std::string root =
        builder.Scene([&] { builder.PagedLod(name, [&] { builder.Geode({[&] { builder.Geometry({}); }}); }); });
    const std::string pack = PackFiles({{"a.osgb", root}, {"b_L1.osgb", BuiltOsgbGeometry({})}});
    const auto tile = ReadOsgbTile(pack, "Data/Tile_1/a.osgb");
    ASSERT_TRUE(tile.ok()) << name << ": " << tile.status();
    EXPECT_EQ(tile->levels, 2) << name;
  }
}

TEST(OsgbTileTest, AFileThatIsNamedTwiceIsAnError) {
  OsgbBuilder builder;
  const std::string root = builder.Scene([&] {
    const auto lod = [&] { builder.PagedLod("b.osgb", [&] { builder.Geode({[&] { builder.Geometry({}); }}); }); };
    builder.Group({lod, lod});
  });
  const std::string leaf = BuiltOsgbGeometry({});
  const std::string pack = PackFiles({{"a.osgb", root}, {"b.osgb", leaf}});
  EXPECT_THAT(ReadOsgbTile(pack, "x/a.osgb").status().message(),
              HasSubstr("x/a.osgb: the finer file \"b.osgb\" is named for the second time"));
  OsgbBuilder own;
  const std::string circle = PackFiles(
      {{"a.osgb", own.Scene([&] { own.PagedLod("a.osgb", [&] { own.Geode({[&] { own.Geometry({}); }}); }); })}});
  EXPECT_FALSE(ReadOsgbTile(circle, "x/a.osgb").ok()) << "a file that names itself";
}

TEST(OsgbTileTest, ErrorsNameTheFile) {
  const std::string pack = PackOfVersion(80);
  auto files = *UnpackFiles(pack, "x");
  files[2].bytes = files[2].bytes.substr(0, files[2].bytes.size() / 2);
  const std::string cut = PackFiles(files);
  EXPECT_THAT(ReadOsgbTile(cut, "folder/a.osgb").status().message(), HasSubstr("folder/" + files[2].name));
}

TEST(OsgbTileTest, ChangesLeaveOtherFilesAsTheyAre) {
  const std::string pack = PackOfVersion(80);
  const auto tile = ReadOsgbTile(pack, "a/Tile.osgb");
  ASSERT_TRUE(tile.ok()) << tile.status();
  std::vector<OsgbEdit> edits(tile->files.size());
  OsgbPatch patch;
  patch.points = {{1, 1, 5}, {2, 1, 5}, {1, 2, 5}};
  patch.triangles = {{0, 1, 2}};
  edits[2].patches = {patch};
  edits[3].drop.assign(tile->files[3].triangles.size(), false);
  edits[3].drop[0] = true;
  const auto changed = ChangeOsgbTile(tile->packed, edits, "a/Tile.osgb");
  ASSERT_TRUE(changed.ok()) << changed.status();
  const auto after = ReadOsgbTile(*changed, "a/Tile.osgb");
  ASSERT_TRUE(after.ok()) << after.status();
  for (size_t f = 0; f < tile->files.size(); ++f) {
    const auto before = static_cast<int64_t>(tile->files[f].triangles.size());
    const auto now = static_cast<int64_t>(after->files[f].triangles.size());
    EXPECT_EQ(now - before, f == 2 ? 1 : f == 3 ? -1 : 0) << f;
    EXPECT_EQ(after->packed[f].bytes == tile->packed[f].bytes, f != 2 && f != 3);
  }
}

}  // namespace
}  // namespace tilemend
