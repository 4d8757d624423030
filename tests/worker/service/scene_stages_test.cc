#include "worker/service/scene_stages.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "absl/time/clock.h"
#include "common/codec/mesh_file.h"
#include "common/rpc/look_payloads.h"
#include "common/rpc/stage_payloads.h"
#include "common/store/digest.h"
#include "common/store/file_stamp.h"
#include "common/util/error_info.h"
#include "tests/support/mesh_builders.h"
#include "tests/support/patch_checks.h"
#include "tests/support/temporary_folder.h"
#include "tilemend/v1/stages.pb.h"
#include "worker/fill/seam/sample_cluster.h"

namespace tilemend {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

// A roof with a hole of one square in its middle.
TriMesh HoledRoof() {
  const auto keep = [](int32_t i, int32_t j) { return i != 2 || j != 2; };
  return SquaresMesh(0, 5, 0, 5, keep, [](double x, double y) { return 0.25 * x + 0.125 * y; });
}

CellHoles HoleOf(const TriMesh& mesh) {
  const auto inside = [](const Point3& p) { return p.x() > 0.5 && p.x() < 4.5 && p.y() > 0.5 && p.y() < 4.5; };
  CellHoles work = WorkOf(mesh, false, [&](const Point3& a, const Point3& b) { return inside(a) && inside(b); });
  work.lattice_step = 0x1p-10;
  return work;
}

// An open hole in a level surface; two of its six vertices lie on a seam, and their heights are open.
CellHoles HoleWithSeam() {
  CellHoles cell;
  cell.lattice_step = 0x1p-10;
  const auto add = [&](double x, double y, bool seam) {
    RimVertex v;
    v.index = seam ? -1 : static_cast<int32_t>(cell.vertices.size());
    v.seam_vertex = seam ? 70 + static_cast<int32_t>(cell.vertices.size()) : -1;
    v.lines = seam ? 2 : 0;
    v.position = {x, y, 5};
    v.centroid_height = 5;
    v.height_known = !seam;
    v.size = 1;
    cell.vertices.push_back(v);
    cell.band.points.push_back(v.position);
  };
  add(0, 0, false), add(1, 0, true), add(2, 0, true), add(3, 0, false), add(2, 2, false), add(1, 2, false);
  cell.vertices[0].seam_vertex = 90;
  cell.vertices[3].seam_vertex = 91;
  cell.holes.push_back({0, true, {{0, 1, true}, {1, 2, true}, {2, 3, true}, {3, 4}, {4, 5}, {5, 0}}});
  cell.band.points.emplace_back(4, 3, 5);
  cell.band.triangles = {{4, 3, 6}, {5, 4, 6}};
  return cell;
}

// A hole of 6 m by 4 m in a bent surface, in two parts west and east of a seam at x = 3, whose inner vertices are 20 to
// 22; it ends at the rim's vertices 3 and 13.
CellHoles BentCluster() {
  CellHoles work;
  work.lattice_step = 0x1p-10;
  const auto add = [&](double x, double y, bool seam) {
    RimVertex v;
    const auto number = static_cast<int32_t>(work.vertices.size());
    v.index = seam ? -1 : number;
    v.seam_vertex = seam || number == 3 || number == 13 ? number : -1;
    v.position = {x, y, x * x / 16 + y / 4};
    v.centroid_height = v.position.z();
    v.height_known = !seam;
    v.size = 1;
    work.vertices.push_back(v);
    work.band.points.push_back(v.position);
  };
  for (int x = 0; x < 6; ++x) add(x, 0, false);
  for (int y = 0; y < 4; ++y) add(6, y, false);
  for (int x = 6; x > 0; --x) add(x, 4, false);
  for (int y = 4; y > 0; --y) add(0, y, false);
  for (int y = 1; y < 4; ++y) add(3, y, true);
  for (int32_t v = 0; v < 20; ++v) {  // the surface around it
    const Point3& p = work.vertices[v].position;
    const double x = p.x() + (p.x() - 3) / 4, y = p.y() + (p.y() - 2) / 4;
    work.band.points.emplace_back(x, y, x * x / 16 + y / 4);
    const int32_t next = (v + 1) % 20, outer = 23 + v, outer_next = 23 + next;
    work.band.triangles.push_back({next, v, outer});
    work.band.triangles.push_back({next, outer, outer_next});
  }
  const auto part = [](int32_t id, int32_t from, const std::vector<int32_t>& way_back) {
    CellHole hole{id, true, {}};
    for (int32_t v = from; v < from + 10; ++v) hole.segments.push_back({v % 20, (v + 1) % 20, false});
    for (size_t k = 1; k < way_back.size(); ++k) hole.segments.push_back({way_back[k - 1], way_back[k], true});
    return hole;
  };
  work.holes = {part(0, 3, {13, 22, 21, 20, 3}), part(1, 13, {3, 20, 21, 22, 13})};
  return work;
}

class SceneStagesTest : public testing::Test {
 protected:
  template <typename Input>
  absl::StatusOr<std::string> Run(Stage stage, const Input& input) {
    return runner_(stage, input.SerializeAsString(), cancel_);
  }

