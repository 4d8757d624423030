#include "coordinator/web/job_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "common/util/error_info.h"
#include "tests/support/temporary_folder.h"

namespace tilemend {
namespace {

using ::testing::Each;
using ::testing::HasSubstr;

class JobFilesTest : public ::testing::Test {
 protected:
  JobFilesTest() {
    job_.state = JobState::kDone;
    job_.spec.set_scene(folder_ / "scene");
    job_.spec.set_out(folder_ / "out");
    folder_.Write("secret.obj", "secret");
    folder_.Write("secret.mtl", "secret");
    folder_.Write("scene/a.obj", "before");
    folder_.Write("scene/b.obj", "b");
    folder_.Write("out/a.obj", "after");
    WriteScene(R"({"col": 0, "row": 0, "path": "a.obj"}, {"col": 1, "row": 0, "path": "b.obj"},
                  {"col": 2, "row": 0, "path": null})");
  }
  void WriteScene(const std::string& tiles) {
    folder_.Write("scene/scene.json", R"({"cell_size": 10, "cols": 3, "rows": 1, "tiles": [)" + tiles + "]}");
  }
  // Asks again while something is being read.
  template <typename Ask>
  static auto Await(Ask ask) {
    auto answer = ask();
    while (absl::IsUnavailable(answer.status())) answer = ask();
    return answer;
  }
  absl::StatusOr<JobFiles::File> File(CellId cell, bool after, const std::string& path = "",
                                      const std::string& name = "jobs/1") {
    return Await([&] { return files_.FileOf(name, job_, cell, after, path); });
  }
  std::string Reason(CellId cell, bool after, const std::string& path = "") {
    return ErrorReason(File(cell, after, path).status());
  }

