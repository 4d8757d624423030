// Lies that no check of a result sees, by workers that were caught with another one: the job ended as done with them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <functional>
#include <map>
#include <string>
#include <thread>
#include <utility>

#include "absl/time/clock.h"
#include "common/store/digest.h"
#include "common/store/file_stamp.h"
#include "common/util/files.h"
#include "tests/integration/worker_lies.h"
#include "tests/support/untrusted_workers.h"
#include "tilemend/v1/verify.pb.h"

namespace tilemend {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

// Tells a lie each time, or as often as `times`; the first is waited for.
class Liar {
 public:
  explicit Liar(Lie lie, int times = 1 << 30) : lie_(std::move(lie)), left_(times) {}

  bool Tell(Stage stage, const std::string& input, std::string& output) {
    if (stage != lie_.stage || left_ <= 0 || !lie_.tell(input, output)) return false;
    --left_;
    told_ = true;
    told_.notify_all();
    return true;
  }
  void AwaitFirst() const { told_.wait(false); }
  bool has_told() const { return told_; }

 private:
  const Lie lie_;
  std::atomic<int> left_;
  std::atomic<bool> told_{false};
};

// Plausible: a surface that is sound, but not the one that was asked for.
Lie HigherSeams() {
  return LieIn<v1::SampleClusterOutput>("HigherSeams", Stage::kSampleCluster, [](v1::SampleClusterOutput& samples) {
    for (double& height : *samples.mutable_height()) height += 1;
    return samples.height_size() > 0;
  });
}

// The file is not what the worker says of it.
Lie AByteOff() {
  return LieOf<v1::AssembleInput, Tile>("AByteOff", Stage::kAssemble, [](const v1::AssembleInput& input, Tile& tile) {
    std::string bytes = ReadFile(WrittenPath(input, tile)).value();
    bytes.back() = static_cast<char>(bytes.back() ^ 1);
    return WriteFileAtomically(WrittenPath(input, tile), bytes).ok();
  });
}

class LiesThatEndAsDoneTest : public UntrustedWorkerTest {
 protected:
  explicit LiesThatEndAsDoneTest(const ClusterOptions& options = WithoutReading()) : UntrustedWorkerTest(options) {}
  // As a coordinator is started: it reads no tile, other workers do.
  static ClusterOptions WithoutReading() {
    ClusterOptions options = Options();
    options.check_result = SceneResultCheck(TileCheck::kSize);
    options.durable = true;
    return options;
  }
  static StageRunner Telling(std::function<void(Stage, const std::string&, std::string&)> change) {
    return [change = std::move(change), run = SceneStageRunner()](Stage stage, const std::string& input,
                                                                  const CancelToken& cancel) {
      auto result = run(stage, input, cancel);
      if (result.ok()) change(stage, input, *result);
      return result;
    };
  }
  void ExpectDoneAs(const std::map<std::string, std::string>& undisturbed, const v1::Job& job) {
    ASSERT_EQ(job.state(), v1::DONE) << job.error().message();
    EXPECT_EQ(TilesBelow(Out(job)), undisturbed);
  }
  double SetAside() { return cluster_.Metric("tilemend_coordinator_workers_set_aside"); }
};

TEST_F(LiesThatEndAsDoneTest, AllThatALiarGaveIsDoneAgainWhenOneResultIsRefused) {
  const auto undisturbed = Undisturbed();
  Liar plausible(HigherSeams());
  Liar wrong(LieIn<v1::FillOutput>("", Stage::kFill,
                                   [](v1::FillOutput& fill) { return fill.mutable_patches()->RemoveLast(), true; }),
             1);
  cluster_.AddWorker("liar", 1, Telling([&](Stage stage, const std::string& input, std::string& output) {
                       plausible.Tell(stage, input, output);
                       wrong.Tell(stage, input, output);
                     }));
  const v1::Job submitted = cluster_.Submit(scene_);
  wrong.AwaitFirst();
  cluster_.AddWorker("good", 2, SceneStageRunner());
  ExpectDoneAs(undisturbed, cluster_.WaitFor(submitted.name()));
  EXPECT_TRUE(plausible.has_told());
  EXPECT_EQ(SetAside(), 1);
}

TEST_F(LiesThatEndAsDoneTest, ATileThatIsNotAsItsWriterSaysIsMadeAgainWithAllThatThisGave) {
  const auto undisturbed = Undisturbed();
  Liar plausible(HigherSeams()), tile(AByteOff());
  cluster_.AddWorker("liar", 1, Telling([&](Stage stage, const std::string& input, std::string& output) {
                       plausible.Tell(stage, input, output);
                       tile.Tell(stage, input, output);
                     }));
  const v1::Job submitted = cluster_.Submit(scene_);
  tile.AwaitFirst();
  cluster_.AddWorker("good", 2, SceneStageRunner());
  const v1::Job job = cluster_.WaitFor(submitted.name());
  ExpectDoneAs(undisturbed, job);
  ASSERT_EQ(job.warnings_size(), 1);
  EXPECT_THAT(job.warnings(0), HasSubstr("worker liar wrote something else than it reported to"));
  EXPECT_EQ(SetAside(), 1);
}

TEST_F(LiesThatEndAsDoneTest, OfTheOnlyWorkerTheJobFails) {
  Liar tile(AByteOff());
  cluster_.AddWorker("liar", 1, Telling([&](Stage stage, const std::string& input, std::string& output) {
                       tile.Tell(stage, input, output);
                     }));
  const v1::Job job = cluster_.WaitFor(cluster_.Submit(scene_).name());
  EXPECT_EQ(job.state(), v1::FAILED);
  EXPECT_THAT(job.error().message(), HasSubstr("worker liar wrote something else than it reported to"));
  EXPECT_EQ(SetAside(), 0) << "it may be the disk";
}

TEST_F(LiesThatEndAsDoneTest, WhoSaysAFalseDigestOfATileOfTheSceneIsCaught) {
  const auto undisturbed = Undisturbed();
  const std::string tile = scene_ + "/tiles/Tile_+000_+000.ply";
  while (StampOf(tile, absl::Now()).empty()) std::this_thread::yield();  // it was just written
  Liar survey(LieIn<Survey>("", Stage::kSurvey,
                            [](Survey& s) {
                              s.set_digest(FileDigest("another"));
                              s.mutable_witness()->set_digest(s.digest());
                              return true;
                            }),
              1);
  cluster_.AddWorker("liar", 1, Telling([&](Stage stage, const std::string& input, std::string& output) {
                       survey.Tell(stage, input, output);
                     }));
  const v1::Job submitted = cluster_.Submit(scene_);
  survey.AwaitFirst();
  cluster_.AddWorker("good", 2, SceneStageRunner());
  const v1::Job job = cluster_.WaitFor(submitted.name());
  ExpectDoneAs(undisturbed, job);
  EXPECT_THAT(job.warnings(), Contains(HasSubstr("worker liar reported a wrong digest of")));
}

// Every result is computed again.
class ComputedAgainTest : public LiesThatEndAsDoneTest {
 protected:
  ComputedAgainTest() : LiesThatEndAsDoneTest(ComputingAgain()) {}
  static ClusterOptions ComputingAgain() {
    ClusterOptions options = WithoutReading();
    options.factory = ScenePipelineFactory("", {.files = 1, .results = 1});
    return options;
  }
  // One worker lies once, and reports it when two others are there.
  v1::Job RunWithLiar(Lie lie) {
    Liar liar(std::move(lie), 1);
    std::atomic<bool> others{false};
    cluster_.AddWorker("liar", 1, Telling([&](Stage stage, const std::string& input, std::string& output) {
                         if (liar.Tell(stage, input, output)) others.wait(false);
                       }));
    const v1::Job submitted = cluster_.Submit(scene_);
    liar.AwaitFirst();
    for (const char* good : {"one", "other"}) cluster_.AddWorker(good, 1, SceneStageRunner());
    others = true;
    others.notify_all();
    v1::Job job = cluster_.WaitFor(submitted.name());
    cluster_.KillWorker("liar");
    return job;
  }
  void ExpectCaught(Lie lie) {
    const auto undisturbed = Undisturbed();
    const v1::Job job = RunWithLiar(std::move(lie));
    ExpectDoneAs(undisturbed, job);
    EXPECT_THAT(job.warnings(), ElementsAre(HasSubstr("worker liar gave another result")));
    EXPECT_EQ(SetAside(), 1);
  }
};

TEST_F(ComputedAgainTest, PlausibleHeightsAreCaught) { ExpectCaught(HigherSeams()); }

TEST_F(ComputedAgainTest, ASurveyThatNoCheckRefusesIsCaught) {
  ExpectCaught(LieIn<Survey>("", Stage::kSurvey,
                             [](Survey& s) { return s.set_doubled_vertices(s.doubled_vertices() + 1), true; }));
}

TEST_F(ComputedAgainTest, HonestWorkersAgree) {
  const auto undisturbed = Undisturbed();
  for (const char* name : {"one", "two", "three"}) cluster_.AddWorker(name, 1, SceneStageRunner());
  const v1::Job job = cluster_.WaitFor(cluster_.Submit(scene_).name());
  ExpectDoneAs(undisturbed, job);
  EXPECT_EQ(job.warnings_size(), 0);
}

TEST_F(LiesThatEndAsDoneTest, WhoAccusesAnotherFalselyIsCaught) {
  const auto undisturbed = Undisturbed();
  std::atomic<bool> lied{false};
  cluster_.AddWorker("liar", 2, Telling([&](Stage stage, const std::string&, std::string& output) {
                       v1::VerifyOutput verified;
                       if (stage != Stage::kVerify || !verified.ParseFromString(output)) return;
                       verified.mutable_files(0)->set_digest(FileDigest("another"));
                       output = verified.SerializeAsString();
                       lied = true;
                     }));
  cluster_.AddWorker("good", 2, SceneStageRunner());
  const v1::Job job = cluster_.WaitFor(cluster_.Submit(scene_).name());
  ExpectDoneAs(undisturbed, job);
  EXPECT_EQ(job.warnings_size(), lied ? 1 : 0);
  EXPECT_EQ(SetAside(), lied ? 1 : 0);
}

}  // namespace
}  // namespace tilemend
