#include "coordinator/service/scene_pipeline.h"

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>
#include <variant>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"
#include "absl/time/clock.h"
#include "common/gis/area_file.h"
#include "common/rpc/look_payloads.h"
#include "common/rpc/stage_payloads.h"
#include "common/util/error_info.h"
#include "common/util/files.h"
#include "common/util/status_macros.h"
#include "common/util/stopwatch.h"
#include "common/util/utc.h"
#include "coordinator/report/area_choice.h"
#include "coordinator/report/scene_geojson.h"
#include "coordinator/report/scene_report.h"
#include "coordinator/report/tile_checks.h"
#include "coordinator/report/water_choice.h"
#include "coordinator/service/output_folder.h"
#include "coordinator/service/scene_files.h"
#include "coordinator/service/scene_folders.h"
#include "coordinator/service/scene_options.h"
#include "coordinator/service/scratch_file.h"
#include "coordinator/service/stage_results.h"
#include "coordinator/waves/scene_waves.h"
#include "tilemend/v1/stages.pb.h"

namespace tilemend {
namespace {

// What is given out at once. More follows with each result; each input is in memory until it is given out.
constexpr size_t kEnoughTasks = 256;
constexpr size_t kEnoughBytes = 16 << 20;

template <typename Message>
absl::StatusOr<Message> Parse(const std::string& bytes) {
  Message message;
  if (!message.ParseFromString(bytes)) return absl::InvalidArgumentError("not the expected message");
  return message;
}

absl::Status Unreadable(CellId cell, const absl::Status& status) {
  return absl::InternalError(
      absl::StrCat("a worker's result for cell ", ToString(cell), " cannot be read: ", status.message()));
}

absl::Status PlaceFiles(const v1::AssembleOutput& written, OutputFolder& output) {
  for (const v1::WrittenFile& file : written.files()) {
    TILEMEND_RETURN_IF_ERROR(output.Place({file.attempt(), file.path(), file.bytes()}));
  }
  return absl::OkStatus();
}

// What says where a folder of photogrammetry tiles lies.
absl::Status CarryMetadata(const Scene& scene, OutputFolder& output) {
  constexpr char kMetadata[] = "metadata.xml";
  const std::string from = absl::StrCat(scene.root, "/", kMetadata);
  std::error_code error;
  if (!std::filesystem::is_regular_file(from, error)) return absl::OkStatus();
  output.Adopt({kMetadata});
  return CarryFile(from, absl::StrCat(output.path(), "/", kMetadata), Carry::kCopy);
}

// Drives the waves of a scene with tasks: encodes work, decodes results, keeps the patches as they come, and owns the
// output.
class ScenePipeline : public JobPipeline {
 public:
  ScenePipeline(JobSpec spec, Scene scene, WaterOptions water, std::optional<OutputFolder> output,
                std::shared_ptr<ScratchFile> scratch)
      : spec_(std::move(spec)),
        scratch_(std::move(scratch)),
        shape_(ShapeOptionsOf(spec_)),
        output_(std::move(output)),
        files_(output_ ? FolderInScene(output_->path(), scene.root) : ""),
        waves_(std::move(scene), WaveOptionsOf(spec_, std::move(water), [this] { return is_cancelled(); }),
               [this](std::string_view step) { seconds_.emplace_back(step, watch_.Lap()); }) {}

  absl::StatusOr<JobFolders> Folders() const override {
    return FoldersOf(waves_.scene(), output_ ? &output_->attempts() : nullptr);
  }

  absl::StatusOr<std::vector<NewTask>> Start() override {
    const std::vector<SceneTile>& tiles = waves_.scene().tiles;
    if (std::all_of(tiles.begin(), tiles.end(), [](const SceneTile& tile) { return tile.path.empty(); }))
      return absl::InvalidArgumentError(absl::StrCat(spec_.scene, ": no cell of the scene has a tile"));
    return NextTasks();
  }

  absl::StatusOr<std::vector<NewTask>> OnTaskDone(TaskResult result) override {
    TILEMEND_RETURN_IF_ERROR(result.output.ok() ? Take(result) : Leave(result));
    return NextTasks();
  }

