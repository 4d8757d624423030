#include "coordinator/service/scene_pipeline.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <iterator>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <utility>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"
#include "common/rpc/stage_payloads.h"
#include "common/util/error_info.h"
#include "common/util/files.h"
#include "common/util/status_macros.h"
#include "common/util/stopwatch.h"
#include "coordinator/plan/make_cell_holes.h"
#include "coordinator/plan/plan.h"
#include "coordinator/plan/seam/seam_heights.h"
#include "coordinator/plan/water/water.h"
#include "coordinator/report/scene_report.h"
#include "coordinator/report/tile_checks.h"
#include "coordinator/report/water_choice.h"
#include "coordinator/service/output_folder.h"
#include "tilemend/v1/stages.pb.h"

namespace tilemend {
namespace {

constexpr char kThinPlate[] = "thin-plate";

// survey (all cells) -> plan -> sample -> fill (all cells with holes) -> assemble (all cells). The surface wang, and
// what thin-plate leaves unknown, is sampled layer by layer. thin-plate is sampled cluster by cluster, and a cell is
// filled as soon as its own clusters are known.
class ScenePipeline : public JobPipeline {
 public:
  ScenePipeline(JobSpec spec, Scene scene, WaterOptions water, std::optional<OutputFolder> output)
      : spec_(std::move(spec)), scene_(std::move(scene)), water_(std::move(water)), output_(std::move(output)) {
    for (const SceneTile& tile : scene_.tiles) tiles_[tile.cell] = &tile;
  }

  absl::StatusOr<std::vector<NewTask>> Start() override {
    phase_ = "survey";
    std::vector<NewTask> tasks;
    for (const SceneTile& tile : scene_.tiles) {
      if (tile.path.empty()) continue;
      v1::SurveyInput input;
      *input.mutable_tile() = Ref(tile);
      tasks.push_back({tile.cell, Stage::kSurvey, input.SerializeAsString()});
    }
    if (tasks.empty())
      return absl::InvalidArgumentError(absl::StrCat(spec_.scene, ": no cell of the scene has a tile"));
    waiting_ = tasks.size();
    return tasks;
  }

  absl::StatusOr<std::vector<NewTask>> OnTaskDone(TaskResult result) override {
    TILEMEND_RETURN_IF_ERROR(result.output.ok() ? Take(result) : LeaveCell(result));
    std::vector<NewTask> tasks = std::exchange(ready_, {});
    --waiting_;
    while (tasks.empty() && waiting_ == 0 && !done_) {
      TILEMEND_ASSIGN_OR_RETURN(tasks, NextWave());
    }
    waiting_ += tasks.size();
    return tasks;
  }

  bool Done() const override { return done_; }

  Progress GetProgress() const override {
    Progress progress;
    progress.phase = phase_;
    progress.cells = static_cast<int64_t>(scene_.tiles.size());
    progress.cells_done = cells_done_;
    progress.holes = static_cast<int64_t>(plan_.holes.size());
    progress.holes_filled = static_cast<int64_t>(report_.sizes.size());
    return progress;
  }

  bool Cancel() override { return EndAs(End::kCancelled); }

  absl::StatusOr<JobOutcome> Finish() override {
    report_.plan = &plan_;
    report_.cells = static_cast<int64_t>(scene_.tiles.size());
    report_.surface = spec_.surface;
    report_.given_tension = spec_.tension;
    report_.warnings = scene_.warnings;
    JobOutcome outcome;
    const auto left = LeftOf(report_);
    const bool holes_left = std::any_of(left.begin(), left.end(), [](const LeftOpen& l) { return l.is_hole; });
    outcome.partial = holes_left && !spec_.dry_run;
    outcome.message = spec_.dry_run ? absl::StrCat(plan_.holes.size(), " holes found, nothing written")
                                    : absl::StrCat(report_.sizes.size(), " of ", plan_.holes.size(), " holes filled",
                                                   left.empty() ? "" : "; the report lists what is left open");
    if (output_) TILEMEND_RETURN_IF_ERROR(FinishOutput(outcome));
    return outcome;
  }

 private:
  enum class Wave { kSurvey, kCluster, kSample, kFill, kAssemble };
  enum class End { kOpen, kCancelled, kComplete };

  // Whether the output ends so: it is complete, or the job was cancelled, whichever came first.
  bool EndAs(End end) {
    End open = End::kOpen;
    return end_.compare_exchange_strong(open, end) || open == end;
  }

