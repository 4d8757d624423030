#include "coordinator/jobs/fill_tasks.h"

#include <utility>

#include "common/options/job_options.h"
#include "common/records/patch_heights.h"
#include "common/rpc/smoothed_payloads.h"
#include "common/rpc/stage_payloads.h"
#include "common/util/status_macros.h"
#include "coordinator/jobs/scratch_messages.h"
#include "coordinator/jobs/stage_results.h"
#include "coordinator/waves/local_numbers.h"

namespace tilemend {

absl::Status AddToGaps(CellId cell, const v1::RimVertices& rims, const v1::FillOutput& output,
                       std::span<const std::vector<SmoothedPoint>> moves, SceneWaves& waves) {
  if (!waves.fill_gaps().Wants(cell)) return absl::OkStatus();
  TILEMEND_ASSIGN_OR_RETURN(const std::vector<RimVertex> vertices, FromProto(rims));
  TILEMEND_ASSIGN_OR_RETURN(std::vector<HolePatch> patches, FromProto(output, vertices.size()));
  MoveSmoothedPoints(moves, waves.plan().lattice_step, patches);
  waves.fill_gaps().Take(cell, vertices, patches);
  return absl::OkStatus();
}

FillTasks::FillTasks(const v1::JobSpec& options, SceneWaves& waves, std::shared_ptr<ScratchFile> scratch,
                     const TileTasks& tiles)
    : options_(options), waves_(waves), scratch_(std::move(scratch)), tiles_(tiles) {}

absl::StatusOr<NewTask> FillTasks::TaskOf(FillWork& work) {
  v1::FillInput input;
  CellHoles none;
  LocalNumbers numbers = Localise(work.holes, work.sampled ? *work.sampled : none);
  holes_[work.holes.cell] = std::move(numbers.holes);
  if (work.sampled) {
    sampled_[work.holes.cell] = std::move(numbers.seam_vertices);
    *input.mutable_sampled() = ToProto(*work.sampled);
  }
  *input.mutable_holes() = ToProto(work.holes);
  *input.mutable_options() = options_;
  for (const SceneTile* tile : work.surface) {
    TILEMEND_ASSIGN_OR_RETURN(*input.add_surface(), tiles_.Ref(*tile));
  }
  TILEMEND_ASSIGN_OR_RETURN(rims_[work.holes.cell], WriteMessage(*scratch_, ToProto(work.holes.vertices)));
  return NewTask{work.holes.cell, Stage::kFill, input.SerializeAsString()};
}

absl::Status FillTasks::Take(CellId cell, v1::FillOutput output) {
  TILEMEND_ASSIGN_OR_RETURN(CellPatches patches, tilemend::PatchesOf(output, holes_[cell]));
  if (output.has_samples()) {
    TILEMEND_ASSIGN_OR_RETURN(patches.samples, SamplesOf(output.samples(), cell, sampled_[cell]));
    sampled_.erase(cell);
  }
  if (options_.surface() != SurfaceName(Surface::kWang)) {
    TILEMEND_ASSIGN_OR_RETURN(const v1::RimVertices rims, RimsOf(cell));
    TILEMEND_RETURN_IF_ERROR(AddToGaps(cell, rims, output, {}, waves_));
  }
  output.clear_quality();
  output.clear_samples();
  TILEMEND_ASSIGN_OR_RETURN(patches_[cell], WriteMessage(*scratch_, output));
  return waves_.Take(CellFill{cell, std::move(patches)});
}

absl::StatusOr<v1::FillOutput> FillTasks::PatchesOf(CellId cell) const {
  return ReadMessage<v1::FillOutput>(*scratch_, patches_.at(cell));
}

absl::StatusOr<v1::RimVertices> FillTasks::RimsOf(CellId cell) const {
  return ReadMessage<v1::RimVertices>(*scratch_, rims_.at(cell));
}

void FillTasks::Release(CellId cell) {
  rims_.erase(cell);
  holes_.erase(cell);
  patches_.erase(cell);
}

}  // namespace tilemend
