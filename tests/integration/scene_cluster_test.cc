// A coordinator and workers as processes on a real scene: the same bytes as `tilemend run`, also when a worker dies,
// and everything that a client can ask.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "absl/strings/numbers.h"
#include "absl/strings/str_cat.h"
#include "tests/support/http_get.h"
#include "tests/support/output_checks.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/water_scenes.h"

namespace tilemend {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using Json = nlohmann::json;

int PortIn(const std::string& rest) {
  int port = 0;
  EXPECT_TRUE(absl::SimpleAtoi(rest, &port)) << rest;
  return port;
}

class SceneClusterTest : public ::testing::Test {
 protected:
  void SetUp() override {
    coordinator_ = std::make_unique<Process>(
        folder_.path(), TILEMEND_COORDINATOR,
        std::vector<std::string>{"--listen", "127.0.0.1:0", "--metrics", "127.0.0.1:0", "--work", folder_ / "work",
                                 "--lease", "3", "--log", "text"});
    coordinator_metrics_ = PortIn(coordinator_->AwaitLine("metrics served address=127.0.0.1:"));
    address_ = "127.0.0.1:" + coordinator_->AwaitLine("listening address=127.0.0.1:");
  }

  std::unique_ptr<Process> NewWorker() {
    return std::make_unique<Process>(folder_.path(), TILEMEND_WORKER,
                                     std::vector<std::string>{"--coordinator", address_, "--threads", "1", "--metrics",
                                                              "127.0.0.1:0", "--log", "text"});
  }

  Ended Tilemend(const std::vector<std::string>& words) {
    return Process(folder_.path(), TILEMEND_CLIENT, words).Wait();
  }
  Ended Ask(std::vector<std::string> words) {
    words.insert(words.end(), {"--coordinator", address_});
    return Tilemend(words);
  }
  Json AskJson(std::vector<std::string> words) {
    words.insert(words.end(), {"-o", "json"});
    const Ended ended = Ask(words);
    Json json = Json::parse(ended.out, nullptr, false);
    EXPECT_FALSE(json.is_discarded()) << ended.code << ended.err;
    return json;
  }
  std::string Submit(const std::string& scene, const std::string& out) {
    return AskJson({"submit", scene, "--out", out}).value("name", "");
  }
  bool HasDone(const std::string& job, int64_t tasks) {
    return AskJson({"get", job})["progress"]["tasks_done"].get<int64_t>() >= tasks;
  }
  // The tiles of `tilemend run`.
  std::map<std::string, std::string> TilesOfRun(const std::string& scene) {
    const Ended ended = Tilemend({"run", scene, "--out", folder_ / "run"});
    EXPECT_EQ(ended.code, 0) << ended.err;
    return TilesBelow(folder_ / "run");
  }

