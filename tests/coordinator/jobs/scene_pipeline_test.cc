// The pipeline of scenes, driven task by task without a coordinator.
#include "coordinator/jobs/scene_pipeline.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <deque>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"
#include "absl/time/time.h"
#include "common/options/job_options.h"
#include "common/records/surface.h"
#include "common/util/error_info.h"
#include "common/util/files.h"
#include "tests/support/output_checks.h"
#include "tests/support/temporary_folder.h"
#include "tilemend/v1/stages.pb.h"
#include "worker/service/scene_stages.h"

namespace tilemend {
namespace {

using ::testing::HasSubstr;

class ScenePipelineTest : public ::testing::Test {
 protected:
  ScenePipelineTest() {
    WriteMade(SmallScene(Cut::kClipped), folder_ / "scene");
    spec_.set_scene(folder_ / "scene");
    spec_.set_out(folder_ / "out");
  }

  std::unique_ptr<JobPipeline> Make() {
    auto pipeline = ScenePipelineFactory()(spec_, {});
    EXPECT_TRUE(pipeline.ok()) << pipeline.status();
    return pipeline.ok() ? *std::move(pipeline) : nullptr;
  }

  // Runs every task, the last first if `backwards`; `change` may replace a result. The outcome, or the first error.
  absl::StatusOr<JobOutcome> Run(const std::function<void(TaskResult&)>& change = {}, bool backwards = false) {
    const auto pipeline = Make();
    const absl::Status status = RunTasks(*pipeline, change, backwards);
    if (!status.ok()) return status;
    progress_ = pipeline->GetProgress();
    return pipeline->Finish();
  }

  static void WriteTile(const std::string& path, const std::string& bytes) {
    ASSERT_TRUE(WriteFileAtomically(path, bytes, Sync::kNo).ok());
  }

  // The same without the end.
  absl::Status RunTasks(JobPipeline& pipeline, const std::function<void(TaskResult&)>& change = {},
                        bool backwards = false) {
    auto first = pipeline.Start();
    if (!first.ok()) return first.status();
    std::deque<NewTask> open(first->begin(), first->end());
    while (!open.empty()) {
      NewTask task = backwards ? open.back() : open.front();
      backwards ? open.pop_back() : open.pop_front();
      TaskResult result{task.cell, task.stage, SceneStageRunner()(task.stage, WholeInput(task).value(), CancelToken())};
      result.input = Sha256Hex(task.input);
      if (change) change(result);
      auto next = pipeline.OnTaskDone(std::move(result));
      if (!next.ok()) return next.status();
      open.insert(open.end(), next->begin(), next->end());
      ++stages_[task.stage];
    }
    EXPECT_TRUE(pipeline.Done());
    return absl::OkStatus();
  }

