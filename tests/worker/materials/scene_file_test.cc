#include "worker/materials/scene_file.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <memory>
#include <string>

#include "common/util/object_store.h"
#include "tests/support/map_store.h"
#include "tests/support/temporary_folder.h"
#include "worker/materials/tile_look.h"

namespace tilemend {
namespace {

namespace fs = std::filesystem;

class SceneFileTest : public testing::Test {
 protected:
  void SetUp() override {
    folder_.Write("scene/Data/T/my tile.jpg", "x");
    folder_.Write("scene/textures/Sub/Wall.JPG", "x");
    folder_.Write("secret.jpg", "x");
  }
  std::string PathOf(std::string_view name) { return FindSceneFile(folder_ / "scene", "Data/T", name)->path; }
  std::string ProblemOf(std::string_view name) { return FindSceneFile(folder_ / "scene", "Data/T", name)->problem; }

  TemporaryFolder folder_;
};

TEST_F(SceneFileTest, FindsNamesBesideTheFileAndThroughFolders) {
  EXPECT_EQ(PathOf("my tile.jpg"), "Data/T/my tile.jpg");
  EXPECT_EQ(PathOf("./../T/my tile.jpg"), "Data/T/my tile.jpg");
  EXPECT_EQ(PathOf("../../textures/Sub/Wall.JPG"), "textures/Sub/Wall.JPG");
  EXPECT_EQ(FindSceneFile(folder_.path(), "", "secret.jpg")->path, "secret.jpg");
}

TEST_F(SceneFileTest, TakesNamesAsOtherSystemsWriteThem) {
  EXPECT_EQ(PathOf("..\\..\\textures\\sub\\wall.jpg"), "textures/Sub/Wall.JPG");
  EXPECT_EQ(PathOf("\"my tile.jpg\""), "Data/T/my tile.jpg");
}

TEST_F(SceneFileTest, AnExactNameGoesBeforeOneInOtherLetters) {
  folder_.Write("scene/Data/T/MY tile.jpg", "y");
  EXPECT_EQ(PathOf("my tile.jpg"), "Data/T/my tile.jpg");
  EXPECT_EQ(PathOf("My Tile.jpg"), "Data/T/MY tile.jpg") << "the first in byte order";
}

TEST_F(SceneFileTest, DoesNotLeaveTheScene) {
  EXPECT_EQ(ProblemOf("../../../secret.jpg"), "lies outside the scene's folder");
  EXPECT_EQ(ProblemOf("..\\..\\..\\secret.jpg"), "lies outside the scene's folder");
  EXPECT_EQ(ProblemOf(folder_ / "secret.jpg"), "is an absolute path");
  EXPECT_EQ(FindSceneFile(folder_ / "scene", folder_.path(), "secret.jpg")->problem, "is an absolute path");
  EXPECT_EQ(ProblemOf("C:\\textures\\a.jpg"), "is an absolute path");
}

TEST_F(SceneFileTest, LeavesNamesToTheOutputThatItNeedsItself) {
  folder_.Write("scene/Data/U/U.obj", "x");
  folder_.Write("scene/Report.json", "x");
  for (const char* name : {"../U/U.obj", "./..//u\\u.OBJ", "../../Report.json"}) {
    EXPECT_EQ(ProblemOf(name), "has the name of a tile or of a file that tilemend writes") << name;
  }
}

TEST_F(SceneFileTest, FollowsLinksWithinTheSceneAlone) {
  fs::create_symlink("my tile.jpg", folder_ / "scene/Data/T/near.jpg");
  fs::create_symlink(folder_ / "scene/textures/Sub/Wall.JPG", folder_ / "scene/Data/T/wall.jpg");
  fs::create_symlink(folder_ / "secret.jpg", folder_ / "scene/Data/T/away.jpg");
  fs::create_symlink("../../../secret.jpg", folder_ / "scene/Data/T/up.mtl");
  fs::create_directory_symlink(folder_.path(), folder_ / "scene/Data/T/all");
  EXPECT_EQ(PathOf("near.jpg"), "Data/T/near.jpg");
  EXPECT_EQ(PathOf("wall.jpg"), "Data/T/wall.jpg");
  for (const char* name : {"away.jpg", "AWAY.jpg", "up.mtl", "all/secret.jpg"}) {
    EXPECT_EQ(PathOf(name), "") << name;
    EXPECT_EQ(ProblemOf(name), "leads out of the scene's folder by a link") << name;
  }
}

// The user's own links: to the scene, and to a tile's folder.
TEST_F(SceneFileTest, TheSceneAndAFolderOfTilesMayBeLinks) {
  fs::create_directory_symlink("scene", folder_ / "other");
  EXPECT_EQ(FindSceneFile(folder_ / "other", "Data/T", "my tile.jpg")->path, "Data/T/my tile.jpg");
  folder_.Write("elsewhere/U/u.jpg", "x");
  folder_.Write("elsewhere/v.jpg", "x");
  fs::create_directory_symlink(folder_ / "elsewhere/U", folder_ / "scene/Data/U");
  fs::create_symlink("../v.jpg", folder_ / "elsewhere/U/v.jpg");
  EXPECT_EQ(FindSceneFile(folder_ / "scene", "Data/U", "u.jpg")->path, "Data/U/u.jpg");
  EXPECT_EQ(FindSceneFile(folder_ / "scene", "Data/U", "v.jpg")->path, "");
  EXPECT_EQ(PathOf("../U/u.jpg"), "") << "named from another folder";
}

TEST_F(SceneFileTest, SaysWhyThereIsNone) {
  EXPECT_EQ(ProblemOf("lost.jpg"), "is not there");
  EXPECT_EQ(ProblemOf("lost/a.jpg"), "is not there");
  EXPECT_EQ(ProblemOf("my tile.jpg/a.jpg"), "is not there");
  EXPECT_EQ(ProblemOf("../T"), "is no file");
  EXPECT_EQ(ProblemOf(""), "is no name");
  EXPECT_EQ(ProblemOf("\"\""), "is no name");
  EXPECT_EQ(ProblemOf(std::string_view("a\0b", 3)), "is no name");
}

TEST(FolderOfTest, IsEmptyForAFileInTheScenesFolder) {
  EXPECT_EQ(FolderOf("a/b.obj"), "a");
  EXPECT_EQ(FolderOf("b.obj"), "");
}

// What a store cannot say is not missing: the tile would lose its images without a word.
TEST(SceneFileInAStoreTest, IsMissingOnlyIfTheStoreSaysSo) {
  auto owned = std::make_unique<MapStore>();
  MapStore& store = *owned;
  UseObjects(std::move(owned));
  store.objects = {{"s3://b/in/T/a.JPG", "x"}};
  EXPECT_EQ(FindSceneFile("s3://b/in", "T", "a.jpg")->path, "T/a.JPG");
  EXPECT_EQ(FindSceneFile("s3://b/in", "T", "b.jpg")->problem, "is not there");
  store.unreachable = true;
  EXPECT_TRUE(absl::IsUnavailable(FindSceneFile("s3://b/in", "T", "a.jpg").status()));
  ObjTextures textures;
  textures.libraries = {"a.mtl"};
  EXPECT_TRUE(absl::IsUnavailable(ReadObjLook("s3://b/in", "T/t.obj", textures).status()));
  UseObjects(nullptr);
}

}  // namespace
}  // namespace tilemend