  TemporaryFolder folder_;
  JobCells job_;
  JobFiles files_;
};

TEST_F(JobFilesTest, GivesACellBeforeAndAfter) {
  const auto before = File({0, 0}, false);
  ASSERT_TRUE(before.ok()) << before.status();
  EXPECT_EQ(before->bytes, "before");
  EXPECT_EQ(before->name, "a.obj");
  EXPECT_EQ(File({0, 0}, true)->bytes, "after");
}

TEST_F(JobFilesTest, HasNoTileWhereThereIsNone) {
  EXPECT_EQ(Reason({1, 0}, true), "TILE_NOT_FOUND");   // not written yet
  EXPECT_EQ(Reason({2, 0}, false), "TILE_NOT_FOUND");  // without surface
  EXPECT_EQ(Reason({7, 7}, false), "TILE_NOT_FOUND");  // no cell
}

TEST_F(JobFilesTest, GivesMaterialsAndImagesOfATile) {
  folder_.Write("scene/tex/a.JPG", "jpeg");
  folder_.Write("out/a.mtl", "materials");
  EXPECT_EQ(File({0, 0}, false, "tex/a.JPG")->bytes, "jpeg");
  EXPECT_EQ(File({0, 0}, false, "./tex//../tex/a.JPG")->name, "a.JPG");
  EXPECT_EQ(File({0, 0}, true, "a.mtl")->bytes, "materials");
}

TEST_F(JobFilesTest, GivesNoOtherFile) {
  folder_.Write("scene/.hidden/a.mtl", "x");
  folder_.Write("scene/notes.txt", "x");
  folder_.Write("out/report.json", "{}");
  folder_.Write("scene/sub/a.mtl", "x");
  for (const char* path : {"../secret.mtl", "sub/../../secret.mtl", "/etc/passwd", "..", "b.obj", "notes.txt",
                           "scene.json", ".hidden/a.mtl", "none.mtl", "a.mtl/", "sub", ".mtl", "a\0.mtl"}) {
    EXPECT_EQ(Reason({0, 0}, false, path), "TILE_NOT_FOUND") << path;
  }
  EXPECT_EQ(Reason({0, 0}, false, (folder_ / "secret.mtl")), "TILE_NOT_FOUND");
  EXPECT_EQ(Reason({0, 0}, true, "report.json"), "TILE_NOT_FOUND");
}

TEST_F(JobFilesTest, ALinkLeadsNowhereOutOfTheFolder) {
  const auto link = [&](const std::string& to, const std::string& from) {
    std::filesystem::remove(folder_ / from);
    std::filesystem::create_symlink(to, folder_ / from);
  };
  link(folder_ / "secret.obj", "scene/b.obj");
  EXPECT_EQ(Reason({1, 0}, false), "TILE_NOT_FOUND");
  link("../secret.obj", "scene/b.obj");
  EXPECT_EQ(Reason({1, 0}, false), "TILE_NOT_FOUND");
  link("a.obj", "scene/b.obj");
  EXPECT_EQ(File({1, 0}, false)->bytes, "before");
  link("../secret.mtl", "scene/a.mtl");
  EXPECT_EQ(Reason({0, 0}, false, "a.mtl"), "TILE_NOT_FOUND");
  link("..", "scene/up");
  EXPECT_EQ(Reason({0, 0}, false, "up/secret.mtl"), "TILE_NOT_FOUND");
}

TEST_F(JobFilesTest, ATreeHasItsOwnFilesAlone) {
  folder_.Write("scene/t/tile.json", "{}");
  folder_.Write("scene/t/fine/a.b3dm", "b3dm");
  folder_.Write("scene/other.b3dm", "x");
  WriteScene(R"({"col": 0, "row": 0, "path": "t/tile.json"})");
  EXPECT_EQ(File({0, 0}, false, "fine/a.b3dm")->bytes, "b3dm");
  EXPECT_EQ(Reason({0, 0}, false, "../other.b3dm"), "TILE_NOT_FOUND");
  EXPECT_EQ(Reason({0, 0}, false, "../scene.json"), "TILE_NOT_FOUND");
}

TEST_F(JobFilesTest, APathInTheSceneLeadsNowhereOutOfTheFolder) {
  WriteScene(R"({"col": 0, "row": 0, "path": "../secret.obj"})");
  EXPECT_FALSE(File({0, 0}, false).ok());
}

TEST_F(JobFilesTest, ASceneWithoutSceneFileIsToldByTheOutput) {
  std::filesystem::rename(folder_ / "scene/scene.json", folder_ / "out/scene.json");
  folder_.Write("out/b.obj", "b after");
  EXPECT_EQ(File({0, 0}, false)->bytes, "before");
  EXPECT_EQ(File({1, 0}, true)->bytes, "b after");
  std::filesystem::remove(folder_ / "out/scene.json");
  EXPECT_EQ(ErrorReason(File({0, 0}, false, "", "jobs/3").status()), "SCENE_FILE_NOT_FOUND");
}

// The names of the files of a delivery lead back to no tile of the scene.
TEST_F(JobFilesTest, TheTilesOfADeliveryAreFoundByTheirNames) {
  std::filesystem::remove(folder_ / "scene/scene.json");
  folder_.Write("scene/Tile_+000_+014/Tile_+000_+014.osgb", "before");
  folder_.Write("out/Tile_p000_p014/Tile_p000_p014.json", "after");
  job_.spec.set_output_format("3dtiles");
  const auto before = File({0, 14}, false), after = File({0, 14}, true);
  ASSERT_TRUE(before.ok()) << before.status();
  ASSERT_TRUE(after.ok()) << after.status();
  EXPECT_EQ(before->bytes, "before");
  EXPECT_EQ(after->bytes, "after");
  EXPECT_EQ(after->name, "Tile_p000_p014.json");
}

TEST_F(JobFilesTest, WhileAJobRunsItsPipelineTellsTheScene) {
  job_.state = JobState::kRunning;
  EXPECT_EQ(Reason({0, 0}, false), "SCENE_FILE_NOT_FOUND");
  Scene scene;
  scene.root = folder_ / "scene";
  scene.tiles = {{{5, 5}, "b.obj"}};
  auto sight = std::make_shared<SceneSight>(scene);
  job_.sight = sight;
  EXPECT_EQ(File({5, 5}, false)->bytes, "b");
  EXPECT_EQ(ErrorReason(files_.HolesOf("jobs/1", job_).status()), "REPORT_NOT_FOUND");
  Plan plan;
  plan.holes.resize(1);
  sight->SetPlan(plan, {});
  EXPECT_THAT(**files_.HolesOf("jobs/1", job_), HasSubstr("\"planned\":true"));
  job_.sight = nullptr;
  job_.state = JobState::kDone;
  EXPECT_EQ(File({5, 5}, false)->bytes, "b");  // still known
}

TEST_F(JobFilesTest, AFileThatIsTooLargeIsNotRead) {
  std::filesystem::resize_file(folder_ / "scene/b.obj", static_cast<uintmax_t>(kMostTileBytes) + 1);
  EXPECT_EQ(Reason({1, 0}, false), "TOO_LARGE");
}

TEST_F(JobFilesTest, GivesTheHolesAndTheReviewOfTheReport) {
  EXPECT_EQ(ErrorReason(files_.HolesOf("jobs/1", job_).status()), "REPORT_NOT_FOUND");
  EXPECT_EQ(ErrorReason(files_.ReviewOf("jobs/1", job_).status()), "REPORT_NOT_FOUND");
  job_.report = folder_.Write(
      "out/report.json",
      R"({"date": "today", "options": {"textures": "off"}, "per_hole": [{"id": 4, "outcome": "left", "reason": "<b>"}],
                              "warnings": ["look here"], "review": [{"hole": 4, "holes": [4]}]})");
  folder_.Write("out/holes.geojson", R"({"type": "FeatureCollection", "features": []})");
  const auto holes = Await([&] { return files_.HolesOf("jobs/1", job_); });
  ASSERT_TRUE(holes.ok()) << holes.status();
  const auto json = nlohmann::ordered_json::parse(**holes);
  EXPECT_EQ(json["holeCount"], 1);
  EXPECT_EQ(json["planned"], false);
  EXPECT_EQ(json["date"], "today");
  EXPECT_EQ(json["fillsToDecide"], 1);
  EXPECT_EQ(json["warnings"], nlohmann::ordered_json({"look here"}));
  EXPECT_EQ(json["holes"][0]["reason"], "<b>");
  const auto review = Await([&] { return files_.ReviewOf("jobs/1", job_); });
  ASSERT_TRUE(review.ok()) << review.status();
  const auto queue = nlohmann::ordered_json::parse(**review);
  EXPECT_EQ(queue["date"], "today");
  EXPECT_EQ(queue["out"], job_.spec.out());
  EXPECT_EQ(queue["changed_options"], nlohmann::ordered_json({{"textures", "off"}}));
  EXPECT_EQ(queue["review"]["count"], 1);
  EXPECT_EQ(queue["review"]["z"], 0);
  folder_.Write("out/report.json", "no JSON");
  EXPECT_TRUE(absl::IsDataLoss(Await([&] { return files_.HolesOf("jobs/9", job_); }).status()));
}

TEST_F(JobFilesTest, AReportThatHasChangedIsReadAgain) {
  job_.report = folder_.Write("out/report.json", R"({"per_hole": [{"id": 1}], "review": []})");
  folder_.Write("out/holes.geojson", R"({"features": [], "crs": 1})");
  const auto holes = [&] {
    return nlohmann::json::parse(**Await([&] { return files_.HolesOf("jobs/1", job_); }))["holeCount"];
  };
  const auto crs = [&] {
    return nlohmann::json::parse(**Await([&] { return files_.ReviewOf("jobs/1", job_); }))["review"]["crs"];
  };
  EXPECT_EQ(holes(), 1);
  EXPECT_EQ(crs(), 1);
  folder_.Write("out/report.json", R"({"per_hole": [{"id": 1}, {"id": 2}], "review": []})");
  EXPECT_EQ(holes(), 2);
  folder_.Write("out/holes.geojson", R"({"features": [], "crs": 2})");
  EXPECT_EQ(crs(), 2);
}

TEST_F(JobFilesTest, TheOutputOfALaterJobIsNotShown) {
  job_.report = folder_.Write("out/report.json", R"({"per_hole": []})");
  folder_.Write("out/holes.geojson", R"({"features": []})");
  const auto reasons = [&] {
    return std::vector<std::string>{ErrorReason(Await([&] { return files_.HolesOf("jobs/1", job_); }).status()),
                                    ErrorReason(Await([&] { return files_.ReviewOf("jobs/1", job_); }).status()),
                                    Reason({0, 0}, true)};
  };
  job_.later_job = "jobs/2";
  EXPECT_THAT(reasons(), Each("")) << "it has not begun to write";
  std::filesystem::remove(folder_ / "out/report.json");
  EXPECT_THAT(reasons(), Each("OUTPUT_REPLACED"));
  folder_.Write("out/report.json", R"({"per_hole": []})");
  job_.later_is_complete = true;
  EXPECT_THAT(reasons(), Each("OUTPUT_REPLACED"));
  EXPECT_EQ(Reason({0, 0}, false), "");
}

TEST_F(JobFilesTest, AReportOfAnotherSceneOrWithOtherDecisionsIsNotShown) {
  job_.spec.set_decisions("/d.geojson");
  folder_.Write("out/holes.geojson", R"({"features": []})");
  const auto reason = [&](const std::string& scene, const std::string& decisions) {
    const nlohmann::json report = {{"scene", scene}, {"options", {{"decisions", decisions}}}};
    job_.report = folder_.Write("out/report.json", report.dump());
    const std::string first = ErrorReason(Await([&] { return files_.HolesOf("jobs/1", job_); }).status());
    EXPECT_EQ(ErrorReason(Await([&] { return files_.ReviewOf("jobs/1", job_); }).status()), first);
    return first;
  };
  EXPECT_EQ(reason(job_.spec.scene(), "/d.geojson"), "");
  EXPECT_EQ(reason(job_.spec.scene(), ""), "OUTPUT_REPLACED");
  EXPECT_EQ(reason("/another", "/d.geojson"), "OUTPUT_REPLACED");
}

}  // namespace
}  // namespace tilemend