  absl::Status FinishOutput(JobOutcome& outcome) {
    if (scene_.found_by_name) {
      TILEMEND_RETURN_IF_ERROR(WriteFileAtomically(absl::StrCat(output_->path(), "/scene.json"), SceneJson(scene_)));
    }
    if (const int64_t others = output_->TidyUp(); others > 0) {
      absl::StrAppend(&outcome.message, "; ", others, " other files in the folder left as they were");
    }
    outcome.report = absl::StrCat(output_->path(), "/report.json");
    TILEMEND_RETURN_IF_ERROR(WriteFileAtomically(outcome.report, SceneReport(report_)));
    if (!EndAs(End::kComplete)) {
      TILEMEND_RETURN_IF_ERROR(output_->BeginWriting());  // it is not complete in the eyes of who cancelled it
      return absl::CancelledError("the job was cancelled");
    }
    output_->Finish();
    return absl::OkStatus();
  }

  v1::TileRef Ref(const SceneTile& tile) const {
    v1::TileRef ref;
    ref.set_root(scene_.root);
    ref.set_path(tile.path);
    ref.set_col(tile.cell.col);
    ref.set_row(tile.cell.row);
    if (const auto it = digests_.find(tile.cell); it != digests_.end()) ref.set_digest(it->second);
    return ref;
  }

  absl::Status Take(const TaskResult& result) {
    const std::string& bytes = *result.output;
    absl::Status malformed =
        absl::InternalError(absl::StrCat("a worker's result for cell ", ToString(result.cell), " cannot be read"));
    switch (result.stage) {
      case Stage::kSurvey: {
        v1::SurveyOutput output;
        if (!output.ParseFromString(bytes)) return malformed;
        digests_[result.cell] = output.digest();
        TILEMEND_ASSIGN_OR_RETURN(records_[result.cell], FromProto(output));
        const SceneTile& tile = *tiles_.at(result.cell);
        return CheckInsideCell(records_[result.cell], scene_.grid, tile, absl::StrCat(scene_.root, "/", tile.path));
      }
      case Stage::kSample: {
        v1::SampleOutput output;
        if (!output.ParseFromString(bytes) || output.height_size() != output.seam_vertex_size()) return malformed;
        if (wave_ == Wave::kCluster) return TakeClusterSamples(output);
        for (int i = 0; i < output.height_size(); ++i) {
          const int32_t vertex = output.seam_vertex(i);
          if (vertex < 0 || vertex >= std::ssize(plan_.vertices) || !std::isfinite(output.height(i))) return malformed;
          samples_.push_back({result.cell, vertex, output.height(i)});
        }
        return absl::OkStatus();
      }
      case Stage::kFill: {
        v1::FillOutput output;
        if (!output.ParseFromString(bytes)) return malformed;
        for (const v1::PatchExtent& e : output.patches()) {
          if (e.hole() < 0 || e.hole() >= std::ssize(plan_.holes)) return malformed;
          if (e.has_hold_out()) {
            TILEMEND_ASSIGN_OR_RETURN(report_.of_holes[e.hole()], FromProto(e.hold_out()));
          }
          if (e.failure().empty()) {
            report_.sizes[e.hole()] = {e.new_points(), e.triangles()};
          } else {
            report_.failures[e.hole()] = e.failure();
          }
        }
        TILEMEND_ASSIGN_OR_RETURN(const QualityTally quality, FromProto(output.quality()));
        report_.quality.Merge(quality);
        output.clear_quality();
        patches_[result.cell] = std::move(output);
        return absl::OkStatus();
      }
      case Stage::kAssemble:
        ++cells_done_;
        return absl::OkStatus();
    }
    return malformed;
  }

  absl::Status TakeClusterSamples(const v1::SampleOutput& output) {
    if (output.laplacian_size() != output.height_size())
      return absl::InternalError("a worker's cluster samples are incomplete");
    if (output.has_hold_out()) {
      TILEMEND_ASSIGN_OR_RETURN(const HoldOut hold_out, FromProto(output.hold_out()));
      report_.of_clusters[output.cluster()] = hold_out;
      heights_.tension[output.cluster()] = hold_out.tension;
    }
    std::vector<ClusterSample> samples;
    for (int i = 0; i < output.height_size(); ++i) {
      const int32_t vertex = output.seam_vertex(i);
      if (vertex < 0 || vertex >= std::ssize(plan_.vertices)) {
        return absl::InternalError("a worker's cluster samples name a vertex that is not in the plan");
      }
      samples.push_back({vertex, output.height(i), output.laplacian(i)});
    }
    SettleCluster(plan_, output.cluster(), samples, heights_);
    for (const CellId cell : cells_of_cluster_[output.cluster()]) {
      if (--clusters_left_[cell] == 0 && CanBeFilled(cell)) ready_.push_back(FillTask(cell));
    }
    return absl::OkStatus();
  }

