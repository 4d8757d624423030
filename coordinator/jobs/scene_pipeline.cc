#include "coordinator/jobs/scene_pipeline.h"

#include <algorithm>
#include <atomic>
#include <functional>
#include <optional>
#include <set>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"
#include "absl/time/clock.h"
#include "common/codec/tiles3d/tileset_layout.h"
#include "common/gis/area_file.h"
#include "common/grid/cell_choice.h"
#include "common/grid/delivery_paths.h"
#include "common/options/job_options.h"
#include "common/records/output_names.h"
#include "common/util/error_info.h"
#include "common/util/files.h"
#include "common/util/folders.h"
#include "common/util/object_store.h"
#include "common/util/status_macros.h"
#include "common/util/stopwatch.h"
#include "common/util/utc.h"
#include "coordinator/jobs/delivery_entry.h"
#include "coordinator/jobs/earlier_output.h"
#include "coordinator/jobs/end_message.h"
#include "coordinator/jobs/output_cells.h"
#include "coordinator/jobs/scene_folders.h"
#include "coordinator/jobs/scene_options.h"
#include "coordinator/jobs/scene_tasks.h"
#include "coordinator/jobs/task_reuse.h"
#include "coordinator/report/area_choice.h"
#include "coordinator/report/left_open.h"
#include "coordinator/report/plan_warnings.h"
#include "coordinator/report/scene_geojson.h"
#include "coordinator/report/scene_report.h"
#include "coordinator/report/scene_sight.h"
#include "coordinator/report/tile_checks.h"
#include "coordinator/report/water_choice.h"
#include "coordinator/store/output_folder.h"
#include "coordinator/waves/scene_waves.h"

namespace tilemend {
namespace {

// What is given out at once. More follows with each result; each input is in memory until it is given out.
constexpr size_t kEnoughTasks = 256;
constexpr size_t kEnoughBytes = 16 << 20;

// The job is kept with them, so that they are not many.
std::vector<std::string> FirstOf(std::vector<std::string> warnings) {
  constexpr size_t kMost = 20;
  if (warnings.size() <= kMost) return warnings;
  const size_t more = warnings.size() - kMost;
  warnings.resize(kMost);
  warnings.push_back(absl::StrCat("and ", more, " more; tilemend inspect prints all"));
  return warnings;
}

// What is left undone without the result of a task. Precondition: it is none of the measuring or the survey.
LeftWork::Kind LeftBy(Stage stage) {
  if (stage == Stage::kGround) return LeftWork::Kind::kGround;
  if (stage == Stage::kSmoothSeam) return LeftWork::Kind::kSeam;
  return stage == Stage::kAssemble ? LeftWork::Kind::kTile : LeftWork::Kind::kHoles;
}

// How long each step took, and what the page sees of them.
struct Steps {
  Stopwatch watch;
  std::vector<std::pair<std::string, double>> seconds;
  std::shared_ptr<SceneSight> sight;
  int64_t holes = 0;   // in the cells that were chosen, of the plan
  absl::Status areas;  // CheckLevels, once the surface is known, and CheckAreas, once the holes are

  void End(std::string_view step, const SceneWaves& waves) {
    seconds.emplace_back(step, watch.Lap());
    if (step == "survey") areas = CheckLevels(waves.options().plan.water.areas, waves.survey().records());
    if (step == "plan") areas.Update(CheckAreas(waves.plan()));
    if (step == "plan") sight->SetPlan(waves.plan(), waves.outcome().chosen);
    holes = std::ranges::count_if(waves.plan().holes,
                                  [&](const PlannedHole& hole) { return waves.options().IsChosen(hole.cell); });
  }
};

std::function<void(std::string_view)> StepEnds(Steps& steps, const SceneWaves& waves) {
  return [&](std::string_view step) { steps.End(step, waves); };
}

// How an output ends: it is complete, or the job was cancelled, whichever came first. Thread-safe.
class OutputEnd {
 public:
  // Whether it ends so.
  bool Cancel() { return Become(End::kCancelled); }
  bool Complete() { return Become(End::kComplete); }
  bool is_cancelled() const { return end_.load() == End::kCancelled; }

 private:
  enum class End { kOpen, kCancelled, kComplete };
  bool Become(End end) {
    End open = End::kOpen;
    return end_.compare_exchange_strong(open, end) || open == end;
  }

