// Workers that are broken, or lie: they are named, and a job never ends as done with a wrong tile.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <filesystem>
#include <functional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "absl/time/clock.h"
#include "common/rpc/stage_payloads.h"
#include "common/store/digest.h"
#include "common/store/file_stamp.h"
#include "common/util/files.h"
#include "tests/integration/worker_lies.h"
#include "tests/support/untrusted_workers.h"
#include "tilemend/v1/stages.pb.h"
#include "worker/service/look_at_folders.h"

namespace tilemend {
namespace {

using ::testing::HasSubstr;

// The patches of a fill, decoded, changed and encoded.
Lie LieInPatches(const char* name, const std::function<bool(std::vector<HolePatch>&)>& change) {
  return LieOf<v1::FillInput, v1::FillOutput>(
      name, Stage::kFill, [=](const v1::FillInput& input, v1::FillOutput& output) {
        const auto holes = FromProto(input.holes());
        auto patches = FromProto(output, holes->vertices.size());
        EXPECT_TRUE(patches.ok()) << patches.status();
        if (patches->empty() || patches->front().triangles.empty() || !change(*patches)) return false;
        const v1::QualityTally quality = output.quality();
        output = ToProto(*patches, holes->vertices, holes->lattice_step);
        *output.mutable_quality() = quality;
        return true;
      });
}

using Patches = std::vector<HolePatch>;

std::vector<Lie> SurveyLies() {
  const auto lie = [](const char* name, std::function<bool(Survey&)> change) {
    return LieIn<Survey>(name, Stage::kSurvey, std::move(change));
  };
  return {
      lie("SaysThereIsNoBoundary",
          [](Survey& s) {
            s.mutable_vertices()->Clear(), s.clear_edges(), s.clear_pieces(), s.mutable_band()->Clear();
            *s.mutable_band() = ToProto(SurveyRecord()).band();
            return true;
          }),
      lie("LeavesOutAnEdge",
          [](Survey& s) {
            return s.mutable_edges()->Truncate(s.edges_size() - 2), s.mutable_pieces()->RemoveLast(), true;
          }),
      lie("TurnsAnEdge", [](Survey& s) { return s.mutable_edges()->SwapElements(0, 1), true; }),
      lie("SaysAnEdgeTwice",
          [](Survey& s) { return s.add_edges(s.edges(0)), s.add_edges(s.edges(1)), s.add_pieces(0), true; }),
      lie("HasTwoBillionVertices", [](Survey& s) { return s.set_vertex_count(0x7fffffff), true; }),
      lie("HasNoTriangles", [](Survey& s) { return s.set_triangle_count(0), true; }),
      lie("HasFewerThanNone", [](Survey& s) { return s.set_doubled_vertices(-1), true; }),
      lie("MovesAVertexAway", [](Survey& s) { return s.mutable_vertices()->set_position(0, 1e9), true; }),
      lie("HasANormalThatIsNoNumber",
          [](Survey& s) { return s.mutable_vertices()->set_normal(2, std::nanf("")), true; }),
      lie("HasAHugeNormal", [](Survey& s) { return s.mutable_vertices()->set_normal(2, 1e30F), true; }),
      lie("HasAHeightThatIsNoNumber",
          [](Survey& s) { return s.mutable_vertices()->set_centroid_height(0, std::nan("")), true; }),
      lie("NumbersPiecesAtWill", [](Survey& s) { return s.set_pieces(0, 1 << 30), true; }),
      lie("NamesAVertexTwice",
          [](Survey& s) { return s.mutable_vertices()->set_index(1, s.vertices().index(0)), true; }),
      lie("LiesElsewhere",
          [](Survey& s) { return s.set_bounds(0, s.bounds(0) - 1e6), s.set_bounds(3, s.bounds(3) + 1e6), true; }),
      lie("HasBoundsThatAreNone", [](Survey& s) { return s.set_bounds(0, s.bounds(3) + 1), true; }),
      lie("HasNoDigest", [](Survey& s) { return s.set_digest("none"), true; }),
      {"IsGarbage", Stage::kSurvey, [](const std::string&, std::string& bytes) { return bytes = "\xff\xff", true; }},
      {"IsEmpty", Stage::kSurvey, [](const std::string&, std::string& bytes) { return bytes.clear(), true; }},
  };
}

std::vector<Lie> FileLies() {
  return {
      LieIn<Survey>("LeadsOutOfTheScene", Stage::kSurvey,
                    [](Survey& s) { return s.mutable_files()->add_images("../../etc/passwd"), true; }),
      LieIn<Survey>("NamesManyImages", Stage::kSurvey,
                    [](Survey& s) {
                      for (int i = 0; i < 50000; ++i) s.mutable_files()->add_images("images/" + std::to_string(i));
                      return true;
                    }),
  };
}

std::vector<Lie> SampleLies() {
  const auto lie = [](const char* name, const std::function<bool(v1::SampleClusterOutput&)>& change) {
    return LieIn<v1::SampleClusterOutput>(name, Stage::kSampleCluster,
                                          [=](v1::SampleClusterOutput& s) { return s.height_size() > 0 && change(s); });
  };
  return {
      lie("OfAnotherCluster", [](auto& s) { return s.set_cluster(s.cluster() + 1), true; }),
      lie("FarUp", [](auto& s) { return s.set_height(0, 1e9), true; }),
      lie("NoNumber", [](auto& s) { return s.set_laplacian(0, std::nan("")), true; }),
      lie("OfNoVertex", [](auto& s) { return s.set_seam_vertex(0, 1 << 30), true; }),
      lie("TheSameTwice", [](auto& s) { return s.set_seam_vertex(0, s.seam_vertex(s.seam_vertex_size() - 1)), true; }),
      lie("OneTooFew",
          [](auto& s) {
            s.mutable_seam_vertex()->RemoveLast(), s.mutable_height()->RemoveLast();
            s.mutable_laplacian()->RemoveLast(), s.mutable_slope_x()->RemoveLast(), s.mutable_slope_y()->RemoveLast();
            return s.height_size() > 0;
          }),
      lie("UnequalColumns", [](auto& s) { return s.add_height(0), true; }),
  };
}

std::vector<Lie> FillLies() {
  return {
      LieInPatches("NoPatches", [](Patches& p) { return p.clear(), true; }),
      LieInPatches("NoTriangles", [](Patches& p) { return p[0].triangles.clear(), p[0].new_points.clear(), true; }),
      LieInPatches("OneTriangle300Times",
                   [](Patches& p) { return p[0].triangles.assign(300, Triangle(p[0].triangles[0])), true; }),
      LieInPatches("OneTriangleTwice", [](Patches& p) { return p[0].triangles.push_back(p[0].triangles[0]), true; }),
      LieInPatches("OneTriangleLess", [](Patches& p) { return p[0].triangles.pop_back(), true; }),
      LieInPatches("TurnedOver",
                   [](Patches& p) {
                     for (Triangle& t : p[0].triangles) std::swap(t[0], t[1]);
                     return true;
                   }),
      LieInPatches("OneTurnedOver",
                   [](Patches& p) { return std::swap(p[0].triangles[0][0], p[0].triangles[0][1]), true; }),
      LieInPatches("AFlatTriangle", [](Patches& p) { return p[0].triangles[0][1] = p[0].triangles[0][0], true; }),
      LieInPatches("TheHoleTwice", [](Patches& p) { return p.push_back(p[0]), true; }),
      LieInPatches("AnotherHole", [](Patches& p) { return p[0].hole += 1000, true; }),
      LieInPatches("BothFilledAndNot", [](Patches& p) { return p[0].failure = "no", true; }),
      LieInPatches("FilledInNoWay", [](Patches& p) { return p[0].way = FillWay::kNone, true; }),
      LieInPatches("AnEndlessReason",
                   [](Patches& p) {
                     p[0] = HolePatch{p[0].hole, std::string(1 << 20, 'x')};
                     return true;
                   }),
      LieIn<v1::FillOutput>("BetterThanItIs", Stage::kFill,
                            [](v1::FillOutput& o) { return o.mutable_quality()->set_triangles(1 << 20), true; }),
      LieIn<v1::FillOutput>("CountsOutOfRange", Stage::kFill,
                            [](v1::FillOutput& o) {
                              if (o.patches().empty()) return false;
                              return o.mutable_patches(0)->set_new_points(0x7fffffff), true;
                            }),
      {"GarbagePatches", Stage::kFill, [](const std::string&, std::string& bytes) { return bytes = "\xff\xff", true; }},
  };
}

std::vector<Lie> ShapeLies() {
  return {
      LieInPatches("AVertexFarAway",
                   [](Patches& p) {
                     if (p[0].new_points.empty()) return false;
                     return p[0].new_points[0] = Point3(1e9, 0, 0), true;
                   }),
      LieInPatches("TwoVerticesInOne",
                   [](Patches& p) {
                     if (p[0].new_points.size() < 2) return false;
                     return p[0].new_points[1] = p[0].new_points[0], true;
                   }),
      LieInPatches("FoldedOver",
                   [](Patches& p) {
                     if (p[0].new_points.size() < 6) return false;
                     return std::swap(p[0].new_points[0], p[0].new_points[5]), true;
                   }),
  };
}

std::vector<Lie> TileLies() {
  const auto lie = [](const char* name, std::function<bool(const v1::AssembleInput&, Tile&)> change) {
    return LieOf<v1::AssembleInput, Tile>(name, Stage::kAssemble, std::move(change));
  };
  return {
      {"GarbageTile", Stage::kAssemble,
       [](const std::string&, std::string& bytes) { return bytes = "\xff\xff", true; }},
      {"EmptyTile", Stage::kAssemble, [](const std::string&, std::string& bytes) { return bytes.clear(), true; }},
      lie("NoFiles", [](const auto&, Tile& t) { return t.clear_files(), true; }),
      lie("NotThere", [](const auto& input, Tile& t) { return std::filesystem::remove(WrittenPath(input, t)); }),
      lie("CutOff",
          [](const auto& input, Tile& t) { return std::filesystem::resize_file(WrittenPath(input, t), 10), true; }),
      lie("CutOffAndSaysSo",
          [](const auto& input, Tile& t) {
            std::filesystem::resize_file(WrittenPath(input, t), 10);
            return t.mutable_files(0)->set_bytes(10), true;
          }),
      lie("OneByteOff",
          [](const auto& input, Tile& t) {
            std::string bytes = ReadFile(WrittenPath(input, t)).value();
            bytes.back() = static_cast<char>(bytes.back() ^ 1);
            return WriteFileAtomically(WrittenPath(input, t), bytes).ok();
          }),
      lie("AnotherTilesName",
          [](const auto&, Tile& t) { return t.mutable_files(0)->set_path("tiles/Tile_+000_+001.ply"), true; }),
      lie("OutOfTheFolder", [](const auto&, Tile& t) { return t.mutable_files(0)->set_path("../mine"), true; }),
      lie("FromOutside",
          [](const auto&, Tile& t) { return t.mutable_files(0)->set_attempt("../../scene/scene.json"), true; }),
      lie("AFileMore", [](const auto&, Tile& t) { return *t.add_files() = t.files(0), true; }),
      lie("AnUntouchedTileThatIsAnother",
          [](const auto& input, Tile& t) {
            if (input.has_patches()) return false;
            const std::string other(static_cast<size_t>(t.files(0).bytes()), 'x');
            t.mutable_files(0)->set_digest(FileDigest(other));
            return WriteFileAtomically(WrittenPath(input, t), other).ok();
          }),
  };
}

std::vector<Lie> AllLies() {
  std::vector<Lie> all;
  for (const auto& lies :
       {SurveyLies(), LiesOnTiles(), FileLies(), SampleLies(), FillLies(), ShapeLies(), TileLies()}) {
    all.insert(all.end(), lies.begin(), lies.end());
  }
  return all;
}

// Whatever a worker lies about once, the job ends as if it had not been there.
class LyingWorkerTest : public UntrustedWorkerTest, public ::testing::WithParamInterface<Lie> {
 protected:
  StageRunner Liar(std::atomic<bool>& lied) {
    return [&lied, lie = GetParam(), run = SceneStageRunner()](Stage stage, const std::string& input,
                                                               const CancelToken& cancel) {
      auto result = run(stage, input, cancel);
      if (stage != lie.stage || !result.ok() || lied || !lie.tell(input, *result)) return result;
      lied = true;
      lied.notify_all();
      return result;
    };
  }
};

TEST_P(LyingWorkerTest, IsNamedAndSetAsideAndTheJobEndsAsIfItHadNotBeen) {
  const auto undisturbed = Undisturbed();
  std::atomic<bool> lied{false};
  cluster_.AddWorker("liar", 1, Liar(lied));
  const v1::Job submitted = cluster_.Submit(scene_);
  lied.wait(false);
  cluster_.AddWorker("good", 2, SceneStageRunner());
  const v1::Job job = cluster_.WaitFor(submitted.name());
  ASSERT_EQ(job.state(), v1::DONE) << job.error().message();
  EXPECT_EQ(TilesBelow(Out(job)), undisturbed);
  ASSERT_EQ(job.warnings_size(), 1);
  EXPECT_THAT(job.warnings(0), HasSubstr("the result of worker liar for cell"));
  EXPECT_EQ(cluster_.Metric("tilemend_coordinator_workers_set_aside"), 1);
  EXPECT_EQ(cluster_.Metric("tilemend_coordinator_results_refused_total{stage=\"" +
                            std::string(StageName(GetParam().stage)) + "\"}"),
            1);
}

INSTANTIATE_TEST_SUITE_P(Lies, LyingWorkerTest, ::testing::ValuesIn(AllLies()),
                         [](const auto& lie) { return lie.param.name; });

// Where all come to the same, the fault is in the program or the cell.
using UntrustedResultTest = UntrustedWorkerTest;

TEST_F(UntrustedResultTest, AResultThatTwoWorkersGiveIsLeftAndNobodyIsSetAside) {
  const Lie lie = LieInPatches("", [](Patches& p) { return p[0].triangles.pop_back(), true; });
  for (const char* name : {"one", "other"}) {
    cluster_.AddWorker(name, 1,
                       [=, run = SceneStageRunner()](Stage stage, const std::string& input, const auto& cancel) {
                         auto result = run(stage, input, cancel);
                         v1::FillInput fill;
                         if (stage == Stage::kFill && fill.ParseFromString(input) && fill.holes().col() == 1 &&
                             fill.holes().row() == 0) {
                           lie.tell(input, *result);
                         }
                         return result;
                       });
  }
  const v1::Job job = cluster_.WaitFor(cluster_.Submit(scene_).name());
  EXPECT_EQ(job.state(), v1::PARTIAL) << job.error().message();
  EXPECT_EQ(cluster_.Metric("tilemend_coordinator_workers_set_aside"), 0);
  const auto report = ReportOf(Out(job));
  for (const auto& left : report["left"]) EXPECT_EQ(left["cell"], nlohmann::json({1, 0}));
}

// Of one worker, where there is another: its word alone fails no cell and no job.
class FalseErrorTest : public UntrustedWorkerTest, public ::testing::WithParamInterface<Stage> {};

TEST_P(FalseErrorTest, IsTriedByAnotherAndItsWorkerNamed) {
  const auto undisturbed = Undisturbed();
  std::atomic<bool> failed{false};
  cluster_.AddWorker("good", 1,
                     [&, run = SceneStageRunner()](Stage stage, const std::string& input, const auto& cancel) {
                       if (stage == GetParam()) failed.wait(false);
                       return run(stage, input, cancel);
                     });
  cluster_.AddWorker("broken", 1,
                     [&, run = SceneStageRunner()](Stage stage, const std::string& input,
                                                   const auto& cancel) -> absl::StatusOr<std::string> {
                       if (stage != GetParam()) return run(stage, input, cancel);
                       failed = true;
                       failed.notify_all();
                       return absl::InvalidArgumentError("line 1: expected 'ply'");
                     });
  const v1::Job job = cluster_.WaitFor(cluster_.Submit(scene_).name());
  ASSERT_EQ(job.state(), v1::DONE) << job.error().message();
  EXPECT_EQ(TilesBelow(Out(job)), undisturbed);
  ASSERT_GE(job.warnings_size(), 1);
  EXPECT_THAT(job.warnings(0), HasSubstr("worker broken could not do cell"));
  EXPECT_THAT(job.warnings(0), HasSubstr("which worker good did: line 1: expected 'ply'"));
}

// It was quicker than the good one had looked at the folders.
TEST_F(UntrustedWorkerTest, AnErrorOfTheFirstWorkerThatLookedIsTriedByAnother) {
  std::atomic<bool> looks{false}, failed{false};
  WorkerOptions good;
  good.id = "good";
  good.look = [&](const v1::JobFolders& folders) {
    looks = true;
    looks.notify_all();
    failed.wait(false);
    return LookAtFolders(folders);
  };
  cluster_.AddWorker(good, SceneStageRunner());
  cluster_.AddWorker("broken", 1, [&](Stage, const std::string&, const auto&) -> absl::StatusOr<std::string> {
    looks.wait(false);
    failed = true;
    failed.notify_all();
    return absl::InvalidArgumentError("line 1: expected 'ply'");
  });
  const v1::Job job = cluster_.WaitFor(cluster_.Submit(scene_).name());
  EXPECT_EQ(job.state(), v1::DONE) << job.error().message();
}

INSTANTIATE_TEST_SUITE_P(Stages, FalseErrorTest, ::testing::Values(Stage::kSurvey, Stage::kFill, Stage::kAssemble),
                         [](const auto& stage) { return std::string(StageName(stage.param)); });

// A tile that was not changed since it was read has the digest that is told of it.
TEST_F(UntrustedResultTest, ADigestOfAnotherTileIsALie) {
  const std::string tile = scene_ + "/tiles/Tile_+000_+000.ply";
  while (StampOf(tile, absl::Now()).empty()) std::this_thread::yield();  // it was just written
  std::atomic<bool> lied{false};
  cluster_.AddWorker("liar", 1,
                     [&, run = SceneStageRunner()](Stage stage, const std::string& input, const auto& cancel) {
                       auto result = run(stage, input, cancel);
                       Survey survey;
                       if (stage != Stage::kSurvey || lied || !survey.ParseFromString(*result)) return result;
                       survey.set_digest(FileDigest("another"));
                       survey.mutable_witness()->set_digest(survey.digest());
                       *result = survey.SerializeAsString();
                       lied = true;
                       lied.notify_all();
                       return result;
                     });
  const v1::Job submitted = cluster_.Submit(scene_);
  lied.wait(false);
  cluster_.AddWorker("good", 2, SceneStageRunner());
  const v1::Job job = cluster_.WaitFor(submitted.name());
  EXPECT_EQ(job.state(), v1::DONE) << job.error().message();
  ASSERT_EQ(job.warnings_size(), 1);
  EXPECT_THAT(job.warnings(0), HasSubstr("a digest that is not the tile's"));
}

// Nobody does a stage of the first job right, and each is wrong in a way of its own.
class BadJobTest : public UntrustedWorkerTest {
 protected:
  BadJobTest() : UntrustedWorkerTest(Impatient()) {}
  static ClusterOptions Impatient() {
    ClusterOptions options = Options();
    options.state.wait_for_another = absl::Milliseconds(300);
    return options;
  }
  void AddWorker(const std::string& name, Stage bad) {
    cluster_.AddWorker(name, 2,
                       [=, this, run = SceneStageRunner()](Stage stage, const std::string& input, const auto& cancel) {
                         if (stage == bad && is_bad_) return absl::StatusOr<std::string>(absl::StrCat("\xff", name));
                         return run(stage, input, cancel);
                       });
  }
  // The first job and, when it is over, another that has nothing wrong.
  v1::Job RunBadThenGood() {
    v1::Job bad = cluster_.WaitFor(cluster_.Submit(scene_).name());
    is_bad_ = false;
    const v1::Job good = cluster_.WaitFor(cluster_.Submit(scene_).name());
    EXPECT_EQ(good.state(), v1::DONE) << good.error().message();
    EXPECT_EQ(cluster_.Metric("tilemend_coordinator_workers_set_aside"), 0);
    return bad;
  }

