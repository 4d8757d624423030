#include "coordinator/jobs/result_checks.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <deque>
#include <functional>
#include <map>
#include <random>

#include "common/options/job_options.h"
#include "common/records/surface.h"
#include "common/rpc/stage_payloads.h"
#include "common/store/digest.h"
#include "common/util/files.h"
#include "coordinator/jobs/scene_pipeline.h"
#include "tests/support/output_checks.h"
#include "tests/support/temporary_folder.h"
#include "tilemend/v1/stages.pb.h"
#include "worker/service/scene_stages.h"

namespace tilemend {
namespace {

struct Exchange {
  Stage stage;
  std::string input, output;
};

// What a sound worker is asked and gives in a small scene, stage by stage; its files are there.
class ResultChecksTest : public testing::Test {
 protected:
  // `see` is called with each exchange before the pipeline takes it.
  void Run(const std::function<void(const Exchange&)>& see, Surface surface = Surface::kThinPlate) {
    WriteMade(SmallScene(Cut::kClipped), folder_ / "scene");
    JobSpec spec = WithDefaults({});
    spec.set_scene(folder_ / "scene");
    spec.set_out(folder_ / std::string(SurfaceName(surface)));
    spec.set_surface(SurfaceName(surface));
    auto pipeline = ScenePipelineFactory()(spec, {});
    ASSERT_TRUE(pipeline.ok()) << pipeline.status();
    auto tasks = (*pipeline)->Start();
    ASSERT_TRUE(tasks.ok()) << tasks.status();
    std::deque<NewTask> open(tasks->begin(), tasks->end());
    while (!open.empty()) {
      const NewTask task = open.front();
      open.pop_front();
      auto output = SceneStageRunner()(task.stage, WholeInput(task).value(), CancelToken());
      ASSERT_TRUE(output.ok()) << output.status();
      see({task.stage, task.input, *output});
      tasks = (*pipeline)->OnTaskDone({task.cell, task.stage, *std::move(output)});
      ASSERT_TRUE(tasks.ok()) << tasks.status();
      open.insert(open.end(), tasks->begin(), tasks->end());
    }
  }