  std::atomic<End> end_{End::kOpen};
};

WaveOptions OptionsFor(const JobSpec& spec, std::set<CellId> chosen, WaterOptions water, const OutputEnd& end,
                       const std::optional<OutputFolder>& output) {
  WaveOptions options = WaveOptionsOf(spec, std::move(water), [&end] { return end.is_cancelled(); });
  options.chosen = std::move(chosen);
  // A complete output stays what it is until all of the new one is known.
  options.write_early = output && !output->has_report();
  return options;
}

// The work of a scene as tasks: gives them out, and hands on what comes of them.
class TaskFlow {
 public:
  // All must outlive this; `output` and `surveys` may be null.
  TaskFlow(SceneVerification verification, SceneWaves& waves, SceneTasks& tasks, const Steps& steps,
           const OutputEnd& end, OutputFolder* output, std::shared_ptr<DecodedSurveys> surveys)
      : verification_(std::move(verification)),
        waves_(waves),
        tasks_(tasks),
        steps_(steps),
        end_(end),
        output_(output),
        surveys_(std::move(surveys)) {}

  // What earlier jobs left. Before the first task.
  void Reuse(ResultLog log) { reuse_.emplace(std::move(log)); }

  absl::StatusOr<std::vector<NewTask>> Take(TaskResult result) {
    --tasks_out_;
    auto next = TakeResult(std::move(result));
    const bool bad_input = absl::IsInvalidArgument(next.status()) || absl::IsNotFound(next.status());
    if (bad_input && !writing_) reuse_->Discard();
    return next;
  }

  absl::StatusOr<std::vector<NewTask>> NextTasks() {
    std::vector<NewTask> tasks;
    size_t bytes = 0;
    while (bytes < kEnoughBytes && tasks.size() < kEnoughTasks && tasks_out_ < kMostTasksOut) {
      std::optional<SceneWork> next = waves_.Next();
      TILEMEND_RETURN_IF_ERROR(steps_.areas);
      if (!next) break;
      if (end_.is_cancelled()) return absl::CancelledError("the job was cancelled");
      if (std::holds_alternative<AssembleWork>(*next) && !std::exchange(writing_, true)) {
        TILEMEND_RETURN_IF_ERROR(output_->CheckRoomFor(tasks_.files().Carried()));
        TILEMEND_RETURN_IF_ERROR(output_->BeginWriting());
      }
      TILEMEND_ASSIGN_OR_RETURN(NewTask task, tasks_.TaskOf(*next));
      if (std::optional<StageResult> known = reuse_->Recall(task, tasks_.NumberOf(task))) {
        TILEMEND_RETURN_IF_ERROR(tasks_.Take(*std::move(known)));
      } else {
        TILEMEND_RETURN_IF_ERROR(tasks_.AddHelp(task));
        TILEMEND_RETURN_IF_ERROR(verification_.AddTask(task));
        bytes += task.input.size();
        ++tasks_out_;
        tasks.push_back(std::move(task));
      }
    }
    while (tasks.size() < kEnoughTasks && tasks_out_ < kMostTasksOut) {
      TILEMEND_ASSIGN_OR_RETURN(std::optional<NewTask> task, verification_.Next(waves_.done()));
      if (!task) break;
      ++tasks_out_;
      tasks.push_back(*std::move(task));
    }
    return tasks;
  }

  SceneVerification& verification() { return verification_; }
  const SceneVerification& verification() const { return verification_; }
  const TaskReuse& reuse() const { return *reuse_; }
  // The job is over.
  void FinishReuse() { reuse_->Finish().IgnoreError(); }

