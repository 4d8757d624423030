#include "coordinator/jobs/scene_folders.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "absl/strings/str_cat.h"
#include "tests/support/temporary_folder.h"

namespace tilemend {
namespace {

using testing::ElementsAre;

TEST(SceneFoldersTest, NamesTheKeyAndAFewFilesOfTheScene) {
  const TemporaryFolder folder;
  Scene scene;
  scene.root = folder / "scene";
  folder.Write("scene/scene.json", "{}");
  for (int i = 0; i < 5; ++i) {
    scene.tiles.push_back({{i, 0}, absl::StrCat("tiles/", i, ".ply")});
    folder.Write(absl::StrCat("scene/tiles/", i, ".ply"), absl::StrCat("tile ", i));
  }
  scene.tiles.push_back({{5, 0}, ""});
  std::filesystem::remove(folder / "scene/tiles/4.ply");
  const auto attempts = AttemptFolder::Make(folder / "out");
  ASSERT_TRUE(attempts.ok()) << attempts.status();
  const auto names = [&](const AttemptFolder* key) {
    std::vector<std::string> files;
    const auto folders = FoldersOf(scene, key);
    EXPECT_TRUE(folders.ok()) << folders.status();
    for (const KnownFile& file : folders.value_or(JobFolders()).files) {
      files.push_back(std::filesystem::relative(file.path, folder.path()).string());
    }
    return files;
  };
  EXPECT_THAT(names(&*attempts),
              ElementsAre("out/.tilemend-attempts/key", "scene/scene.json", "scene/tiles/0.ply", "scene/tiles/2.ply"));
  EXPECT_EQ(FoldersOf(scene, &*attempts)->attempts, attempts->path());
  EXPECT_THAT(names(nullptr), ElementsAre("scene/scene.json", "scene/tiles/0.ply", "scene/tiles/2.ply"));
  EXPECT_EQ(FoldersOf(scene, nullptr)->attempts, "");
  attempts->Remove();
  EXPECT_FALSE(FoldersOf(scene, &*attempts).ok());
}

}  // namespace
}  // namespace tilemend
