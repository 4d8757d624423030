#include "common/grid/scene_place.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "tests/support/temporary_folder.h"

namespace tilemend {
namespace {

TEST(ScenePlaceOfTest, IsTheFolderWhateverPathLeadsThere) {
  const TemporaryFolder folder;
  folder.Write("city/scene.json", "{}");
  std::filesystem::create_directory_symlink(folder / "city", folder / "link");
  const std::string place = ScenePlaceOf(folder / "city");
  for (const char* path : {"city/", "city/scene.json", "link", "link/scene.json", "city/../link"}) {
    EXPECT_EQ(ScenePlaceOf(folder / path), place) << path;
  }
}

TEST(ScenePlaceOfTest, OtherFilesOfAFolderAreOtherScenes) {
  const TemporaryFolder folder;
  folder.Write("city/other.json", "{}");
  EXPECT_NE(ScenePlaceOf(folder / "city/other.json"), ScenePlaceOf(folder / "city"));
  // The tiles lie beside the link.
  std::filesystem::create_directory(folder / "town");
  std::filesystem::create_symlink(folder / "city/other.json", folder / "town/other.json");
  EXPECT_NE(ScenePlaceOf(folder / "town/other.json"), ScenePlaceOf(folder / "city/other.json"));
}

TEST(ScenePlaceOfTest, ObjectsHaveNoLinks) {
  EXPECT_EQ(ScenePlaceOf("s3://bucket/city/scene.json"), ScenePlaceOf("s3://bucket/city"));
  EXPECT_NE(ScenePlaceOf("s3://bucket/city"), ScenePlaceOf("s3://bucket/town"));
}

TEST(ScenePlaceOfTest, WhatIsNotThereHasAPlaceToo) {
  EXPECT_EQ(ScenePlaceOf("/none/city/scene.json"), ScenePlaceOf("/none/city"));
}

}  // namespace
}  // namespace tilemend