 private:
  absl::StatusOr<std::vector<NewTask>> TakeResult(TaskResult result) {
    if (result.stage == Stage::kVerify) {
      TILEMEND_RETURN_IF_ERROR(verification_.Take(result));
      return verification_.caught() ? std::vector<NewTask>() : NextTasks();
    }
    verification_.AddResult(result);
    if (verification_.caught()) return std::vector<NewTask>();
    if (!result.output.ok()) {
      TILEMEND_RETURN_IF_ERROR(Leave(result));
      return NextTasks();
    }
    const CellId cell = result.cell;
    const Stage stage = result.stage;
    const std::string digest = result.digest;
    SceneVerification::Report report = SceneVerification::ReportOf(result);
    TILEMEND_ASSIGN_OR_RETURN(StageResult decoded, DecodeResult(std::move(result), surveys_.get()));
    const int32_t number = NumberOf(decoded.output);
    TILEMEND_RETURN_IF_ERROR(reuse_->Resolve(decoded, number));
    const std::string bytes = std::move(decoded.bytes);
    SceneVerification::ReadOutput(decoded.output, waves_, report);
    TILEMEND_RETURN_IF_ERROR(tasks_.Take(std::move(decoded)));
    TILEMEND_RETURN_IF_ERROR(reuse_->Keep(cell, stage, number, bytes, digest));
    verification_.AddReport(std::move(report), waves_.scene().root);
    return NextTasks();
  }

  // Goes on without a cell that workers died of, or whose filling broke: the failure of a cell is not that of the job.
  // Without its survey or in want of disk space there is no going on.
  absl::Status Leave(const TaskResult& result) {
    const absl::Status& error = result.output.status();
    const bool given_up = ErrorReason(error) == "QUARANTINED" || ErrorReason(error) == "RESULT_REFUSED";
    if (result.stage == Stage::kMeasure || result.stage == Stage::kSurvey) return error;
    if (!given_up && (result.stage == Stage::kAssemble || !absl::IsInternal(error))) {
      return InCell(result.cell, result.stage, error);
    }
    const LeftWork::Kind kind = LeftBy(result.stage);
    if (kind == LeftWork::Kind::kHoles) tasks_.Forget(result.cell);
    return waves_.Take(LeftWork{kind, result.cell, std::string(error.message())});
  }

  SceneVerification verification_;
  SceneWaves& waves_;
  SceneTasks& tasks_;
  const Steps& steps_;
  const OutputEnd& end_;
  OutputFolder* const output_;
  const std::shared_ptr<DecodedSurveys> surveys_;
  int64_t tasks_out_ = 0;  // given out, and their results have not come
  bool writing_ = false;
  std::optional<TaskReuse> reuse_{std::in_place, std::nullopt};
};

SceneReportInput ReportOf(const JobOnOutput& job, const SceneWaves& waves, const Steps& steps, const SceneTasks& tasks,
                          const TaskReuse& reuse) {
  SceneReportInput report;
  report.plan = &waves.plan();
  report.outcome = waves.outcome();
  report.cells = static_cast<int64_t>(waves.scene().tiles.size());
  report.seconds = steps.seconds;
  report.scene = job.spec.scene();
  report.date = UtcText(absl::Now());
  report.tasks = reuse.tasks();
  report.taken_over = reuse.taken_over();
  report.tiles = reuse.tiles();
  report.tiles_kept = reuse.tiles_kept();
  report.key = job.key;
  report.options = ReportedOptions(job.spec, kOfJobs);
  report.levels = tasks.levels();
  report.files = FileDigestsOf(job.identity);
  report.warnings = waves.scene().warnings;
  for (std::string& warning : tasks.files().Warnings()) report.warnings.push_back(std::move(warning));
  if (std::string undone = UndoneDecisions(job, waves.plan().decisions); !undone.empty())
    report.warnings.push_back(undone);
  return report;
}

// Writes what stands beside the tiles.
absl::Status FinishOutput(const SceneReportInput& report, const SceneWaves& waves, const std::set<std::string>& carried,
                          OutputEnd& end, OutputFolder& output, JobOutcome& outcome) {
  TILEMEND_RETURN_IF_ERROR(output.files().SeeAll([&] { return end.is_cancelled(); }));
  const Scene& scene = waves.scene();
  for (const auto& unwritten : report.outcome.unwritten) {
    TILEMEND_RETURN_IF_ERROR(output.files().RemoveUnwritten(OutputPath(waves.survey().tile(unwritten.cell))));
  }
  TILEMEND_RETURN_IF_ERROR(WriteScene(scene, output));
  output.files().Adopt(carried);
  if (const int64_t others = output.files().TidyUp(); others > 0) {
    absl::StrAppend(&outcome.message, "; other files and folders there, left as they were: ", others);
  }
  const std::string folder = output.path() + "/";
  TILEMEND_RETURN_IF_ERROR(WriteFileAtomically(folder + "holes.geojson", HolesGeoJson(report, scene)));
  TILEMEND_RETURN_IF_ERROR(WriteFileAtomically(folder + "breaklines.geojson", BreaklinesGeoJson(report, scene)));
  outcome.report = folder + "report.json";
  TILEMEND_RETURN_IF_ERROR(WriteFileAtomically(outcome.report, SceneReport(report)));
  TILEMEND_RETURN_IF_ERROR(SyncFolder(output.path()));
  if (!end.Complete()) {
    TILEMEND_RETURN_IF_ERROR(output.BeginWriting());  // it is not complete in the eyes of who cancelled it
    return absl::CancelledError("the job was cancelled");
  }
  return absl::OkStatus();
}

// Drives the waves of a scene with tasks, takes over what is known of them, and owns the output.
class ScenePipeline : public JobPipeline {
 public:
  ScenePipeline(JobOnOutput job, Scene scene, std::set<CellId> chosen, WaterOptions water,
                std::optional<OutputFolder> output, const std::shared_ptr<ScratchFile>& scratch,
                VerifiedShares verified, std::shared_ptr<DecodedSurveys> surveys)
      : job_(std::move(job)),
        output_(std::move(output)),
        waves_(std::move(scene), OptionsFor(job_.spec, std::move(chosen), std::move(water), end_, output_),
               StepEnds(steps_, waves_)),
        tasks_(job_.spec, waves_, output_ ? &*output_ : nullptr, scratch),
        flow_(SceneVerification(verified, output_ ? output_->path() : "", scratch), waves_, tasks_, steps_, end_,
              output_ ? &*output_ : nullptr, std::move(surveys)) {
    steps_.sight = std::make_shared<SceneSight>(waves_.scene());
  }

