#include "coordinator/web/job_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "common/util/error_info.h"
#include "tests/support/temporary_folder.h"

namespace tilemend {
namespace {

class JobFilesTest : public ::testing::Test {
 protected:
  JobFilesTest() {
    spec_.set_scene(folder_ / "scene");
    spec_.set_out(folder_ / "out");
    folder_.Write("secret.obj", "secret");
    folder_.Write("scene/a.obj", "before");
    folder_.Write("scene/b.obj", "b");
    folder_.Write("out/a.obj", "after");
    WriteScene(R"({"col": 0, "row": 0, "path": "a.obj"}, {"col": 1, "row": 0, "path": "b.obj"},
                  {"col": 2, "row": 0, "path": null})");
  }
  void WriteScene(const std::string& tiles) {
    folder_.Write("scene/scene.json", R"({"cell_size": 10, "cols": 3, "rows": 1, "tiles": [)" + tiles + "]}");
  }
  std::string Reason(CellId cell, bool after) {
    return ErrorReason(files_.TileOf("jobs/1", spec_, cell, after).status());
  }

  TemporaryFolder folder_;
  JobSpec spec_;
  JobFiles files_;
};

TEST_F(JobFilesTest, GivesACellBeforeAndAfter) {
  const auto before = files_.TileOf("jobs/1", spec_, {0, 0}, false);
  ASSERT_TRUE(before.ok()) << before.status();
  EXPECT_EQ(before->bytes, "before");
  EXPECT_EQ(before->name, "a.obj");
  EXPECT_EQ(files_.TileOf("jobs/1", spec_, {0, 0}, true)->bytes, "after");
}

TEST_F(JobFilesTest, HasNoTileWhereThereIsNone) {
  EXPECT_EQ(Reason({1, 0}, true), "TILE_NOT_FOUND");   // not written yet
  EXPECT_EQ(Reason({2, 0}, false), "TILE_NOT_FOUND");  // without surface
  EXPECT_EQ(Reason({7, 7}, false), "TILE_NOT_FOUND");  // no cell
}

TEST_F(JobFilesTest, ALinkLeadsNowhereOutOfTheFolder) {
  std::filesystem::remove(folder_ / "scene/b.obj");
  std::filesystem::create_symlink(folder_ / "secret.obj", folder_ / "scene/b.obj");
  EXPECT_EQ(Reason({1, 0}, false), "TILE_NOT_FOUND");
  std::filesystem::remove(folder_ / "scene/b.obj");
  std::filesystem::create_symlink("../secret.obj", folder_ / "scene/b.obj");
  EXPECT_EQ(Reason({1, 0}, false), "TILE_NOT_FOUND");
  std::filesystem::remove(folder_ / "scene/b.obj");
  std::filesystem::create_symlink("a.obj", folder_ / "scene/b.obj");
  EXPECT_EQ(files_.TileOf("jobs/1", spec_, {1, 0}, false)->bytes, "before");
}

TEST_F(JobFilesTest, APathInTheSceneLeadsNowhereOutOfTheFolder) {
  WriteScene(R"({"col": 0, "row": 0, "path": "../secret.obj"})");
  EXPECT_FALSE(files_.SceneOf("jobs/2", spec_).ok());
  EXPECT_FALSE(files_.TileOf("jobs/2", spec_, {0, 0}, false).ok());
}

TEST_F(JobFilesTest, WithoutASceneFileThereIsNoScene) {
  std::filesystem::remove(folder_ / "scene/scene.json");
  EXPECT_EQ(ErrorReason(files_.SceneOf("jobs/3", spec_).status()), "SCENE_FILE_NOT_FOUND");
}

TEST_F(JobFilesTest, AFileThatIsTooLargeIsNotRead) {
  std::filesystem::resize_file(folder_ / "scene/b.obj", static_cast<uintmax_t>(kMostTileBytes) + 1);
  EXPECT_EQ(Reason({1, 0}, false), "TOO_LARGE");
}

TEST_F(JobFilesTest, GivesTheHolesOfTheReport) {
  JobCells job;
  job.spec = spec_;
  EXPECT_EQ(ErrorReason(files_.HolesOf("jobs/1", job).status()), "REPORT_NOT_FOUND");
  job.report = folder_.Write("out/report.json", R"({"per_hole": [{"id": 4, "outcome": "left", "reason": "<b>"}]})");
  const auto holes = files_.HolesOf("jobs/1", job);
  ASSERT_TRUE(holes.ok()) << holes.status();
  const auto json = nlohmann::ordered_json::parse(**holes);
  EXPECT_EQ(json["holeCount"], 1);
  EXPECT_EQ(json["holes"][0]["reason"], "<b>");
  folder_.Write("out/report.json", "no JSON");
  EXPECT_TRUE(absl::IsDataLoss(files_.HolesOf("jobs/9", job).status()));
}

TEST(RecentValuesTest, KeepsThoseThatWereAskedForLast) {
  RecentValues<int> values(2);
  values.Keep("a", std::make_shared<const int>(1));
  values.Keep("b", std::make_shared<const int>(2));
  EXPECT_EQ(*values.Find("a"), 1);
  values.Keep("c", std::make_shared<const int>(3));
  EXPECT_EQ(values.Find("b"), nullptr);
  EXPECT_EQ(*values.Find("a"), 1);
}

}  // namespace
}  // namespace tilemend