  template <typename Output, typename Input>
  Output RunWell(Stage stage, const Input& input) {
    const absl::StatusOr<std::string> bytes = Run(stage, input);
    EXPECT_TRUE(bytes.ok()) << bytes.status();
    Output output;
    EXPECT_TRUE(output.ParseFromString(bytes.value_or("")));
    return output;
  }

  std::string TileOf(const v1::AssembleOutput& output) {
    return output.files_size() == 1 ? ReadFile(folder_ / output.files(0).attempt()).value() : "";
  }

  int FilesInFolder() const {
    const std::filesystem::directory_iterator all(folder_.path());
    return static_cast<int>(std::distance(begin(all), end(all)));
  }

  // A tile of the mesh in the folder.
  v1::TileRef WriteTile(const TriMesh& mesh, const std::string& name) {
    const std::vector<int32_t> like(mesh.points.size(), -1);
    const std::string bytes = NewPlyFile({mesh.points, like, mesh.triangles}, NumberType::kFloat64);
    folder_.Write(name, bytes);
    v1::TileRef tile;
    tile.set_root(folder_.path());
    tile.set_path(name);
    tile.set_digest(FileDigest(bytes));
    return tile;
  }

  v1::FillInput FillInputOf(const CellHoles& work) {
    v1::FillInput input;
    *input.mutable_holes() = ToProto(work);
    input.mutable_options()->set_gradation(1.5);
    input.mutable_options()->set_size_limit(10);
    return input;
  }

  v1::AssembleInput AssembleInputOf(const TriMesh& mesh, const v1::TileRef& tile) {
    const CellHoles work = HoleOf(mesh);
    v1::AssembleInput input;
    *input.mutable_tile() = tile;
    input.set_output("out/a.ply");
    input.set_attempts(folder_.path());
    input.set_output_root(folder_ / "output");
    input.set_tile_vertices(static_cast<int64_t>(mesh.points.size()));
    *input.mutable_vertices() = ToProto(work.vertices);
    *input.mutable_patches() = RunWell<v1::FillOutput>(Stage::kFill, FillInputOf(work));
    FillColours colours;
    for (const v1::PatchExtent& patch : input.patches().patches()) {
      colours.of_holes[patch.hole()] = {patch.hole(), {60, 70, 80}, true};
    }
    SetColours(colours, input);
    return input;
  }

