// A worker whose large tile was looked at for longer than its lease was declared lost, and the tile stayed behind.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <filesystem>
#include <set>
#include <string>
#include <utility>

#include "absl/time/clock.h"
#include "absl/time/time.h"
#include "tests/support/untrusted_workers.h"

namespace tilemend {
namespace {

using ::testing::IsEmpty;

class CheckingIsNoSilenceTest : public UntrustedWorkerTest {
 protected:
  CheckingIsNoSilenceTest() : UntrustedWorkerTest(SlowChecks()) { cluster = &cluster_; }
  ~CheckingIsNoSilenceTest() override { cluster = nullptr; }

  // Time passes while a tile is looked at; the coordinator goes on with other things meanwhile.
  static ClusterOptions SlowChecks() {
    ClusterOptions options = Options();
    options.fake_clock = true;
    options.check_result = [check = SceneResultCheck(TileCheck::kSize)](Stage stage, const std::string& input,
                                                                        const std::string& output) {
      if (stage == Stage::kAssemble && is_slow) cluster->ExpireLeases();
      return check(stage, input, output);
    };
    return options;
  }
  std::set<std::string> Attempts() {
    std::set<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(cluster_.folder() / "out-1/.tilemend-attempts")) {
      names.insert(entry.path().filename().string());
    }
    names.erase("key");
    return names;
  }
  // Once there are none, or after ten seconds. The late report comes while its worker has its next task already.
  std::set<std::string> AttemptsInTheEnd() {
    for (int tries = 0; tries < 1000 && !Attempts().empty(); ++tries) absl::SleepFor(absl::Milliseconds(10));
    return Attempts();
  }
  double Lost() { return cluster_.Metric("tilemend_coordinator_workers_lost_total"); }

  static inline TestCluster* cluster = nullptr;
  static inline std::atomic<bool> is_slow{true};
};

TEST_F(CheckingIsNoSilenceTest, NoWorkerIsLostWhileItsResultsAreLookedAt) {
  is_slow = true;
  cluster_.AddWorker("worker", 1, SceneStageRunner());
  const v1::Job job = cluster_.WaitFor(cluster_.Submit(scene_).name());
  EXPECT_EQ(job.state(), v1::DONE) << job.error().message();
  EXPECT_EQ(Lost(), 0);
  EXPECT_EQ(job.progress().tasks_retried(), 0);
}

TEST_F(CheckingIsNoSilenceTest, TheFilesOfALostAttemptGo) {
  is_slow = false;
  std::atomic<int> tiles{0};
  std::set<std::string> left;
  cluster_.AddWorker("worker", 1,
                     [&, run = SceneStageRunner()](Stage stage, const std::string& input, const auto& cancel) {
                       if (stage == Stage::kAssemble && ++tiles == 2) left = AttemptsInTheEnd();
                       const CancelToken never;  // it does not hear in time that it is lost
                       auto result = run(stage, input, stage == Stage::kAssemble ? never : cancel);
                       if (stage == Stage::kAssemble && tiles == 1) cluster_.ExpireLeases();
                       return result;
                     });
  const v1::Job job = cluster_.WaitFor(cluster_.Submit(scene_).name());
  EXPECT_EQ(job.state(), v1::DONE) << job.error().message();
  EXPECT_EQ(Lost(), 1) << "it is late";
  EXPECT_THAT(left, IsEmpty());
}

}  // namespace
}  // namespace tilemend