  absl::StatusOr<JobFolders> Folders() const override {
    return FoldersOf(waves_.scene(), output_ ? &output_->attempts() : nullptr);
  }

  std::shared_ptr<const SceneSight> Sight() const override { return steps_.sight; }

  void Prepare(const std::shared_ptr<JobNotes>& notes, std::optional<Resumption> resumed) override {
    flow_.verification().UseNotes(notes);
    if (output_ && job_.adds) output_->files().LeaveFiles(notes);
    if (!resumed) return;
    opening_ = *resumed == Resumption::kRestart ? ResultLog::Opening::kSameJob : ResultLog::Opening::kSameJobAnew;
  }

  absl::StatusOr<std::vector<NewTask>> Start() override {
    const std::vector<SceneTile>& tiles = waves_.scene().tiles;
    if (std::all_of(tiles.begin(), tiles.end(), [](const SceneTile& tile) { return tile.path.empty(); }))
      return absl::InvalidArgumentError(absl::StrCat(job_.spec.scene(), ": no cell of the scene has a tile"));
    // Nothing can be appended to an object.
    if (output_ && !IsObjectPath(output_->path())) {
      TILEMEND_ASSIGN_OR_RETURN(ResultLog log, ResultLog::Open(output_->result_log(), opening_));
      flow_.Reuse(std::move(log));
    }
    return flow_.NextTasks();
  }

  absl::StatusOr<std::vector<NewTask>> OnTaskDone(TaskResult result) override { return flow_.Take(std::move(result)); }

  std::optional<CaughtWorker> Caught() const override { return flow_.verification().caught(); }

  bool Done() const override { return waves_.done() && flow_.verification().is_over(); }

  Progress GetProgress() const override {
    Progress progress;
    // Also if all of it is known from an earlier run: nobody is to see the job go back.
    progress.phase = waves_.done() && flow_.verification().is_wanted() ? kVerifyPhase : waves_.phase();
    progress.cells = waves_.cells().all;
    progress.cells_done = waves_.cells().done;
    progress.holes = steps_.holes;
    progress.holes_filled = static_cast<int64_t>(waves_.outcome().sizes.size());
    progress.triangles = waves_.outcome().triangles;
    progress.taken_over = flow_.reuse().taken_over();
    return progress;
  }

  bool Cancel() override { return end_.Cancel(); }

  void Release() override {
    // Without a report it is not the output that was finished.
    if (!output_ || !output_->has_report()) return;
    // Without it there is more to keep, nothing else.
    flow_.FinishReuse();
    output_->Finish();
  }