  TemporaryFolder folder_;
  CancelToken cancel_;
  const StageRunner runner_ = SceneStageRunner();
};

TEST_F(SceneStagesTest, SurveysATile) {
  const v1::TileRef tile = WriteTile(HoledRoof(), "a.ply");
  v1::SurveyInput input;
  *input.mutable_tile() = tile;
  const auto output = RunWell<v1::SurveyOutput>(Stage::kSurvey, input);
  EXPECT_EQ(output.digest(), tile.digest());
  EXPECT_FALSE(output.float32());
  const auto record = FromProto(output);
  ASSERT_TRUE(record.ok()) << record.status();
  EXPECT_EQ(record->triangle_count, 48);
  EXPECT_EQ(record->edges.size(), 20u + 4u);  // around the roof and around the hole
}

TEST_F(SceneStagesTest, SaysWhichTileCannotBeSurveyed) {
  v1::SurveyInput input;
  input.mutable_tile()->set_root(folder_.path());
  const auto status = [&](const std::string& name) {
    input.mutable_tile()->set_path(name);
    return Run(Stage::kSurvey, input).status();
  };
  EXPECT_EQ(status("none.ply").code(), absl::StatusCode::kNotFound);
  EXPECT_THAT(std::string(status("none.ply").message()), HasSubstr(folder_ / "none.ply"));
  folder_.Write("a.stl", "solid");
  EXPECT_EQ(status("a.stl").code(), absl::StatusCode::kInvalidArgument);
  folder_.Write("bad.ply", "ply\n");
  EXPECT_THAT(std::string(status("bad.ply").message()), HasSubstr("bad.ply: "));
}

TEST_F(SceneStagesTest, ATaskAloneRunsHoweverLittleMemoryItMayTake) {
  const StageRunner thrifty = SceneStageRunner(1);
  v1::SurveyInput survey;
  *survey.mutable_tile() = WriteTile(HoledRoof(), "a.ply");
  v1::FillInput fill = FillInputOf(HoleOf(HoledRoof()));
  for (const auto& [stage, input] :
       {std::pair(Stage::kSurvey, survey.SerializeAsString()), {Stage::kFill, fill.SerializeAsString()}}) {
    const auto output = thrifty(stage, input, cancel_);
    ASSERT_TRUE(output.ok()) << output.status();
    EXPECT_EQ(*output, *runner_(stage, input, cancel_));
  }
}

TEST_F(SceneStagesTest, FillsAHoleSoundly) {
  for (const bool thin_plate : {false, true}) {
    const CellHoles work = HoleOf(HoledRoof());
    v1::FillInput input = FillInputOf(work);
    input.mutable_options()->set_surface(thin_plate ? "thin-plate" : "wang");
    const auto output = RunWell<v1::FillOutput>(Stage::kFill, input);
    const auto patches = FromProto(output, work.vertices.size());
    ASSERT_TRUE(patches.ok()) << patches.status();
    ASSERT_EQ(patches->size(), 1u);
    ExpectClosesHole(work, work.holes[0], patches->front());
    EXPECT_EQ(output.quality().triangles(), static_cast<int64_t>(patches->front().triangles.size()));
  }
}

TEST_F(SceneStagesTest, RefusesOptionsOfWangOutOfRange) {
  for (const auto& [loop, steps] : {std::pair(0, 10), {2, 10}, {2001, 10}, {400, -1}, {400, 1001}}) {
    v1::FillInput input = FillInputOf(HoleOf(HoledRoof()));
    input.mutable_options()->set_surface("wang");
    input.mutable_options()->set_longest_loop(loop);
    input.mutable_options()->set_fairing_steps(steps);
    input.mutable_options()->set_closure("buffers");
    const auto ended = runner_(Stage::kFill, input.SerializeAsString(), cancel_);
    EXPECT_EQ(ended.status().code(), absl::StatusCode::kInvalidArgument) << loop << " " << steps;
  }
}

TEST_F(SceneStagesTest, RefusesAClosureThatItDoesNotKnow) {
  for (const char* closure : {"", "else"}) {
    v1::FillInput input = FillInputOf(HoleOf(HoledRoof()));
    input.mutable_options()->set_surface("wang");
    input.mutable_options()->set_longest_loop(400);
    input.mutable_options()->set_closure(closure);
    EXPECT_EQ(runner_(Stage::kFill, input.SerializeAsString(), cancel_).status().code(),
              absl::StatusCode::kInvalidArgument);
  }
}

TEST_F(SceneStagesTest, SamplesAHoleWithoutSeamsToNothing) {
  v1::SampleLayerInput layer;
  *layer.mutable_holes() = ToProto(HoleOf(HoledRoof()));
  EXPECT_THAT(RunWell<v1::SampleLayerOutput>(Stage::kSampleLayer, layer).seam_vertex(), IsEmpty());
  v1::SampleClusterInput cluster;
  *cluster.mutable_holes() = layer.holes();
  *cluster.mutable_options() = FillInputOf(HoleOf(HoledRoof())).options();
  cluster.set_cluster(7);
  const auto output = RunWell<v1::SampleClusterOutput>(Stage::kSampleCluster, cluster);
  EXPECT_EQ(output.cluster(), 7);
  EXPECT_THAT(output.seam_vertex(), IsEmpty());
}

TEST_F(SceneStagesTest, SamplesHeightAndLaplacianOfAClusterAtEveryVertexOnASeam) {
  v1::SampleClusterInput input;
  *input.mutable_holes() = ToProto(HoleWithSeam());
  *input.mutable_options() = FillInputOf(HoleWithSeam()).options();
  const auto output = RunWell<v1::SampleClusterOutput>(Stage::kSampleCluster, input);
  EXPECT_THAT(output.seam_vertex(), UnorderedElementsAre(71, 72, 90, 91));
  ASSERT_EQ(output.height_size(), 4);
  ASSERT_EQ(output.laplacian_size(), 4);
  for (const double height : output.height()) EXPECT_NEAR(height, 5, 1e-6) << "the rim is level";
  EXPECT_TRUE(output.has_hold_out()) << "the tension was open";
}

TEST_F(SceneStagesTest, HandsOutTheSamplesOfACluster) {
  const CellHoles work = BentCluster();
  v1::SampleClusterInput input;
  *input.mutable_holes() = ToProto(work);
  *input.mutable_options() = FillInputOf(work).options();
  input.mutable_options()->set_tension(0);
  const auto output = RunWell<v1::SampleClusterOutput>(Stage::kSampleCluster, input);
  FillOptions options;
  options.tension = 0;
  options.refine.gradation = 1.5;
  options.refine.size_limit = 10;
  options.surface = Surface::kThinPlate;
  const auto surface = SampleCluster(work, options);
  ASSERT_TRUE(surface.has_value());
  ASSERT_EQ(surface->samples.size(), 5u);
  ASSERT_EQ(output.seam_vertex_size(), 5);
  ASSERT_EQ(output.height_size(), 5);
  ASSERT_EQ(output.laplacian_size(), 5);
  double most = 0;
  for (int i = 0; i < 5; ++i) {
    const SurfaceSample& sample = surface->samples[i];
    EXPECT_EQ(output.seam_vertex(i), sample.seam_vertex);
    EXPECT_EQ(output.height(i), sample.height);
    EXPECT_EQ(output.laplacian(i), sample.laplacian);
    most = std::max(most, std::abs(sample.laplacian));
  }
  EXPECT_GT(most, 0.01) << "the surface is bent";
}

TEST_F(SceneStagesTest, SamplesAHeightInALayerForEverySeamVertexThatHasNone) {
  v1::SampleLayerInput input;
  *input.mutable_holes() = ToProto(HoleWithSeam());
  const auto output = RunWell<v1::SampleLayerOutput>(Stage::kSampleLayer, input);
  EXPECT_THAT(output.seam_vertex(), UnorderedElementsAre(71, 72));
  ASSERT_EQ(output.height_size(), 2);
  for (const double height : output.height()) EXPECT_NEAR(height, 5, 1e-9);
}

TEST_F(SceneStagesTest, AssemblesTheTileWithItsPatches) {
  const TriMesh mesh = HoledRoof();
  const v1::AssembleInput input = AssembleInputOf(mesh, WriteTile(mesh, "a.ply"));
  const auto output = RunWell<v1::AssembleOutput>(Stage::kAssemble, input);
  const std::string written = TileOf(output);
  EXPECT_EQ(output.files(0).path(), "out/a.ply");
  EXPECT_EQ(output.files(0).bytes(), static_cast<int64_t>(written.size()));
  EXPECT_EQ(output.files(0).digest(), FileDigest(written));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out/a.ply")) << "only the coordinator gives it its name";
  const auto file = ParseMesh(MeshFormat::kPly, written, "a.ply");
  ASSERT_TRUE(file.ok()) << file.status();
  EXPECT_TRUE(std::equal(mesh.triangles.begin(), mesh.triangles.end(), file->mesh.triangles.begin()));
  EXPECT_GE(file->mesh.triangles.size(), mesh.triangles.size() + 2);
}

TEST_F(SceneStagesTest, CopiesATileWithoutPatchesByteForByte) {
  v1::AssembleInput input;
  *input.mutable_tile() = WriteTile(HoledRoof(), "a.ply");
  input.set_output("out/a.ply");
  input.set_attempts(folder_.path());
  const auto output = RunWell<v1::AssembleOutput>(Stage::kAssemble, input);
  EXPECT_EQ(TileOf(output), ReadFile(folder_ / "a.ply").value());
  EXPECT_EQ(output.files(0).digest(), input.tile().digest());
}

class KnownTileTest : public SceneStagesTest {
 protected:
  KnownTileTest() {
    *input_.mutable_tile() = WriteTile(HoledRoof(), "a.ply");
    input_.set_output("out/a.ply");
    input_.set_attempts(folder_.path());
    input_.set_stamp(StampOf(folder_ / "a.ply", absl::Now() + absl::Hours(1)));
  }
  std::string Assembled() {
    const auto output = RunWell<v1::AssembleOutput>(Stage::kAssemble, input_);
    EXPECT_EQ(output.files(0).digest(), input_.tile().digest());
    EXPECT_EQ(TileOf(output), ReadFile(folder_ / "a.ply").value());
    return folder_ / output.files(0).attempt();
  }
  v1::AssembleInput input_;
};

TEST_F(KnownTileTest, IsCopiedWithoutBeingRead) { EXPECT_EQ(std::filesystem::hard_link_count(Assembled()), 1U); }

TEST_F(KnownTileTest, IsLinkedIfAskedFor) {
  input_.set_link_tile(true);
  EXPECT_TRUE(std::filesystem::equivalent(Assembled(), folder_ / "a.ply"));
}

TEST_F(KnownTileTest, IsReadWhereItsStampIsAnotherOrThereIsNone) {
  for (const char* stamp : {"", "1 2 3 4"}) {
    input_.set_stamp(stamp);
    Assembled();
    folder_.Write("a.ply", "another");
    EXPECT_TRUE(absl::IsAborted(Run(Stage::kAssemble, input_).status())) << stamp;
    *input_.mutable_tile() = WriteTile(HoledRoof(), "a.ply");
  }
}

TEST_F(KnownTileTest, IsPatchedWithoutBeingHashed) {
  const TriMesh mesh = HoledRoof();
  v1::AssembleInput input = AssembleInputOf(mesh, input_.tile());
  const std::string tile = TileOf(RunWell<v1::AssembleOutput>(Stage::kAssemble, input));
  input.set_stamp(input_.stamp());
  input.mutable_tile()->set_digest(FileDigest("never looked at"));
  EXPECT_EQ(TileOf(RunWell<v1::AssembleOutput>(Stage::kAssemble, input)), tile);
}

TEST_F(SceneStagesTest, MakesATileWhereThereWasNone) {
  v1::AssembleInput input;
  input.set_output("out/new.ply");
  input.set_attempts(folder_.path());
  input.set_float32(true);
  EXPECT_THAT(TileOf(RunWell<v1::AssembleOutput>(Stage::kAssemble, input)), HasSubstr("property float x"));
}

TEST_F(SceneStagesTest, WritesNothingWhenTheTileHasChangedOrTheTaskIsCancelled) {
  const TriMesh mesh = HoledRoof();
  v1::AssembleInput input = AssembleInputOf(mesh, WriteTile(mesh, "a.ply"));
  cancel_.Cancel();
  EXPECT_EQ(Run(Stage::kAssemble, input).status().code(), absl::StatusCode::kCancelled);
  input.mutable_tile()->set_digest(FileDigest("another"));
  const absl::Status changed = Run(Stage::kAssemble, input).status();
  EXPECT_EQ(changed.code(), absl::StatusCode::kAborted);
  EXPECT_THAT(std::string(changed.message()), HasSubstr("changed while the job ran"));
  EXPECT_EQ(FilesInFolder(), 1) << "the tile";
}

TEST_F(SceneStagesTest, LeavesAMachineThatDoesNotSeeTheOutputToAnother) {
  const TriMesh mesh = HoledRoof();
  v1::AssembleInput input = AssembleInputOf(mesh, WriteTile(mesh, "a.ply"));
  input.set_attempts(folder_ / "gone");
  const absl::Status status = Run(Stage::kAssemble, input).status();
  EXPECT_TRUE(absl::IsUnavailable(status)) << status;
  EXPECT_EQ(ErrorReason(status), "FOLDER_NOT_SEEN");
  EXPECT_FALSE(std::filesystem::exists(folder_ / "gone")) << "no folder is made";
}

TEST_F(SceneStagesTest, RefusesARimVertexThatTheTileDoesNotHave) {
  const TriMesh mesh = HoledRoof();
  v1::AssembleInput input = AssembleInputOf(mesh, WriteTile(mesh, "a.ply"));
  input.set_tile_vertices(3);
  EXPECT_THAT(std::string(Run(Stage::kAssemble, input).status().message()), HasSubstr("a rim vertex that the tile"));
}

TEST_F(SceneStagesTest, RefusesWhatIsNoPayload) {
  for (const Stage stage : kAllStages) {
    const absl::Status status = runner_(stage, "\xff\xff", cancel_).status();
    EXPECT_EQ(status.code(), absl::StatusCode::kInvalidArgument) << StageName(stage);
    EXPECT_THAT(std::string(status.message()), HasSubstr("malformed payload"));
  }
  EXPECT_EQ(runner_(static_cast<Stage>(99), "", cancel_).status(), absl::InvalidArgumentError("unknown stage"));
}

}  // namespace
}  // namespace tilemend