  const TemporaryFolder folder_;
  JobSpec spec_ = WithDefaults({});
  std::map<Stage, int> stages_;
  Progress progress_;
};

TEST_F(ScenePipelineTest, FillsASceneAndReportsIt) {
  const auto outcome = Run();
  ASSERT_TRUE(outcome.ok()) << outcome.status();
  EXPECT_FALSE(outcome->partial);
  EXPECT_EQ(outcome->report, spec_.out() + "/report.json");
  EXPECT_EQ(progress_.cells, 12);
  EXPECT_EQ(progress_.cells_done, 12);
  EXPECT_EQ(progress_.holes_filled, progress_.holes);
  EXPECT_EQ(stages_[Stage::kSurvey], 12);
  EXPECT_GT(stages_[Stage::kSampleCluster], 0);
  EXPECT_EQ(stages_[Stage::kSampleLayer], 0);
  EXPECT_EQ(stages_[Stage::kAssemble], 12);
  ExpectOriginalsKept(spec_.scene(), spec_.out());
  ExpectClosed(SmallScene(Cut::kClipped), spec_.out());
  const nlohmann::json report = ReportOf(spec_.out());
  EXPECT_EQ(report["scene"], spec_.scene());
  EXPECT_EQ(report["options"]["water"], "auto");
  EXPECT_EQ(report["options"]["tension"], "auto");
  absl::Time made;
  EXPECT_TRUE(absl::ParseTime(absl::RFC3339_full, report["date"].get<std::string>(), &made, nullptr));
  std::vector<std::string> steps;
  for (const auto& [step, seconds] : report["seconds"].items()) steps.push_back(step);
  EXPECT_THAT(steps, ::testing::UnorderedElementsAre("survey", "ground", "plan", "sample", "fill", "assemble"));
}

TEST_F(ScenePipelineTest, HoldsTasksBackWhileManyAreOut) {
  constexpr char kOneTriangle[] =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\nproperty double z\n"
      "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
  constexpr int kSide = 92;  // a few more cells than that
  static_assert(kSide * kSide > kMostTasksOut);
  nlohmann::json scene = {{"origin", {0, 0, 0}}, {"cell_size", 1}, {"cols", kSide}, {"rows", kSide}};
  for (int cell = 0; cell < kSide * kSide; ++cell) {
    const int col = cell % kSide, row = cell / kSide;
    const std::string name = absl::StrCat(cell, ".ply");
    scene["tiles"].push_back({{"col", col}, {"row", row}, {"path", name}});
    WriteTile(folder_ / ("many/" + name), absl::StrCat(kOneTriangle, col, " ", row, " 0\n", col + 1, " ", row, " 0\n",
                                                       col, " ", row + 1, " 0\n3 0 1 2\n"));
  }
  WriteTile(folder_ / "many/scene.json", scene.dump());
  spec_.set_scene(folder_ / "many");
  const auto pipeline = Make();
  auto tasks = *pipeline->Start();
  int64_t out = std::ssize(tasks);
  for (size_t done = 0; done < 64; ++done) {
    const NewTask task = tasks[done];
    auto next = pipeline->OnTaskDone(
        {task.cell, task.stage, SceneStageRunner()(task.stage, WholeInput(task).value(), CancelToken())});
    ASSERT_TRUE(next.ok()) << next.status();
    out += std::ssize(*next) - 1;
    EXPECT_LE(out, kMostTasksOut);
  }
  EXPECT_EQ(out, kMostTasksOut);
}

TEST_F(ScenePipelineTest, WritesTheSameTilesInWhateverOrderResultsCome) {
  ASSERT_TRUE(Run().ok());
  const auto forwards = TilesBelow(spec_.out());
  spec_.set_out(folder_ / "other");
  ASSERT_TRUE(Run({}, true).ok());
  EXPECT_EQ(TilesBelow(spec_.out()), forwards);
}

TEST_F(ScenePipelineTest, WangFillsByLayersAndSmoothsSeams) {
  spec_.set_surface(SurfaceName(Surface::kWang));
  ASSERT_TRUE(Run().ok());
  EXPECT_EQ(stages_[Stage::kSampleCluster], 0);
  EXPECT_EQ(stages_[Stage::kSampleLayer], 0);
  EXPECT_GT(stages_[Stage::kSmoothSeam], 0);
  EXPECT_EQ(ReportOf(spec_.out())["options"]["surface"], "wang");
}

TEST_F(ScenePipelineTest, ADryRunPlansAndWritesNothing) {
  spec_.set_dry_run(true);
  const auto outcome = Run();
  ASSERT_TRUE(outcome.ok()) << outcome.status();
  EXPECT_THAT(outcome->message, HasSubstr("holes found, nothing written: "));
  EXPECT_EQ(stages_.size(), 2U) << "survey and ground";
  EXPECT_FALSE(std::filesystem::exists(spec_.out()));
}

TEST_F(ScenePipelineTest, AResultThatCannotBeReadFailsTheJob) {
  for (const Stage stage : {Stage::kSurvey, Stage::kSampleCluster, Stage::kFill}) {
    const absl::Status status = Run([&](TaskResult& result) {
                                  if (result.stage == stage) result.output = "no message \xff\xff";
                                }).status();
    EXPECT_TRUE(absl::IsInternal(status)) << status;
    EXPECT_THAT(std::string(status.message()), HasSubstr("cannot be read"));
  }
}

TEST_F(ScenePipelineTest, SamplesOfAClusterThatIsNotThereFailTheJob) {
  const absl::Status status = Run([&](TaskResult& result) {
                                if (result.stage != Stage::kSampleCluster) return;
                                v1::SampleClusterOutput output;
                                ASSERT_TRUE(output.ParseFromString(*result.output));
                                output.set_cluster(1 << 20);
                                result.output = output.SerializeAsString();
                              }).status();
  EXPECT_TRUE(absl::IsInternal(status)) << status;
}

TEST_F(ScenePipelineTest, AnUnknownWayOfFillingFailsTheJobWhereItIsTold) {
  const absl::Status status = Run([&](TaskResult& result) {
                                if (result.stage != Stage::kFill) return;
                                v1::FillOutput output;
                                ASSERT_TRUE(output.ParseFromString(*result.output));
                                for (auto& patch : *output.mutable_patches())
                                  patch.set_way(static_cast<v1::FillWay>(99));
                                result.output = output.SerializeAsString();
                              }).status();
  EXPECT_TRUE(absl::IsInternal(status)) << status;
  EXPECT_FALSE(std::filesystem::exists(spec_.out() + "/report.json"));
}

absl::Status Quarantined() { return WithErrorInfo(absl::AbortedError("it killed three workers"), {"QUARANTINED", {}}); }

TEST_F(ScenePipelineTest, OnlyAQuarantinedSurveyFailsTheJob) {
  for (const Stage stage : {Stage::kSurvey, Stage::kSampleCluster, Stage::kFill, Stage::kAssemble}) {
    spec_.set_out(folder_ / std::string(StageName(stage)));
    bool struck = false;
    const auto outcome = Run([&](TaskResult& result) {
      if (result.stage == stage && !std::exchange(struck, true)) result.output = Quarantined();
    });
    EXPECT_TRUE(struck);
    EXPECT_EQ(outcome.ok(), stage != Stage::kSurvey) << outcome.status();
    if (!outcome.ok()) continue;
    EXPECT_TRUE(outcome->partial);
    EXPECT_EQ(
        ReportOf(spec_.out())["left"][0]["reason"].get<std::string>(),
        stage == Stage::kAssemble ? "the tile is not written: it killed three workers" : "it killed three workers");
  }
}

TEST_F(ScenePipelineTest, TheHolesOfATileThatIsNotWrittenAreNotFilled) {
  const CellId lost{1, 1};
  const auto outcome = Run([&](TaskResult& result) {
    if (result.stage == Stage::kAssemble && result.cell == lost) result.output = Quarantined();
  });
  ASSERT_TRUE(outcome.ok()) << outcome.status();
  int holes = 0;
  const nlohmann::json report = ReportOf(spec_.out());
  for (const auto& row : report["per_hole"]) {
    const bool in_lost = row["cell"] == nlohmann::json::array({lost.col, lost.row});
    EXPECT_EQ(row["outcome"] == "filled", !in_lost) << row;
    holes += in_lost;
  }
  EXPECT_GT(holes, 0);
}

TEST_F(ScenePipelineTest, AnErrorThatIsNotOfTheCellAloneFailsTheJob) {
  for (const Stage stage : {Stage::kFill, Stage::kAssemble}) {
    absl::Status error = absl::ResourceExhaustedError("the disk is full");
    const auto fail = [&](TaskResult& result) {
      if (result.stage == stage) result.output = error;
    };
    EXPECT_EQ(Run(fail).status(), error);
    error = absl::InvalidArgumentError("malformed");
    EXPECT_THAT(std::string(Run(fail).status().message()), ::testing::MatchesRegex("cell \\+.*: malformed"));
  }
}

// Whatever the surface: what is written is what a run of all cells writes.
TEST_F(ScenePipelineTest, SomeCellsAreWrittenAsInARunOfAll) {
  for (const Surface surface : {Surface::kThinPlate, Surface::kWang}) {
    spec_.set_surface(SurfaceName(surface));
    spec_.set_cells("");
    spec_.set_out(folder_ / ("all" + spec_.surface()));
    ASSERT_TRUE(Run().ok());
    const auto all = TilesBelow(spec_.out());
    const int fills = stages_[Stage::kFill];
    stages_.clear();
    spec_.set_out(folder_ / ("some" + spec_.surface()));
    spec_.set_cells("1,1 2,0-3,0");
    const auto outcome = Run();
    ASSERT_TRUE(outcome.ok()) << outcome.status();
    EXPECT_FALSE(outcome->partial);
    EXPECT_THAT(outcome->message, HasSubstr("holes are in the 3 of 12 cells that were chosen"));
    EXPECT_EQ(progress_.cells, 3);
    EXPECT_EQ(progress_.cells_done, 3);
    EXPECT_EQ(progress_.holes, progress_.holes_filled);
    const auto some = TilesBelow(spec_.out());
    EXPECT_EQ(some.size(), 3U);
    for (const auto& [name, bytes] : some) EXPECT_EQ(all.at(name), bytes) << name;
    EXPECT_LT(stages_[Stage::kFill], fills);
    EXPECT_EQ(stages_[Stage::kAssemble], 3);
    const nlohmann::json report = ReportOf(spec_.out());
    EXPECT_TRUE(report["left"].empty());
    for (const auto& row : report["per_hole"]) {
      const bool chosen = row["cell"] == nlohmann::json::array({1, 1}) || (row["cell"][1] == 0 && row["cell"][0] >= 2);
      EXPECT_EQ(row["outcome"] == "filled", chosen) << row;
    }
    stages_.clear();
  }
}

TEST_F(ScenePipelineTest, CellsThatTheSceneDoesNotHaveAreRefused) {
  spec_.set_cells("1,1 90,90");
  EXPECT_THAT(std::string(ScenePipelineFactory()(spec_, {}).status().message()), HasSubstr("+090_+090"));
}

TEST_F(ScenePipelineTest, AnotherRunTakesOverEverything) {
  ASSERT_TRUE(Run().ok());
  const auto before = TilesBelow(spec_.out());
  nlohmann::json report = ReportOf(spec_.out());
  EXPECT_EQ(report["tasks"]["taken_over"], 0);
  stages_.clear();
  spec_.set_overwrite(true);
  const auto outcome = Run();
  ASSERT_TRUE(outcome.ok()) << outcome.status();
  EXPECT_EQ(TilesBelow(spec_.out()), before);
  EXPECT_EQ(stages_[Stage::kSampleCluster] + stages_[Stage::kFill], 0);
  const int64_t all = report["tasks"]["all"], tiles = std::ssize(before);
  report["tasks"] = {{"all", all}, {"taken_over", all}, {"tiles", tiles}, {"tiles_kept", tiles}};
  int64_t tasks = 0;  // of workers
  for (const auto& [stage, count] : stages_) tasks += count;
  EXPECT_THAT(outcome->message, HasSubstr(absl::StrCat(all, " of ", all, " results taken over, ", all - tasks,
                                                       " of them without a task for a worker")));
  for (const char* name : {"tasks", "per_hole"}) EXPECT_EQ(ReportOf(spec_.out())[name], report[name]) << name;
}

// The plan's numbers of all holes after it are other ones then.
TEST_F(ScenePipelineTest, AHoleMoreInTheFirstTileIsAllThatIsFilledAgain) {
  ASSERT_TRUE(Run().ok());
  const std::string tile = spec_.scene() + "/tiles/Tile_+000_+000.ply";
  std::string bytes = ReadFile(tile).value();
  const std::string count = "element face ";
  const size_t at = bytes.find(count) + count.size();
  const int64_t faces = std::stoll(bytes.substr(at));
  const size_t length = absl::StrCat(faces).size();
  ASSERT_EQ(absl::StrCat(faces - 1).size(), length);
  bytes.replace(at, length, absl::StrCat(faces - 1));
  bytes.resize(bytes.size() - 13);  // the last of its triangles
  WriteTile(tile, bytes);
  stages_.clear();
  spec_.set_overwrite(true);
  ASSERT_TRUE(Run().ok());
  const auto rerun = TilesBelow(spec_.out());
  EXPECT_LE(stages_[Stage::kFill], 4);
  EXPECT_GE(stages_[Stage::kFill], 1);
  const nlohmann::json tasks = ReportOf(spec_.out())["tasks"];
  EXPECT_GT(tasks["taken_over"], 0.5 * tasks["all"].get<double>());
  spec_.set_out(folder_ / "fresh");
  ASSERT_TRUE(Run().ok());
  EXPECT_EQ(TilesBelow(spec_.out()), rerun);
}

TEST_F(ScenePipelineTest, NoTileOfAnEarlierJobStaysWhereNoneIsWritten) {
  ASSERT_TRUE(Run().ok());
  spec_.set_overwrite(true);
  spec_.set_gradation(1.5);
  std::optional<CellId> given_up;
  const auto outcome = Run([&](TaskResult& result) {
    if (result.stage != Stage::kAssemble || given_up) return;
    given_up = result.cell;
    result.output = Quarantined();
  });
  ASSERT_TRUE(outcome.ok()) << outcome.status();
  ASSERT_TRUE(given_up);
  EXPECT_TRUE(outcome->partial);
  EXPECT_FALSE(std::filesystem::exists(spec_.out() + "/tiles/Tile_" + ToString(*given_up) + ".ply"));
}

TEST_F(ScenePipelineTest, AJobThatFailedLeavesItsResultsToTheNext) {
  int assembled = 0;
  const auto fails = [&](TaskResult& result) {
    if (result.stage != Stage::kAssemble || ++assembled < 12) return;
    result.output = absl::ResourceExhaustedError("the disk is full");
  };
  EXPECT_FALSE(Run(fails).ok());
  stages_.clear();
  ASSERT_TRUE(Run().ok());
  EXPECT_EQ(stages_[Stage::kSampleCluster] + stages_[Stage::kFill], 0);
  EXPECT_EQ(stages_[Stage::kAssemble], 12);
}

TEST_F(ScenePipelineTest, AJobThatGoesOnAsksTheSameAgain) {
  ASSERT_TRUE(Run().ok());
  spec_.set_overwrite(true);
  std::vector<std::string> asked;
  for (const bool resumed : {false, true}) {
    const auto pipeline = Make();
    pipeline->Prepare(std::make_shared<JobNotes>(), resumed ? std::optional(Resumption::kRestart) : std::nullopt);
    const auto tasks = pipeline->Start();
    ASSERT_TRUE(tasks.ok());
    for (size_t i = 0; i < tasks->size(); ++i) {
      if (!resumed) asked.push_back((*tasks)[i].input);
      EXPECT_EQ((*tasks)[i].input, asked[i]);
    }
    if (resumed) break;
    const auto survey = SceneStageRunner()(Stage::kSurvey, asked[0], CancelToken());
    ASSERT_TRUE(pipeline->OnTaskDone({(*tasks)[0].cell, Stage::kSurvey, survey}).ok());
  }
}

// Another byte in a tile of an output that is as large as it was, and as if written at another time.
void ChangeATile(const std::string& out) {
  const std::string path = out + "/" + TilesBelow(out).begin()->first, bytes = ReadFile(path).value();
  std::ofstream(path, std::ios::binary) << bytes.substr(1) << "x";
  std::filesystem::last_write_time(path, std::filesystem::last_write_time(path) + std::chrono::hours(1));
}

TEST_F(ScenePipelineTest, ATileThatIsChangedBeforeTheEndFailsTheJob) {
  auto pipeline = Make();
  ASSERT_TRUE(RunTasks(*pipeline).ok());
  ChangeATile(spec_.out());
  EXPECT_EQ(ErrorReason(pipeline->Finish().status()), "OUTPUT_CHANGED");
  pipeline.reset();
  EXPECT_TRUE(Run().ok()) << "again";
}

TEST_F(ScenePipelineTest, ATileThatIsChangedWhileNoCoordinatorRunsFailsTheJob) {
  for (const double verified_share : {0.0, 1.0}) {
    std::deque<std::string> told;
    ASSERT_TRUE(RunTasks(*Make(), [&](TaskResult& result) { told.push_back(*result.output); }).ok());
    ChangeATile(spec_.out());
    const auto pipeline = ScenePipelineFactory("", {.files = verified_share})(spec_, {}).value();
    pipeline->Prepare(std::make_shared<JobNotes>(), Resumption::kRestart);
    const absl::Status status = RunTasks(*pipeline, [&](TaskResult& result) {
      result.known = result.stage != Stage::kVerify;
      if (!result.known) return;
      result.output = told.front();
      told.pop_front();
    });
    EXPECT_EQ(ErrorReason(status), verified_share == 0 ? "" : "OUTPUT_CHANGED");
    std::filesystem::remove_all(spec_.out());
  }
}

TEST_F(ScenePipelineTest, ALinkInThePlaceOfATileIsReplaced) {
  ASSERT_TRUE(Run().ok());
  const auto before = TilesBelow(spec_.out());
  const std::string tile = spec_.out() + "/" + before.begin()->first;
  std::filesystem::rename(tile, folder_ / "moved.ply");
  std::filesystem::create_symlink(folder_ / "moved.ply", tile);
  spec_.set_overwrite(true);
  const auto outcome = Run();
  ASSERT_TRUE(outcome.ok()) << outcome.status();
  EXPECT_FALSE(std::filesystem::is_symlink(tile));
  EXPECT_EQ(TilesBelow(spec_.out()), before);
}

TEST_F(ScenePipelineTest, ASceneWithoutTilesIsRefused) {
  spec_.set_scene(folder_ / "empty");
  folder_.Write("empty/scene.json",
                R"({"cell_size": 10, "cols": 1, "rows": 1, "tiles": [{"col": 0, "row": 0, "path": null}]})");
  const absl::Status status = Make()->Start().status();
  EXPECT_TRUE(absl::IsInvalidArgument(status)) << status;
}

TEST_F(ScenePipelineTest, ACancelBeforeTheEndLeavesNoCompleteOutput) {
  const auto pipeline = Make();
  ASSERT_TRUE(RunTasks(*pipeline).ok());
  EXPECT_FALSE(TilesBelow(spec_.out()).empty());
  EXPECT_TRUE(pipeline->Cancel());
  EXPECT_TRUE(pipeline->Cancel()) << "again";
  EXPECT_TRUE(absl::IsCancelled(pipeline->Finish().status()));
  EXPECT_FALSE(std::filesystem::exists(spec_.out() + "/report.json"));
}

}  // namespace
}  // namespace tilemend