  // Goes on without a cell that workers died of, or whose filling broke: the failure of a cell is not that of the job.
  // Without its survey or in want of disk space there is no going on.
  absl::Status LeaveCell(const TaskResult& result) {
    const absl::Status& error = result.output.status();
    const bool quarantined = ErrorReason(error) == "QUARANTINED";
    const bool filling = result.stage == Stage::kSample || result.stage == Stage::kFill;
    if (!(filling && (quarantined || absl::IsInternal(error))) && !(result.stage == Stage::kAssemble && quarantined)) {
      return error;
    }
    const std::string reason(error.message());
    const auto holes = holes_of_.find(result.cell);
    if (holes != holes_of_.end()) {
      for (const int32_t h : holes->second) report_.failures[h] = reason;
      holes_of_.erase(holes);
    }
    if (!filling) plan_.left.push_back({result.cell, absl::StrCat("the tile is not written: ", reason)});
    return absl::OkStatus();
  }

  // What comes after the wave that has just ended.
  absl::StatusOr<std::vector<NewTask>> NextWave() {
    switch (wave_) {
      case Wave::kSurvey:
        report_.seconds.emplace_back("survey", watch_.Lap());
        MakeThePlan();
        report_.seconds.emplace_back("plan", watch_.Lap());
        if (spec_.dry_run) {
          done_ = true;
          return std::vector<NewTask>{};
        }
        wave_ = Wave::kCluster;
        return spec_.surface == kThinPlate ? SampleClusters() : std::vector<NewTask>{};
      case Wave::kCluster:
        wave_ = Wave::kSample;
        return SampleLayer(1);
      case Wave::kSample:
        SettleLayer(plan_, samples_, spec_.seam_smoothing, heights_);
        samples_.clear();
        if (layer_ < plan_.layers) return SampleLayer(layer_ + 1);
        report_.seconds.emplace_back("sample", watch_.Lap());
        wave_ = Wave::kFill;
        return FillCells();
      case Wave::kFill:
        report_.seconds.emplace_back("fill", watch_.Lap());
        wave_ = Wave::kAssemble;
        return AssembleCells();
      case Wave::kAssemble:
        report_.seconds.emplace_back("assemble", watch_.Lap());
        done_ = true;
        return std::vector<NewTask>{};
    }
    return absl::InternalError("unknown wave");
  }

  void MakeThePlan() {
    phase_ = "plan";
    input_.grid = scene_.grid;
    input_.area_known = scene_.area_known;
    for (const SceneTile& tile : scene_.tiles) {
      const auto it = records_.find(tile.cell);
      input_.cells[tile.cell] = it == records_.end() ? nullptr : &it->second;
    }
    PlanOptions options;
    options.gradation = spec_.gradation;
    options.size_limit = spec_.size_limit;
    options.uniform = spec_.uniform;
    options.water = water_;
    plan_ = MakePlan(input_, options);
    SettleWater(plan_, heights_);
    for (size_t h = 0; h < plan_.holes.size(); ++h) {
      if (plan_.holes[h].failure.empty()) holes_of_[plan_.holes[h].cell].push_back(static_cast<int32_t>(h));
    }
  }

  v1::ShapeOptions Options() const {
    v1::ShapeOptions options;
    options.set_gradation(spec_.gradation);
    options.set_size_limit(spec_.size_limit);
    options.set_uniform(spec_.uniform);
    options.set_thin_plate(spec_.surface == kThinPlate);
    if (spec_.tension) options.set_tension(*spec_.tension);
    return options;
  }