  std::atomic<bool> is_bad_{true};
};

TEST_F(BadJobTest, LeavesItsCellsAndAllWorkersToOthers) {
  for (const char* name : {"one", "two", "three"}) AddWorker(name, Stage::kFill);
  const v1::Job bad = RunBadThenGood();
  EXPECT_EQ(bad.state(), v1::PARTIAL) << bad.error().message();
  const auto left = ReportOf(Out(bad))["left"];
  ASSERT_FALSE(left.empty());
  for (const char* name : {"worker one", "worker two", "worker three"}) {
    EXPECT_THAT(left[0]["reason"].get<std::string>(), HasSubstr(name));
  }
}

TEST_F(BadJobTest, OfTheOnlyWorkerEndsAsWell) {
  AddWorker("one", Stage::kFill);
  EXPECT_EQ(RunBadThenGood().state(), v1::PARTIAL);
}

TEST_F(BadJobTest, WithoutASurveyFailsAndNamesTheWorkers) {
  for (const char* name : {"one", "two"}) AddWorker(name, Stage::kSurvey);
  const v1::Job bad = RunBadThenGood();
  EXPECT_EQ(bad.state(), v1::FAILED);
  EXPECT_THAT(bad.error().message(), HasSubstr("worker one"));
  EXPECT_THAT(bad.error().message(), HasSubstr("worker two"));
  EXPECT_THAT(bad.error().message(), HasSubstr("there is no other worker"));
}

}  // namespace
}  // namespace tilemend