  const TemporaryFolder folder_;
  const ResultCheck check_ = SceneResultCheck(TileCheck::kContent);
};

TEST_F(ResultChecksTest, TakesWhatASoundWorkerGives) {
  std::map<Stage, int> seen;
  const auto see = [&](const Exchange& e) {
    ++seen[e.stage];
    for (const TileCheck how : {TileCheck::kSize, TileCheck::kContent}) {
      const absl::Status status = SceneResultCheck(how)(e.stage, e.input, e.output);
      EXPECT_TRUE(status.ok()) << StageName(e.stage) << ": " << status;
    }
  };
  Run(see);
  Run(see, Surface::kWang);
  // Layers are sampled alone only where cells have holes in several, or a cluster has no surface.
  EXPECT_EQ(seen.count(Stage::kSampleLayer), 0U);
  // Heights are measured only where surface is taken out.
  EXPECT_EQ(seen.count(Stage::kMeasure), 0U);
  // Files are verified only if that is asked for.
  EXPECT_EQ(seen.size(), kAllStages.size() - 3);
}

TEST_F(ResultChecksTest, KeepsTheRecordsOfSoundSurveys) {
  const auto surveys = std::make_shared<DecodedSurveys>();
  const ResultCheck check = SceneResultCheck(TileCheck::kSize, surveys);
  int kept = 0;
  Run([&](const Exchange& e) {
    v1::SurveyOutput survey;
    if (e.stage != Stage::kSurvey || !survey.ParseFromString(e.output)) return;
    ASSERT_TRUE(check(e.stage, e.input, e.output).ok());
    const auto record = surveys->Take(e.output);
    ASSERT_TRUE(record);
    EXPECT_EQ(ToProto(*record).band().draco(), survey.band().draco());
    ++kept;
    survey.set_triangle_count(-1);
    const std::string lie = survey.SerializeAsString();
    EXPECT_TRUE(absl::IsDataLoss(check(e.stage, e.input, lie)));
    EXPECT_FALSE(surveys->Take(lie));
  });
  EXPECT_GT(kept, 1);
}

TEST_F(ResultChecksTest, ReadsTilesAsCloselyAsItIsTold) {
  const auto taken = [](TileCheck how, const Exchange& e) {
    return SceneResultCheck(how)(e.stage, e.input, e.output).ok();
  };
  int surveys = 0, patched = 0;
  const auto see = [&](const Exchange& e) {
    v1::SurveyOutput survey;
    if (e.stage == Stage::kSurvey && survey.ParseFromString(e.output)) {
      ++surveys;
      survey.set_digest(FileDigest("another tile"));
      survey.mutable_witness()->set_digest(survey.digest());
      const Exchange lie{e.stage, e.input, survey.SerializeAsString()};
      EXPECT_TRUE(taken(TileCheck::kSize, lie));
      EXPECT_FALSE(taken(TileCheck::kContent, lie));
    }
    v1::AssembleInput input;
    v1::AssembleOutput tile;
    if (e.stage != Stage::kAssemble || !input.ParseFromString(e.input) || !tile.ParseFromString(e.output)) return;
    if (!input.has_patches()) return;
    ++patched;
    v1::WrittenFile& file = *tile.mutable_files(0);
    const std::string path = input.attempts() + "/" + file.attempt(), sound = ReadFile(path).value();
    const std::string other = sound.substr(0, sound.size() - 1) + static_cast<char>(sound.back() ^ 1);
    ASSERT_TRUE(WriteFileAtomically(path, other).ok());
    file.set_digest(FileDigest(other));
    const Exchange lie{e.stage, e.input, tile.SerializeAsString()};
    EXPECT_TRUE(taken(TileCheck::kSize, lie));
    EXPECT_FALSE(taken(TileCheck::kContent, lie));
    EXPECT_TRUE(taken(TileCheck::kSize, e)) << "without reading the tile";
    ASSERT_TRUE(WriteFileAtomically(path, sound).ok());
    EXPECT_FALSE(taken(TileCheck::kContent, lie)) << "of a digest that is not the file's";
  };
  Run(see);
  EXPECT_GT(surveys, 0);
  EXPECT_GT(patched, 0);
}

// Two contents with one digest. XXH3 multiplies the halves of each eight bytes that were combined with a known constant
// and adds them elsewhere as they are: where the lower half becomes 0, two upper halves can change places.
std::string Forged(uint32_t first, uint32_t second) {
  std::string bytes(1024, 'x');
  const std::array<uint32_t, 2> a = {0x396cfeb8, first}, b = {0x2c81017c, second};
  std::memcpy(bytes.data(), a.data(), sizeof a);
  std::memcpy(bytes.data() + 64, b.data(), sizeof b);
  return bytes;
}

TEST_F(ResultChecksTest, ComparesATileWithoutPatchByteByByteIfItIsToldTo) {
  const std::string original = Forged(1, 2), other = Forged(2, 1);
  ASSERT_EQ(FileDigest(original), FileDigest(other));
  v1::AssembleInput input;
  input.mutable_tile()->set_root(folder_.path());
  input.mutable_tile()->set_path("a.ply");
  input.mutable_tile()->set_digest(FileDigest(original));
  input.set_output("a.ply");
  input.set_attempts(folder_.path());
  folder_.Write("a.ply", original);
  v1::AssembleOutput output;
  v1::WrittenFile& file = *output.add_files();
  file.set_path("a.ply");
  file.set_attempt("0123456789abcdef0123456789abcdef-0");
  file.set_bytes(1024);
  file.set_digest(FileDigest(original));
  const auto check = [&](TileCheck how, const std::string& written) {
    folder_.Write(file.attempt(), written);
    return SceneResultCheck(how)(Stage::kAssemble, input.SerializeAsString(), output.SerializeAsString());
  };
  EXPECT_TRUE(check(TileCheck::kContent, original).ok()) << check(TileCheck::kContent, original);
  EXPECT_TRUE(absl::IsDataLoss(check(TileCheck::kContent, std::string(1024, 'y'))));
  EXPECT_TRUE(check(TileCheck::kSize, other).ok());
  EXPECT_TRUE(absl::IsDataLoss(check(TileCheck::kContent, other)));
}

TEST_F(ResultChecksTest, RefusesHeightsOfASeamBeyondThePatches) {
  int seams = 0;
  const auto see = [&](const Exchange& e) {
    v1::SmoothSeamOutput output;
    if (e.stage != Stage::kSmoothSeam || !output.ParseFromString(e.output) || output.a().height().empty()) return;
    ++seams;
    const auto refused = [&](const auto& change) {
      v1::SmoothSeamOutput other = output;
      change(other);
      return absl::IsDataLoss(check_(e.stage, e.input, other.SerializeAsString()));
    };
    EXPECT_TRUE(refused([](auto& o) { o.set_number(o.number() + 1); }));
    EXPECT_TRUE(refused([](auto& o) { o.add_height(0); }));
    EXPECT_TRUE(refused([](auto& o) { o.mutable_height()->Set(0, 1e6); }));
    EXPECT_TRUE(refused([](auto& o) { o.mutable_a()->mutable_height()->Set(0, -1e6); }));
    EXPECT_TRUE(refused([](auto& o) { o.mutable_a()->mutable_height()->Set(0, std::nan("")); }));
    EXPECT_TRUE(refused([](auto& o) { o.mutable_b()->add_point(1'000'000), o.mutable_b()->add_height(0); }));
  };
  Run(see, Surface::kWang);
  EXPECT_GT(seams, 0);
}

TEST_F(ResultChecksTest, RefusesAFillWithoutItsSamples) {
  int fills = 0;
  const auto see = [&](const Exchange& e) {
    v1::FillInput input;
    v1::FillOutput output;
    if (e.stage != Stage::kFill || !input.ParseFromString(e.input) || !input.has_sampled()) return;
    ASSERT_TRUE(output.ParseFromString(e.output));
    ++fills;
    output.mutable_samples()->mutable_height()->Set(0, std::nan(""));
    EXPECT_TRUE(absl::IsDataLoss(check_(e.stage, e.input, output.SerializeAsString())));
    output.clear_samples();
    EXPECT_TRUE(absl::IsDataLoss(check_(e.stage, e.input, output.SerializeAsString())));
  };
  Run(see, Surface::kWang);
  EXPECT_GT(fills, 0);
}

// Bytes from the network may be anything: the check says no, and does not fall over.
TEST_F(ResultChecksTest, AnswersWhateverTheBytes) {
  std::mt19937 random(1);
  int refused = 0;
  Run([&](const Exchange& e) {
    for (int round = 0; round < 60; ++round) {
      std::string bytes = e.output;
      for (uint32_t changes = 1 + random() % 4; changes > 0 && !bytes.empty(); --changes) {
        const size_t at = random() % bytes.size();
        const uint32_t how = random() % 3;
        if (how == 0) bytes[at] = static_cast<char>(random());
        if (how == 1) bytes.erase(at, 1 + random() % 8);
        if (how == 2) bytes.insert(at, std::string(1 + random() % 8, static_cast<char>(random())));
      }
      const absl::Status status = check_(e.stage, e.input, bytes);
      refused += status.ok() ? 0 : 1;
    }
  });
  EXPECT_GT(refused, 1000);
}

TEST_F(ResultChecksTest, ARefusalIsTheWorkersFaultAndNothingElseIs) {
  Run([&](const Exchange& e) {
    EXPECT_TRUE(absl::IsDataLoss(check_(e.stage, e.input, "\xff\xff")));
    if (e.stage != Stage::kSurvey) return;
    v1::SurveyInput input;
    ASSERT_TRUE(input.ParseFromString(e.input));
    input.mutable_tile()->set_path("gone.ply");
    EXPECT_TRUE(absl::IsUnavailable(check_(e.stage, input.SerializeAsString(), e.output)));
  });
}

}  // namespace
}  // namespace tilemend