  // One task for the surface of each cluster, the largest first; cells that need none are filled meanwhile, the others
  // as soon as the surfaces of all their clusters are known.
  std::vector<NewTask> SampleClusters() {
    phase_ = "sample clusters and fill";
    std::map<int32_t, std::vector<int32_t>> clusters;
    for (const auto& [cell, holes] : holes_of_) {
      for (const int32_t h : holes) {
        if (plan_.holes[h].cluster >= 0 && plan_.holes[h].water < 0) clusters[plan_.holes[h].cluster].push_back(h);
      }
    }
    std::vector<NewTask> tasks;
    for (const auto& [cluster, holes] : clusters) {
      v1::SampleInput input;
      *input.mutable_holes() = ToProto(MakeCellHoles(plan_, input_, heights_, holes, true));
      input.set_whole_cluster(true);
      input.set_cluster(cluster);
      *input.mutable_options() = Options();
      tasks.push_back({plan_.holes[holes.front()].cell, Stage::kSample, input.SerializeAsString()});
      std::set<CellId> cells;
      for (const int32_t h : holes) cells.insert(plan_.holes[h].cell);
      for (const CellId cell : cells) ++clusters_left_[cell];
      cells_of_cluster_[cluster].assign(cells.begin(), cells.end());
    }
    std::stable_sort(tasks.begin(), tasks.end(),
                     [](const NewTask& a, const NewTask& b) { return a.input.size() > b.input.size(); });
    for (const auto& [cell, holes] : holes_of_) {
      if (!clusters_left_.contains(cell) && CanBeFilled(cell)) tasks.push_back(FillTask(cell));
    }
    return tasks;
  }

  // Whether all seam vertices of the cell are settled.
  bool CanBeFilled(CellId cell) const {
    const auto holes = holes_of_.find(cell);
    return holes != holes_of_.end() &&
           std::none_of(holes->second.begin(), holes->second.end(), [&](int32_t h) { return NeedsHeights(h); });
  }

  // The holes of a layer with seam vertices that are not settled.
  bool NeedsHeights(int32_t h) const {
    const auto& segments = plan_.holes[h].segments;
    return std::any_of(segments.begin(), segments.end(), [&](const RimSegment& s) {
      return plan_.vertices[s.from].index < 0 && !heights_.height.contains(s.from);
    });
  }

  std::vector<NewTask> SampleLayer(int32_t layer) {
    layer_ = layer;
    phase_ = absl::StrCat("sample layer ", layer, " of ", plan_.layers);
    std::vector<NewTask> tasks;
    for (const auto& [cell, holes] : holes_of_) {
      std::vector<int32_t> of_layer;
      std::copy_if(holes.begin(), holes.end(), std::back_inserter(of_layer),
                   [&](int32_t h) { return plan_.holes[h].layer == layer && NeedsHeights(h); });
      if (of_layer.empty()) continue;
      v1::SampleInput input;
      *input.mutable_holes() = ToProto(MakeCellHoles(plan_, input_, heights_, of_layer, false));
      tasks.push_back({cell, Stage::kSample, input.SerializeAsString()});
    }
    return tasks;
  }

  std::vector<NewTask> FillCells() {
    phase_ = "fill";
    std::vector<NewTask> tasks;
    for (const auto& [cell, holes] : holes_of_) {
      if (!filling_.contains(cell)) tasks.push_back(FillTask(cell));
    }
    return tasks;
  }

  NewTask FillTask(CellId cell) {
    filling_.insert(cell);
    v1::FillInput input;
    const CellHoles work = MakeCellHoles(plan_, input_, heights_, holes_of_.at(cell), true);
    *input.mutable_holes() = ToProto(work);
    *input.mutable_options() = Options();
    for (const CellId tile : TilesBeside(work)) *input.add_surface() = Ref(*tiles_.at(tile));
    rims_[cell] = ToProto(work.vertices);
    return {cell, Stage::kFill, input.SerializeAsString()};
  }

  // The tiles that lie within reach of the cell's closed holes: its own, and those that share its border.
  std::set<CellId> TilesBeside(const CellHoles& work) const {
    std::vector<Eigen::AlignedBox3d> holes;
    for (const CellHole& hole : work.holes) {
      if (!hole.open && !hole.level) holes.push_back(ReachOf(work, hole));
    }
    std::set<CellId> candidates = {work.cell}, tiles;
    for (const BorderAudit& border : plan_.borders) {
      if (border.kind != BorderKind::kExact) continue;  // tiles that overlap are each filled for themselves
      if (border.a == work.cell) candidates.insert(border.b);
      if (border.b == work.cell) candidates.insert(border.a);
    }
    for (const CellId cell : candidates) {
      const auto record = records_.find(cell);
      if (record == records_.end()) continue;
      const Eigen::AlignedBox3d extent(record->second.lo, record->second.hi);
      if (std::any_of(holes.begin(), holes.end(), [&](const auto& hole) { return hole.intersects(extent); })) {
        tiles.insert(cell);
      }
    }
    return tiles;
  }