  bool Done() const override { return waves_.done(); }

  Progress GetProgress() const override {
    Progress progress;
    progress.phase = waves_.phase();
    progress.cells = static_cast<int64_t>(waves_.scene().tiles.size());
    progress.cells_done = waves_.cells_done();
    progress.holes = static_cast<int64_t>(waves_.plan().holes.size());
    progress.holes_filled = static_cast<int64_t>(waves_.outcome().sizes.size());
    progress.triangles = waves_.outcome().triangles;
    return progress;
  }

  bool Cancel() override { return EndAs(End::kCancelled); }

  void Release() override {
    // Without a report it is not the output that was finished.
    if (output_ && std::filesystem::exists(output_->path() + "/report.json")) output_->Finish();
  }

  absl::StatusOr<JobOutcome> Finish() override {
    const SceneReportInput report = Report();
    JobOutcome outcome;
    const auto left = LeftOf(report);
    const bool holes_left = std::any_of(left.begin(), left.end(), [](const LeftOpen& l) { return l.is_hole; });
    const size_t holes = waves_.plan().holes.size();
    outcome.partial = holes_left && !spec_.dry_run;
    outcome.message = spec_.dry_run ? absl::StrCat(holes, " holes found, nothing written")
                                    : absl::StrCat(report.outcome.sizes.size(), " of ", holes, " holes filled",
                                                   left.empty() ? "" : "; the report lists what is left open");
    if (output_) TILEMEND_RETURN_IF_ERROR(FinishOutput(report, outcome));
    return outcome;
  }

 private:
  enum class End { kOpen, kCancelled, kComplete };

  bool is_cancelled() const { return end_.load() == End::kCancelled; }
  // Whether the output ends so: it is complete, or the job was cancelled, whichever came first.
  bool EndAs(End end) {
    End open = End::kOpen;
    return end_.compare_exchange_strong(open, end) || open == end;
  }

  absl::StatusOr<std::vector<NewTask>> NextTasks() {
    std::vector<NewTask> tasks;
    const auto task = [this](const auto& work) { return TaskOf(work); };
    size_t bytes = 0;
    while (bytes < kEnoughBytes && tasks.size() < kEnoughTasks) {
      const std::optional<SceneWork> next = waves_.Next();
      if (!next) break;
      if (is_cancelled()) return absl::CancelledError("the job was cancelled");
      TILEMEND_ASSIGN_OR_RETURN(tasks.emplace_back(), std::visit(task, *next));
      bytes += tasks.back().input.size();
    }
    return tasks;
  }

  absl::StatusOr<NewTask> TaskOf(const SurveyWork& work) const {
    v1::SurveyInput input;
    *input.mutable_tile() = Ref(*work.tile);
    input.set_look(!spec_.dry_run);
    const Box2 reach = ReachOfCell(waves_.scene(), work.tile->cell);
    for (const double x : {reach.lo.x(), reach.lo.y(), reach.hi.x(), reach.hi.y()}) input.add_reach(x);
    return NewTask{work.tile->cell, Stage::kSurvey, input.SerializeAsString()};
  }

  absl::StatusOr<NewTask> TaskOf(const ClusterWork& work) const {
    v1::SampleClusterInput input;
    input.set_cluster(work.cluster);
    *input.mutable_holes() = ToProto(work.holes);
    *input.mutable_options() = shape_;
    return NewTask{work.holes.cell, Stage::kSampleCluster, input.SerializeAsString()};
  }

  absl::StatusOr<NewTask> TaskOf(const LayerWork& work) const {
    v1::SampleLayerInput input;
    *input.mutable_holes() = ToProto(work.holes);
    return NewTask{work.holes.cell, Stage::kSampleLayer, input.SerializeAsString()};
  }

  absl::StatusOr<NewTask> TaskOf(const FillWork& work) {
    v1::FillInput input;
    *input.mutable_holes() = ToProto(work.holes);
    *input.mutable_options() = shape_;
    for (const SceneTile* tile : work.surface) *input.add_surface() = Ref(*tile);
    TILEMEND_ASSIGN_OR_RETURN(rims_[work.holes.cell], PutAside(ToProto(work.holes.vertices)));
    return NewTask{work.holes.cell, Stage::kFill, input.SerializeAsString()};
  }

