#include "coordinator/jobs/scene_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "absl/strings/str_cat.h"

namespace tilemend {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

constexpr CellId kA{0, 0}, kB{1, 0}, kC{2, 0};

TEST(SceneFilesTest, EveryFileIsCarriedOnceByTheFirstCellWhateverTheOrder) {
  const TileFiles a{{}, {"a.jpg", "shared.jpg"}, {}}, b{{}, {"shared.jpg", "b.jpg"}, {}};
  for (const bool turned : {false, true}) {
    SceneFiles files("");
    files.Take(turned ? kB : kA, turned ? b : a);
    files.Take(turned ? kA : kB, turned ? a : b);
    EXPECT_THAT(files.CarriedBy(kA), ElementsAre("a.jpg", "shared.jpg"));
    EXPECT_THAT(files.CarriedBy(kB), ElementsAre("b.jpg"));
    EXPECT_THAT(files.CarriedBy(kC), IsEmpty());
    EXPECT_THAT(files.Carried(), ElementsAre("a.jpg", "b.jpg", "shared.jpg"));
  }
}

TEST(SceneFilesTest, ATilesOwnLibraryIsTheLastThatNoOtherNames) {
  SceneFiles files("");
  files.Take(kA, {{"all.mtl", "a.mtl"}, {}, {}});
  files.Take(kB, {{"b1.mtl", "b2.mtl", "all.mtl"}, {}, {}});
  files.Take(kC, {{"all.mtl"}, {}, {}});
  EXPECT_EQ(files.LibraryOf(kA), "a.mtl");
  EXPECT_EQ(files.LibraryOf(kB), "b2.mtl");
  EXPECT_EQ(files.LibraryOf(kC), "");
  EXPECT_THAT(files.CarriedBy(kA), ElementsAre("all.mtl")) << "its own is written with the tile";
  EXPECT_THAT(files.CarriedBy(kB), ElementsAre("b1.mtl"));
}

TEST(SceneFilesTest, ANewLibraryHasANameThatNoFileOfTheSceneHas) {
  SceneFiles files("");
  EXPECT_EQ(files.NewFileFor("Data/T/T.obj", "mtl"), "Data/T/T_tilemend.mtl");
  files.Take(kA, {{"Data/T/T_tilemend.mtl"}, {"Data/T/t_Tilemend2.MTL"}, {}});
  EXPECT_EQ(files.NewFileFor("Data/T/T.obj", "mtl"), "Data/T/T_tilemend3.mtl");
}

TEST(SceneFilesTest, ANewFileHasANameThatAFolderTakes) {
  const SceneFiles files("");
  std::string tile = "T/";
  for (int k = 0; k < 125; ++k) tile += "\u00e9";  // two bytes each
  const std::string name = files.NewFileFor(tile + ".obj", "mtl");
  EXPECT_LE(name.size() - 2, 255U);
  EXPECT_TRUE(name.ends_with("\u00e9_tilemend.mtl")) << name;
}

// The output is the scene's folder "out", and one of the scene's files lies where another would be written.
TEST(SceneFilesTest, NoFileIsCarriedOverAnotherOfTheScene) {
  SceneFiles files("out");
  files.Take(kA, {{"a.mtl", "out/a.mtl"}, {"a.jpg", "out/a.jpg"}, {}});
  EXPECT_THAT(files.CarriedBy(kA), ElementsAre("out/a.jpg"));
  EXPECT_EQ(files.LibraryOf(kA), "out/a.mtl");
  EXPECT_THAT(files.Warnings(), ElementsAre(HasSubstr("a.jpg: would be written over"), HasSubstr("a.mtl")));
}

std::vector<std::string> Numbered(size_t count, const std::string& text) {
  std::vector<std::string> texts;
  for (size_t i = 0; i < count; ++i) texts.push_back(absl::StrCat(text, i));
  return texts;
}

// One damaged image is read by the tasks of several cells.
TEST(SceneFilesTest, OneWarningOfSeveralCellsIsThatOfTheFirst) {
  const std::vector<std::vector<CellId>> orders = {{kA, kB, kC}, {kC, kB, kA}, {kB, kC, kA, kB}};
  for (const std::vector<CellId>& order : orders) {
    SceneFiles files("");
    files.Warn(kB, {"other"});
    for (const CellId cell : order) files.Warn(cell, {"a.png: damaged"});
    EXPECT_THAT(files.Warnings(), ElementsAre("a.png: damaged", "other"));
  }
}

TEST(SceneFilesTest, AWarningThatWasLeftOutCountsOnce) {
  SceneFiles files("");
  files.Warn(kB, Numbered(SceneFiles::kMostWarnings, "b"));
  files.Warn(kC, {"c"});
  files.Warn(kC, {"c"});
  EXPECT_THAT(files.Warnings().back(), HasSubstr("1 more warning on"));
  files.Warn(kA, {"c"});
  EXPECT_EQ(files.Warnings().front(), "c");
  EXPECT_THAT(files.Warnings().back(), HasSubstr("1 more warning on"));
}

TEST(SceneFilesTest, WarningsComeByCellAndAreCountedBeyondALimit) {
  SceneFiles files("");
  files.Warn(kB, {"second"});
  files.Take(kA, {{}, {}, {"first"}});
  EXPECT_THAT(files.Warnings(), ElementsAre("first", "second"));
  files.Warn(kC, Numbered(SceneFiles::kMostWarnings, "more"));
  EXPECT_THAT(files.Warnings(), SizeIs(SceneFiles::kMostWarnings + 1));
  EXPECT_EQ(files.Warnings().back(), "2 more warnings on material files, images and levels of detail");
}

TEST(SceneFilesTest, KeepsNoMoreWarningsThanItShows) {
  SceneFiles files("");
  files.Warn(kC, Numbered(1000, "x"));
  files.Warn(kA, {"\x1b[2J"});
  files.Warn(kB, Numbered(SceneFiles::kMostWarnings, "b"));
  const std::vector<std::string> warnings = files.Warnings();
  ASSERT_THAT(warnings, SizeIs(SceneFiles::kMostWarnings + 1));
  EXPECT_EQ(warnings[0], "\\x1b[2J");
  EXPECT_EQ(warnings[SceneFiles::kMostWarnings - 1], "b18") << "by cell, whatever came first";
  EXPECT_EQ(warnings.back(), "1001 more warnings on material files, images and levels of detail");
  SceneFiles others("");
  others.Warn(kA, {std::string(100'000, 'x')});
  EXPECT_EQ(others.Warnings()[0].size(), kMostFileWarningBytes);
}

TEST(FolderInSceneTest, IsEmptyOutside) {
  EXPECT_EQ(FolderInScene("/a/scene/deep/out", "/a/scene"), "deep/out");
  EXPECT_EQ(FolderInScene("/a/out", "/a/scene"), "");
  EXPECT_EQ(FolderInScene("/a/scene-2", "/a/scene"), "");
}

TEST(SceneFilesTest, ATileThatIsNotWrittenCarriesNothing) {
  SceneFiles files("");
  files.Take({0, 0}, {{}, {"a.jpg", "b.jpg"}, {}}, false);
  files.Take({1, 0}, {{}, {"a.jpg"}, {}});
  EXPECT_EQ(files.Carried(), std::set<std::string>{"a.jpg"});
  EXPECT_EQ(files.CarriedBy({1, 0}), std::vector<std::string>{"a.jpg"});
  EXPECT_TRUE(files.CarriedBy({0, 0}).empty());
}

TEST(SceneFilesTest, ANewImageHasANameThatNoFileOfTheSceneHas) {
  SceneFiles files("");
  EXPECT_EQ(files.NewFileFor("T/T.obj", "jpg"), "T/T_tilemend.jpg");
  files.Take(kA, {{"T/T.mtl"}, {"T/T_Tilemend.JPG"}, {}});
  EXPECT_EQ(files.NewFileFor("T/T.obj", "jpg"), "T/T_tilemend2.jpg");
}

}  // namespace
}  // namespace tilemend