  absl::StatusOr<std::vector<NewTask>> AssembleCells() {
    phase_ = "assemble";
    if (output_) TILEMEND_RETURN_IF_ERROR(output_->BeginWriting());
    const bool float32 = std::any_of(records_.begin(), records_.end(), [](const auto& r) { return r.second.float32; });
    std::vector<NewTask> tasks;
    for (const SceneTile& tile : scene_.tiles) {
      if (tile.path.empty() && !IsFilled(tile.cell)) {  // nothing to write
        ++cells_done_;
        continue;
      }
      v1::AssembleInput input;
      *input.mutable_tile() = Ref(tile);
      input.set_output(absl::StrCat(spec_.out, "/", OutputPath(tile)));
      input.set_float32(float32);
      if (const auto it = records_.find(tile.cell); it != records_.end())
        input.set_tile_vertices(it->second.vertex_count);
      if (const auto it = patches_.find(tile.cell); it != patches_.end()) {
        *input.mutable_vertices() = std::move(rims_.at(tile.cell));
        *input.mutable_patches() = std::move(it->second);
      }
      tasks.push_back({tile.cell, Stage::kAssemble, input.SerializeAsString()});
    }
    patches_.clear();
    rims_.clear();
    return tasks;
  }

  // Whether a worker filled a hole of the cell.
  bool IsFilled(CellId cell) const {
    const auto it = patches_.find(cell);
    return it != patches_.end() && std::any_of(it->second.patches().begin(), it->second.patches().end(),
                                               [](const v1::PatchExtent& e) { return e.failure().empty(); });
  }

  const JobSpec spec_;
  const Scene scene_;
  const WaterOptions water_;
  std::optional<OutputFolder> output_;
  std::map<CellId, const SceneTile*> tiles_;
  Wave wave_ = Wave::kSurvey;
  int32_t layer_ = 0;
  size_t waiting_ = 0;
  bool done_ = false;
  std::atomic<End> end_{End::kOpen};
  int64_t cells_done_ = 0;
  std::string phase_;
  Stopwatch watch_;

  std::map<CellId, std::string> digests_;
  std::map<CellId, SurveyRecord> records_;
  PlanInput input_;
  Plan plan_;
  std::map<CellId, std::vector<int32_t>> holes_of_;
  std::vector<SeamSample> samples_;
  std::map<int32_t, std::vector<CellId>> cells_of_cluster_;
  std::map<CellId, int32_t> clusters_left_;  // of which a cell awaits the surface
  std::set<CellId> filling_;                 // cells with a fill task
  std::vector<NewTask> ready_;               // what the last result has made possible
  SeamHeights heights_;
  std::map<CellId, v1::RimVertices> rims_;
  std::map<CellId, v1::FillOutput> patches_;
  SceneReportInput report_;
};

// What makes two jobs write the same bytes. The file of water areas counts by its content.
std::string JobKey(const JobSpec& spec, const WaterChoice& water) {
  return absl::StrFormat(
      "scene %s\nsurface %s\nuniform %d\ngradation %.17g\nsize_limit %.17g\nseam_smoothing %.17g\ntension %s\n"
      "water %s %s\nwater_tolerance %.17g\n",
      spec.scene, spec.surface, spec.uniform, spec.gradation, spec.size_limit, spec.seam_smoothing,
      spec.tension ? absl::StrFormat("%.17g", *spec.tension) : "auto", spec.water, water.digest, spec.water_tolerance);
}

absl::StatusOr<std::unique_ptr<JobPipeline>> MakeScenePipeline(const JobSpec& spec) {
  TILEMEND_ASSIGN_OR_RETURN(Scene scene, LoadScene(spec.scene, ReadTileBounds));
  TILEMEND_ASSIGN_OR_RETURN(WaterChoice water, ReadWaterChoice(spec.water, spec.water_tolerance));
  std::optional<OutputFolder> output;
  if (!spec.dry_run) {
    TILEMEND_ASSIGN_OR_RETURN(OutputFolder claimed,
                              OutputFolder::Claim(spec.out, scene, spec.overwrite, JobKey(spec, water)));
    output.emplace(std::move(claimed));
  }
  return std::make_unique<ScenePipeline>(spec, std::move(scene), std::move(water.options), std::move(output));
}

}  // namespace

PipelineFactory ScenePipelineFactory() { return MakeScenePipeline; }

}  // namespace tilemend