  absl::StatusOr<NewTask> TaskOf(const AssembleWork& work) {
    if (!writing_) TILEMEND_RETURN_IF_ERROR(output_->BeginWriting());
    writing_ = true;
    v1::AssembleInput input;
    *input.mutable_tile() = Ref(*work.tile);
    input.set_output(OutputPath(*work.tile));
    input.set_attempts(output_->attempts().path());
    input.set_float32(work.float32);
    input.set_tile_vertices(work.tile_vertices);
    if (const auto patches = patches_.find(work.tile->cell); patches != patches_.end()) {
      TILEMEND_ASSIGN_OR_RETURN(*input.mutable_vertices(), TakeUp<v1::RimVertices>(rims_.at(work.tile->cell)));
      TILEMEND_ASSIGN_OR_RETURN(*input.mutable_patches(), TakeUp<v1::FillOutput>(patches->second));
      patches_.erase(patches);
      SetColours(work.colours, input);
    }
    SetFiles(*work.tile, input);
    rims_.erase(work.tile->cell);
    return NewTask{work.tile->cell, Stage::kAssemble, input.SerializeAsString()};
  }

  void SetFiles(const SceneTile& tile, v1::AssembleInput& input) {
    std::string library = files_.LibraryOf(tile.cell);
    input.set_new_library(library.empty());
    if (library.empty()) library = files_.NewLibraryFor(OutputPath(tile));
    output_->Adopt({library});
    input.set_library(std::move(library));
    const std::vector<std::string> carried = files_.CarriedBy(tile.cell);
    output_->Adopt({carried.begin(), carried.end()});
    input.mutable_carried()->Add(carried.begin(), carried.end());
    input.set_link_images(spec_.textures == "link");
    input.set_output_root(spec_.out);
  }

  v1::TileRef Ref(const SceneTile& tile) const {
    v1::TileRef ref;
    ref.set_root(waves_.scene().root);
    ref.set_path(tile.path);
    ref.set_col(tile.cell.col);
    ref.set_row(tile.cell.row);
    if (const auto it = digests_.find(tile.cell); it != digests_.end()) ref.set_digest(it->second);
    return ref;
  }

  absl::Status Take(const TaskResult& result) {
    if (result.stage == Stage::kSurvey) return TakeSurvey(result);
    const absl::Status status = Decode(result);
    return status.ok() || result.stage == Stage::kAssemble ? status : Unreadable(result.cell, status);
  }

  absl::Status TakeSurvey(const TaskResult& result) {
    absl::StatusOr<SurveyedTile> tile = SurveyedTileOf(*result.output);
    if (!tile.ok()) return Unreadable(result.cell, tile.status());
    TILEMEND_RETURN_IF_ERROR(CheckInsideCell(tile->record, waves_.scene(), waves_.tile(result.cell)));
    if (spec_.textures != "off") files_.Take(result.cell, tile->files);
    digests_[result.cell] = std::move(tile->digest);
    TILEMEND_ASSIGN_OR_RETURN(StoredRecord stored, scratch_->Keep(tile->record));
    waves_.TakeSurvey(result.cell, std::move(stored));
    return absl::OkStatus();
  }

  absl::StatusOr<ScratchFile::Place> PutAside(const google::protobuf::MessageLite& message) {
    return scratch_->Put(message.SerializeAsString());
  }

  template <typename Message>
  absl::StatusOr<Message> TakeUp(const ScratchFile::Place& place) const {
    TILEMEND_ASSIGN_OR_RETURN(const std::string bytes, scratch_->Get(place));
    return Parse<Message>(bytes);
  }

