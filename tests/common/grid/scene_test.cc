#include "common/grid/scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "common/grid/scene_sources.h"
#include "tests/support/temporary_folder.h"

namespace tilemend {
namespace {

using testing::HasSubstr;

constexpr char kScene[] = R"({"cell_size": 10, "cols": 1, "rows": 1, "tiles": [{"col": 0, "row": 0, "path": null}]})";

TEST(SortTilesTest, GoesByRowThenColumn) {
  std::vector<SceneTile> tiles = {{{1, 1}, "d"}, {{0, 1}, "c"}, {{1, 0}, "b"}, {{0, 0}, "a"}};
  SortTiles(&tiles);
  std::string order;
  for (const SceneTile& tile : tiles) order += tile.path;
  EXPECT_EQ(order, "abcd");
}

TEST(IsTileFormatTest, TakesPlyAndObjInAnyCase) {
  for (const char* path : {"a.ply", "b/c.OBJ", "x.y.Ply"}) EXPECT_TRUE(IsTileFormat(path)) << path;
  for (const char* path : {"", "ply", "a.off", "a.ply.gz", "obj/a"}) EXPECT_FALSE(IsTileFormat(path)) << path;
}

TEST(OutputPathTest, IsTheTilesOwnOrAfterItsCell) {
  EXPECT_EQ(OutputPath({{3, -1}, "deep/a.obj"}), "deep/a.obj");
  EXPECT_EQ(OutputPath({{3, -1}, ""}), "tiles/Tile_+003_-001.ply");
}

TEST(LoadSceneTest, TakesTheFolderOrItsFile) {
  TemporaryFolder folder;
  folder.Write("scene.json", kScene);
  const auto by_folder = LoadScene(folder.path(), nullptr), by_file = LoadScene(folder / "scene.json", nullptr);
  ASSERT_TRUE(by_folder.ok() && by_file.ok()) << by_folder.status() << by_file.status();
  EXPECT_EQ(by_folder->root, folder.path());
  EXPECT_EQ(by_file->root, folder.path());
  EXPECT_EQ(SceneJson(*by_folder), SceneJson(*by_file));
}

TEST(LoadSceneTest, ASceneFileThatIsALinkToNothingIsAnError) {
  TemporaryFolder folder;
  std::filesystem::create_symlink("gone.json", folder / "scene.json");
  const absl::Status status = LoadScene(folder.path(), nullptr).status();
  EXPECT_TRUE(absl::IsInvalidArgument(status)) << status;
  EXPECT_THAT(std::string(status.message()), HasSubstr(folder / "scene.json: a link that leads to no file"));
  folder.Write("gone.json", kScene);
  EXPECT_TRUE(LoadScene(folder.path(), nullptr).ok());
  std::filesystem::create_symlink("gone.xml", folder / "metadata.xml");
  EXPECT_THAT(std::string(LoadScene(folder.path(), nullptr).status().message()), HasSubstr("metadata.xml: a link"));
}

TEST(IsThereTest, TellsNothingFromALinkToNothing) {
  TemporaryFolder folder;
  EXPECT_EQ(IsThere(folder / "a").value(), false);
  EXPECT_EQ(IsThere(folder.Write("a", "")).value(), true);
  std::filesystem::create_symlink("none", folder / "b");
  EXPECT_TRUE(absl::IsInvalidArgument(IsThere(folder / "b").status()));
}

TEST(LoadSceneTest, WarnsOfTilesThatLieElsewhere) {
  TemporaryFolder folder, elsewhere;
  folder.Write("scene.json", R"({"cell_size": 10, "cols": 3, "rows": 1, "tiles": [
      {"col": 0, "row": 0, "path": "in.ply"}, {"col": 1, "row": 0, "path": "link.ply"},
      {"col": 2, "row": 0, "path": "out.ply"}]})");
  folder.Write("in.ply", "ply");
  std::filesystem::create_symlink("in.ply", folder / "link.ply");
  std::filesystem::create_symlink(elsewhere.Write("a.ply", "ply"), folder / "out.ply");
  const auto scene = LoadScene(folder.path(), nullptr);
  ASSERT_TRUE(scene.ok()) << scene.status();
  ASSERT_EQ(scene->warnings.size(), 1U);
  EXPECT_THAT(scene->warnings[0], HasSubstr("out.ply leads to " + (elsewhere / "a.ply") + ", out of"));
}

TEST(LoadSceneTest, SaysWhatIsNoScene) {
  TemporaryFolder folder;
  const absl::Status none = LoadScene(folder / "none", nullptr).status();
  EXPECT_EQ(none.code(), absl::StatusCode::kNotFound);
  EXPECT_EQ(none.message(), folder / "none: no such scene");
  const absl::Status mesh = LoadScene(folder.Write("a.ply", "ply"), nullptr).status();
  EXPECT_EQ(mesh.code(), absl::StatusCode::kInvalidArgument);
  EXPECT_THAT(std::string(mesh.message()), HasSubstr("one mesh is for `tilemend fill`"));
  EXPECT_TRUE(absl::IsInvalidArgument(LoadScene(std::string(5000, 'x'), nullptr).status()));
}

}  // namespace
}  // namespace tilemend