  TemporaryFolder folder_;
  std::unique_ptr<Process> coordinator_;
  int coordinator_metrics_ = 0;
  std::string address_;
};

TEST_F(SceneClusterTest, ThreeWorkersGiveTheBytesOfARun) {
  const std::string scene = WriteMade(SmallScene(Cut::kRagged), folder_ / "scene");
  const auto a = NewWorker(), b = NewWorker(), c = NewWorker();
  const Ended ended = Ask({"submit", scene, "--out", folder_ / "out", "--wait", "-o", "json"});
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_EQ(Json::parse(ended.out, nullptr, false)["state"], "done");
  EXPECT_EQ(TilesBelow(folder_ / "out"), TilesOfRun(scene));
  ExpectOriginalsKept(scene, folder_ / "out");
}

// A lake of three layers, dispatched one after the other, and the seams after them.
TEST_F(SceneClusterTest, ThreeWorkersGiveTheBytesOfOneWithTheLayersOfWang) {
  SceneMakerOptions options;
  options.cols = options.rows = 5;
  options.cut = Cut::kRagged;
  options.ellipses = {{{125, 125}, {115, 115}}};
  const std::string scene = WriteMade(options, folder_ / "scene");
  const auto submit = [&](const char* out) {
    return Ask({"submit", scene, "--out", folder_ / out, "--surface", "wang", "--wait"});
  };
  const auto alone = NewWorker();
  ASSERT_EQ(submit("one").code, 0);
  const auto b = NewWorker(), c = NewWorker();
  ASSERT_EQ(submit("three").code, 0);
  EXPECT_EQ(ReportOf(folder_ / "three")["layers"], 3);
  EXPECT_EQ(ReportOf(folder_ / "three")["filled"], ReportOf(folder_ / "three")["holes"]);
  EXPECT_EQ(TilesBelow(folder_ / "three"), TilesBelow(folder_ / "one"));
  ExpectOriginalsKept(scene, folder_ / "three");
  ExpectClosed(options, folder_ / "three");
}

TEST_F(SceneClusterTest, TheCoordinatorReadsTheAreasOfWater) {
  const std::string scene = WriteMade(LakeOverNineCells(Cut::kClipped), folder_ / "scene");
  const std::string areas = folder_.Write("dry.geojson",
                                          R"({"type": "Feature", "properties": {"water": false}, "geometry":
      {"type": "Polygon", "coordinates": [[[0, 0], [120, 0], [120, 120], [0, 120], [0, 0]]]}})");
  const auto worker = NewWorker();
  ASSERT_EQ(Ask({"submit", scene, "--out", folder_ / "lake", "--wait"}).code, 0);
  EXPECT_EQ(ReportOf(folder_ / "lake")["water"].size(), 1U);
  ASSERT_EQ(Ask({"submit", scene, "--out", folder_ / "dry", "--wait", "--water", areas}).code, 0);
  EXPECT_EQ(ReportOf(folder_ / "dry")["water"].size(), 0U);
  folder_.Write("dry.geojson", R"({"type": "Point"})");
  const Ended bad = Ask({"submit", scene, "--out", folder_ / "bad", "--wait", "--water", areas});
  EXPECT_EQ(bad.code, 4);
  EXPECT_THAT(bad.out + bad.err, HasSubstr("dry.geojson: "));
}

// The only worker is stopped half-way, so that it holds tasks, and then killed.
TEST_F(SceneClusterTest, OtherWorkersTakeTheCellsOfOneThatWasKilled) {
  SceneMakerOptions options = SmallScene(Cut::kClipped);
  options.cols = options.rows = 10;
  options.ellipses.push_back({{100, 120}, {50, 35}});
  const std::string scene = WriteMade(options, folder_ / "scene");
  auto victim = NewWorker();
  const std::string job = Submit(scene, folder_ / "out");
  ASSERT_TRUE(Await([&] { return HasDone(job, 20); }));
  victim->Signal(SIGSTOP);
  const Json before = AskJson({"get", job});
  ASSERT_EQ(before["state"], "running");
  ASSERT_GT(before["progress"]["tasks_running"], 0);
  victim->Signal(SIGKILL);
  EXPECT_EQ(victim->Wait().code, -SIGKILL);
  const auto b = NewWorker(), c = NewWorker();
  const Ended ended = Ask({"watch", job, "-o", "json"});
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_GT(Json::parse(ended.out, nullptr, false)["progress"]["tasks_retried"], 0);
  EXPECT_EQ(TilesBelow(folder_ / "out"), TilesOfRun(scene));
  ExpectClosed(options, folder_ / "out");
}

TEST_F(SceneClusterTest, MetricsCountTheTasksOfAJob) {
  const std::string scene = WriteMade(SmallScene(Cut::kClipped), folder_ / "scene");
  const auto worker = NewWorker();
  const int worker_metrics = PortIn(worker->AwaitLine("metrics served address=127.0.0.1:"));
  ASSERT_EQ(Ask({"submit", scene, "--out", folder_ / "out", "--wait"}).code, 0);
  const std::string coordinator = HttpGet(coordinator_metrics_, "/metrics");
  EXPECT_THAT(coordinator, HasSubstr("200 OK"));
  for (const char* stage : {"survey", "assemble"}) {
    EXPECT_THAT(coordinator,
                HasSubstr(absl::StrCat("tilemend_coordinator_tasks_finished_total{stage=\"", stage, "\"} 12\n")));
  }
  EXPECT_THAT(coordinator, Not(HasSubstr("tilemend_coordinator_tasks_finished_total{stage=\"fill\"} 0\n")));
  EXPECT_THAT(coordinator, HasSubstr("tilemend_coordinator_tasks_failed_total{stage=\"fill\"} 0\n"));
  EXPECT_THAT(coordinator, HasSubstr("tilemend_coordinator_jobs{state=\"done\"} 1\n"));
  EXPECT_THAT(coordinator, HasSubstr("tilemend_coordinator_workers_connected 1\n"));
  const std::string mine = HttpGet(worker_metrics, "/metrics");
  EXPECT_THAT(mine, HasSubstr("tilemend_worker_tasks_finished_total{stage=\"survey\"} 12\n"));
  EXPECT_THAT(mine, HasSubstr("tilemend_worker_task_seconds_count{stage=\"assemble\"} 12\n"));
  EXPECT_THAT(mine, HasSubstr("tilemend_worker_connected 1\n"));
}