  absl::Status ComparePatches(CellId cell, const v1::FillOutput& output) {
    if (!waves_.CompareFills(cell)) return absl::OkStatus();
    TILEMEND_ASSIGN_OR_RETURN(const auto rims, TakeUp<v1::RimVertices>(rims_.at(cell)));
    TILEMEND_ASSIGN_OR_RETURN(const std::vector<RimVertex> vertices, FromProto(rims));
    TILEMEND_ASSIGN_OR_RETURN(const std::vector<HolePatch> patches, FromProto(output, vertices.size()));
    waves_.TakePatches(cell, vertices, patches);
    return absl::OkStatus();
  }

  absl::Status Decode(const TaskResult& result) {
    switch (result.stage) {
      case Stage::kSampleCluster: {
        TILEMEND_ASSIGN_OR_RETURN(const auto output, Parse<v1::SampleClusterOutput>(*result.output));
        TILEMEND_ASSIGN_OR_RETURN(const ClusterSamples samples, SamplesOf(output));
        return waves_.TakeCluster(samples);
      }
      case Stage::kSampleLayer: {
        TILEMEND_ASSIGN_OR_RETURN(const auto output, Parse<v1::SampleLayerOutput>(*result.output));
        TILEMEND_ASSIGN_OR_RETURN(const auto samples, SamplesOf(output, result.cell));
        return waves_.TakeLayer(samples);
      }
      case Stage::kFill: {
        TILEMEND_ASSIGN_OR_RETURN(auto output, Parse<v1::FillOutput>(*result.output));
        TILEMEND_ASSIGN_OR_RETURN(const CellPatches patches, PatchesOf(output));
        TILEMEND_RETURN_IF_ERROR(ComparePatches(result.cell, output));
        output.clear_quality();
        TILEMEND_ASSIGN_OR_RETURN(patches_[result.cell], PutAside(output));
        return waves_.TakeFill(result.cell, patches);
      }
      case Stage::kAssemble: {
        TILEMEND_ASSIGN_OR_RETURN(const auto output, Parse<v1::AssembleOutput>(*result.output));
        files_.Warn(result.cell, {output.warnings().begin(), output.warnings().end()});
        waves_.TakeAssemble();
        return PlaceFiles(output, *output_);
      }
      default:
        return absl::InvalidArgumentError("unknown stage");
    }
  }

  // Goes on without a cell that workers died of, or whose filling broke: the failure of a cell is not that of the job.
  // Without its survey or in want of disk space there is no going on.
  absl::Status Leave(const TaskResult& result) {
    const absl::Status& error = result.output.status();
    const std::string reason(error.message());
    const bool given_up = ErrorReason(error) == "QUARANTINED" || ErrorReason(error) == "RESULT_REFUSED";
    if (result.stage == Stage::kAssemble && given_up) {
      waves_.LeaveTile(result.cell, reason);
      return absl::OkStatus();
    }
    const bool filling = result.stage != Stage::kSurvey && result.stage != Stage::kAssemble;
    if (!filling || !(given_up || absl::IsInternal(error))) return error;
    waves_.LeaveHoles(result.cell, reason);
    rims_.erase(result.cell);
    return absl::OkStatus();
  }

  SceneReportInput Report() const {
    SceneReportInput report;
    report.plan = &waves_.plan();
    report.outcome = waves_.outcome();
    report.cells = static_cast<int64_t>(waves_.scene().tiles.size());
    report.seconds = seconds_;
    report.scene = spec_.scene;
    report.date = UtcText(absl::Now());
    report.options = OptionsOf(spec_);
    report.warnings = waves_.scene().warnings;
    for (std::string& warning : files_.Warnings()) report.warnings.push_back(std::move(warning));
    return report;
  }