  absl::StatusOr<JobOutcome> Finish() override {
    const SceneReportInput report = ReportOf(job_, waves_, steps_, tasks_, flow_.reuse());
    JobOutcome outcome;
    outcome.partial = IsPartial(report) && !job_.spec.dry_run();
    outcome.message = EndMessage(job_.spec, report, flow_.reuse().without_worker());
    if (job_.spec.dry_run()) outcome.warnings = FirstOf(WarningsOf(report));
    if (output_) {
      TILEMEND_RETURN_IF_ERROR(FinishOutput(report, waves_, tasks_.files().Carried(), end_, *output_, outcome));
    }
    return outcome;
  }

 private:
  const JobOnOutput job_;
  std::optional<OutputFolder> output_;  // none in a dry run
  OutputEnd end_;
  Steps steps_;
  SceneWaves waves_;
  SceneTasks tasks_;
  TaskFlow flow_;
  ResultLog::Opening opening_ = ResultLog::Opening::kNewJob;
};

absl::StatusOr<std::unique_ptr<JobPipeline>> MakeScenePipeline(const JobSpec& spec, const std::string& scratch_folder,
                                                               VerifiedShares verified,
                                                               std::shared_ptr<DecodedSurveys> surveys,
                                                               const std::stop_token& stop) {
  TILEMEND_ASSIGN_OR_RETURN(Scene scene, LoadScene(spec.scene(), ReadTileHull, ReadTilesets));
  CheckCrs(scene, stop);
  TILEMEND_ASSIGN_OR_RETURN(const std::string area_digest, ApplyAreaChoice(spec.area(), scene, stop));
  TILEMEND_RETURN_IF_ERROR(SetDeliveryPaths(spec.output_format(), scene));
  // Again when the tiles are there; here for what is wrong with the CRS.
  TILEMEND_ASSIGN_OR_RETURN(const DeliveryPlaces places, PlaceDelivery(scene));
  if (!places.warning.empty()) scene.warnings.push_back(places.warning);
  TILEMEND_ASSIGN_OR_RETURN(WaterChoice water, ReadWaterChoice(spec.water(), FrameOf(scene), stop));
  TILEMEND_RETURN_IF_ERROR(AddClearFile(spec.clear(), FrameOf(scene), water, stop));
  TILEMEND_RETURN_IF_ERROR(KeepClearInside(scene.area, water));
  TILEMEND_RETURN_IF_ERROR(AddDecisions(spec.decisions(), scene, water, stop));
  water.options.profile = *WaterProfileNamed(spec.water_profile());
  for (std::string& warning : water.warnings) scene.warnings.push_back(std::move(warning));
  TILEMEND_ASSIGN_OR_RETURN(JobOnOutput job, OnOutput(spec, water, area_digest, scene));
  TILEMEND_ASSIGN_OR_RETURN(std::set<CellId> chosen, ChooseCells(job.spec.cells(), scene));
  std::optional<OutputFolder> output;
  if (!spec.dry_run()) {
    TILEMEND_ASSIGN_OR_RETURN(const bool overwrite, MayReplace(spec, job.key));
    TILEMEND_ASSIGN_OR_RETURN(OutputFolder claimed,
                              OutputFolder::Claim(spec.out(), scene, overwrite || job.adds, JobKey(job.identity)));
    if (job.adds) claimed.files().LeaveFiles(std::make_shared<JobNotes>());
    output.emplace(std::move(claimed));
  }
  TILEMEND_ASSIGN_OR_RETURN(auto scratch, ScratchFile::Create(scratch_folder));
  return std::make_unique<ScenePipeline>(std::move(job), std::move(scene), std::move(chosen), std::move(water.options),
                                         std::move(output), std::move(scratch), verified, std::move(surveys));
}

}  // namespace

PipelineFactory ScenePipelineFactory(std::string scratch, VerifiedShares verified,
                                     std::shared_ptr<DecodedSurveys> surveys) {
  return [=, scratch = std::move(scratch), surveys = std::move(surveys)](const JobSpec& spec,
                                                                         const std::stop_token& stop) {
    return MakeScenePipeline(spec, scratch, verified, surveys, stop);
  };
}

}  // namespace tilemend