TEST_F(SceneClusterTest, SubmitGetListWatchCancelRetry) {
  const std::string scene = WriteMade(SmallScene(Cut::kClipped), folder_ / "scene");
  const std::vector<std::string> submit = {"submit", scene, "--out", folder_ / "out", "--request-id", "one"};
  const std::string job = AskJson(submit).value("name", "");  // there is no worker yet
  EXPECT_EQ(AskJson(submit).value("name", ""), job);
  EXPECT_EQ(Ask({"submit", scene, "--out", folder_ / "else", "--request-id", "one"}).code, 4);
  const Ended busy = Ask({"submit", scene, "--out", folder_ / "out"});
  EXPECT_EQ(busy.code, 5);
  EXPECT_THAT(busy.err, HasSubstr(job));
  EXPECT_EQ(AskJson({"get", job})["state"], "running");
  EXPECT_EQ(AskJson({"list"}).size(), 1U);
  EXPECT_EQ(Ask({"get", "jobs/none"}).code, 3);
  EXPECT_EQ(Ask({"retry", job}).code, 6);
  EXPECT_EQ(Ask({"cancel", job}).code, 0);
  EXPECT_EQ(Ask({"watch", job}).code, 7);
  // The cancelled job ends on a thread of its own, which takes the folder away again.
  EXPECT_TRUE(Await([&] { return !std::filesystem::exists(folder_ / "out"); }));
  const auto worker = NewWorker();
  const Ended again = Ask({"retry", job, "--wait", "-o", "json"});
  EXPECT_EQ(again.code, 0) << again.err;
  EXPECT_NE(Json::parse(again.out, nullptr, false)["name"], job);
  EXPECT_EQ(AskJson({"list"}).size(), 2U);
  EXPECT_EQ(TilesBelow(folder_ / "out"), TilesOfRun(scene));
}

TEST_F(SceneClusterTest, ABadSceneFailsTheJobWithItsReason) {
  const std::string scene = WriteMade(SmallScene(Cut::kClipped), folder_ / "scene");
  folder_.Write("scene/tiles/Tile_+001_+001.ply", "ply\n");
  const auto worker = NewWorker();
  const Ended ended = Ask({"submit", scene, "--out", folder_ / "out", "--wait"});
  EXPECT_EQ(ended.code, 4) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("Tile_+001_+001.ply"));
  EXPECT_TRUE(Await([&] { return !std::filesystem::exists(folder_ / "out"); }));
}

TEST_F(SceneClusterTest, AWorkerFinishesWhatItHasWhenItIsToldToEnd) {
  const std::string scene = WriteMade(SmallScene(Cut::kClipped), folder_ / "scene");
  const auto first = NewWorker();
  const std::string job = Submit(scene, folder_ / "out");
  ASSERT_TRUE(Await([&] { return HasDone(job, 1); }));
  first->Signal(SIGTERM);
  EXPECT_EQ(first->Wait().code, 0);
  const auto second = NewWorker();
  const Ended ended = Ask({"watch", job, "-o", "json"});
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_EQ(Json::parse(ended.out, nullptr, false)["progress"]["tasks_quarantined"], 0);
  EXPECT_EQ(TilesBelow(folder_ / "out"), TilesOfRun(scene));
}

TEST_F(SceneClusterTest, ACoordinatorThatIsToldToEndLeavesNoHalfOutput) {
  const std::string scene = WriteMade(SmallScene(Cut::kClipped), folder_ / "scene");
  Submit(scene, folder_ / "out");  // no worker: it waits
  ASSERT_TRUE(Await([&] { return std::filesystem::exists(folder_ / "out/.tilemend-job"); }));
  coordinator_->Signal(SIGTERM);
  EXPECT_EQ(coordinator_->Wait().code, 0);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out"));
  const Ended unreachable = Ask({"list"});
  EXPECT_EQ(unreachable.code, 5);
  EXPECT_THAT(unreachable.err, HasSubstr("cannot reach the coordinator"));
}

}  // namespace
}  // namespace tilemend