  absl::Status FinishOutput(const SceneReportInput& report, JobOutcome& outcome) {
    TILEMEND_RETURN_IF_ERROR(output_->SeeAll());
    const Scene& scene = waves_.scene();
    if (scene.found_by_name) {
      TILEMEND_RETURN_IF_ERROR(WriteFileAtomically(absl::StrCat(output_->path(), "/scene.json"), SceneJson(scene)));
    }
    TILEMEND_RETURN_IF_ERROR(CarryMetadata(waves_.scene(), *output_));
    output_->Adopt(files_.Carried());
    if (const int64_t others = output_->TidyUp(); others > 0) {
      absl::StrAppend(&outcome.message, "; ", others, " other files in the folder left as they were");
    }
    const std::string folder = output_->path() + "/";
    TILEMEND_RETURN_IF_ERROR(WriteFileAtomically(folder + "holes.geojson", HolesGeoJson(report, scene)));
    TILEMEND_RETURN_IF_ERROR(WriteFileAtomically(folder + "breaklines.geojson", BreaklinesGeoJson(report, scene)));
    outcome.report = folder + "report.json";
    TILEMEND_RETURN_IF_ERROR(WriteFileAtomically(outcome.report, SceneReport(report)));
    TILEMEND_RETURN_IF_ERROR(SyncFolder(output_->path()));
    if (!EndAs(End::kComplete)) {
      TILEMEND_RETURN_IF_ERROR(output_->BeginWriting());  // it is not complete in the eyes of who cancelled it
      return absl::CancelledError("the job was cancelled");
    }
    return absl::OkStatus();
  }

  const JobSpec spec_;
  const std::shared_ptr<ScratchFile> scratch_;
  const v1::ShapeOptions shape_;
  std::optional<OutputFolder> output_;  // none in a dry run
  bool writing_ = false;
  std::atomic<End> end_{End::kOpen};
  Stopwatch watch_;
  std::vector<std::pair<std::string, double>> seconds_;  // by step
  SceneFiles files_;
  SceneWaves waves_;
  std::map<CellId, std::string> digests_;      // of the tiles
  std::map<CellId, ScratchFile::Place> rims_;  // of the cells that are filled, until they are assembled
  std::map<CellId, ScratchFile::Place> patches_;
};

// What makes two jobs write the same bytes. The files of water and of the area count by their content.
std::string JobKey(const JobSpec& spec, const WaterChoice& water, const std::string& area_digest) {
  return absl::StrFormat(
      "scene %s\nsurface %s\nuniform %d\ngradation %.17g\nsize_limit %.17g\nseam_smoothing %.17g\ntension %s\n"
      "water %s %s\nwater_tolerance %.17g\nwater_profile %s\nwater_colour %s\ntextures %s\narea %s\n",
      spec.scene, spec.surface, spec.uniform, spec.gradation, spec.size_limit, spec.seam_smoothing,
      spec.tension ? absl::StrFormat("%.17g", *spec.tension) : "auto", spec.water, water.digest, spec.water_tolerance,
      spec.water_profile, spec.water_colour, spec.textures, area_digest);
}

absl::StatusOr<std::unique_ptr<JobPipeline>> MakeScenePipeline(const JobSpec& spec, const std::string& scratch_folder) {
  TILEMEND_ASSIGN_OR_RETURN(Scene scene, LoadScene(spec.scene, ReadTileBounds));
  TILEMEND_ASSIGN_OR_RETURN(const std::string area_digest, ApplyAreaChoice(spec.area, scene));
  TILEMEND_ASSIGN_OR_RETURN(WaterChoice water, ReadWaterChoice(spec.water, spec.water_tolerance, FrameOf(scene)));
  water.options.profile = *WaterProfileNamed(spec.water_profile);
  for (std::string& warning : water.warnings) scene.warnings.push_back(std::move(warning));
  std::optional<OutputFolder> output;
  if (!spec.dry_run) {
    TILEMEND_ASSIGN_OR_RETURN(OutputFolder claimed,
                              OutputFolder::Claim(spec.out, scene, spec.overwrite, JobKey(spec, water, area_digest)));
    output.emplace(std::move(claimed));
  }
  TILEMEND_ASSIGN_OR_RETURN(auto scratch, ScratchFile::Create(scratch_folder));
  return std::make_unique<ScenePipeline>(spec, std::move(scene), std::move(water.options), std::move(output),
                                         std::move(scratch));
}

}  // namespace

PipelineFactory ScenePipelineFactory(std::string scratch) {
  return [scratch = std::move(scratch)](const JobSpec& spec) { return MakeScenePipeline(spec, scratch); };
}

}  // namespace tilemend
