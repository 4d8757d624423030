// A coordinator that was killed again and again before the last verification: each one verified everything anew, and
// the job stood still.
#include <gtest/gtest.h>

#include <atomic>
#include <string>

#include "absl/strings/str_cat.h"
#include "absl/time/clock.h"
#include "tests/support/untrusted_workers.h"

namespace tilemend {
namespace {

// Does this many verifications, and then no more.
class FewVerifications {
 public:
  explicit FewVerifications(int most) : left_(most) {}
  StageRunner Runner() {
    return [this, run = SceneStageRunner()](Stage stage, const std::string& input, const CancelToken& cancel) {
      if (stage != Stage::kVerify || --left_ >= 0) return run(stage, input, cancel);
      is_at_end_ = true;
      while (!cancel.cancelled()) absl::SleepFor(absl::Milliseconds(1));
      return absl::StatusOr<std::string>(absl::CancelledError("no more"));
    };
  }
  bool is_at_end() const { return is_at_end_; }

 private:
  std::atomic<int> left_;
  std::atomic<bool> is_at_end_{false};
};

class CoordinatorsThatLiveShortlyTest : public UntrustedWorkerTest {
 protected:
  CoordinatorsThatLiveShortlyTest() : UntrustedWorkerTest(VerifyingAll()) {}
  static ClusterOptions VerifyingAll() {
    ClusterOptions options = Options();
    options.check_result = SceneResultCheck(TileCheck::kSize);
    options.factory = ScenePipelineFactory("", {.files = 1, .results = 1});
    options.durable = true;
    return options;
  }
  // Whether the job ends before the coordinator does.
  bool LiveFor(int verifications, const std::string& job, const std::string& worker) {
    FewVerifications few(verifications);
    cluster_.AddWorker(worker, 2, few.Runner());
    while (cluster_.Get(job).state() == v1::RUNNING) {
      if (few.is_at_end()) {
        cluster_.Restart();
        return false;
      }
      absl::SleepFor(absl::Milliseconds(1));
    }
    cluster_.KillWorker(worker);
    return true;
  }
};

TEST_F(CoordinatorsThatLiveShortlyTest, EachGetsFurther) {
  constexpr int kVerifications = 5, kMostLives = 40;
  const auto undisturbed = Undisturbed();
  const std::string job = cluster_.Submit(scene_).name();
  int lives = 1;
  while (lives < kMostLives && !LiveFor(kVerifications, job, absl::StrCat("w", lives))) ++lives;
  EXPECT_GT(lives, 3) << "one coordinator could do it: the test shows nothing";
  ASSERT_EQ(cluster_.Get(job).state(), v1::DONE) << lives << " coordinators";
  EXPECT_TRUE(TilesBelow(Out(cluster_.Get(job))) == undisturbed) << "other bytes";
}

}  // namespace
}  // namespace tilemend
