#include "coordinator/jobs/scene_tasks.h"

#include <utility>
#include <variant>

#include "common/options/job_options.h"

namespace tilemend {
namespace {

template <typename... Calls>
struct Overloaded : Calls... {
  using Calls::operator()...;
};

}  // namespace

SceneTasks::SceneTasks(const JobSpec& spec, SceneWaves& waves, OutputFolder* output,
                       std::shared_ptr<ScratchFile> scratch)
    : worker_options_(OptionsForWorkers(spec)),
      files_(output != nullptr ? FolderInScene(output->path(), waves.scene().root) : ""),
      tiles_(spec, waves, scratch, files_, levels_),
      samples_(worker_options_, waves),
      fills_(worker_options_, waves, scratch, tiles_),
      seams_(spec, waves, scratch, fills_),
      written_(spec, waves, output, {files_, levels_, tiles_, fills_, seams_}) {}

absl::StatusOr<NewTask> SceneTasks::TaskOf(SceneWork& work) {
  return std::visit(
      Overloaded{
          [this](MeasureWork& w) { return tiles_.TaskOf(w); }, [this](SurveyWork& w) { return tiles_.TaskOf(w); },
          [this](GroundWork& w) { return tiles_.TaskOf(w); }, [this](ClusterWork& w) { return samples_.TaskOf(w); },
          [this](LayerWork& w) { return samples_.TaskOf(w); }, [this](FillWork& w) { return fills_.TaskOf(w); },
          [this](SmoothWork& w) { return seams_.TaskOf(w); }, [this](AssembleWork& w) { return written_.TaskOf(w); }},
      work);
}

int32_t SceneTasks::NumberOf(const NewTask& task) const {
  if (task.stage == Stage::kSmoothSeam) return seams_.last_seam();
  return task.stage == Stage::kSampleCluster ? samples_.LastClusterOf(task.cell) : 0;
}

absl::Status SceneTasks::AddHelp(NewTask& task) const {
  return task.stage == Stage::kAssemble ? written_.AddHelp(task) : absl::OkStatus();
}

absl::Status SceneTasks::Take(StageResult result) {
  const CellId cell = result.cell;
  const absl::Status status =
      std::visit(Overloaded{[&](v1::MeasureOutput& output) { return tiles_.Take(cell, output); },
                            [&](v1::SurveyOutput& output) {
                              return tiles_.Take(cell, SurveyedTileOf(std::move(output), std::move(result.record)));
                            },
                            [&](v1::GroundOutput& output) { return tiles_.Take(cell, output); },
                            [&](v1::SampleClusterOutput& output) { return samples_.Take(cell, output); },
                            [&](v1::SampleLayerOutput& output) { return samples_.Take(cell, output); },
                            [&](v1::FillOutput& output) { return fills_.Take(cell, std::move(output)); },
                            [&](v1::SmoothSeamOutput& output) { return seams_.Take(cell, output); },
                            [&](v1::AssembleOutput& output) { return written_.Take(cell, output); }},
                 result.output);
  if (status.ok() || result.stage == Stage::kSurvey || result.stage == Stage::kAssemble) return status;
  return UnreadableResult(cell, status);
}

}  // namespace tilemend
