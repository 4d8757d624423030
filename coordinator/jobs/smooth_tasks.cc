#include "coordinator/jobs/smooth_tasks.h"

#include "common/options/method_options.h"
#include "common/rpc/smoothed_payloads.h"
#include "common/rpc/stage_payloads.h"
#include "common/util/status_macros.h"
#include "coordinator/jobs/scratch_messages.h"
#include "coordinator/waves/local_numbers.h"

namespace tilemend {
namespace {

int64_t NewPointsOf(const v1::FillOutput& output) {
  int64_t count = 0;
  for (const v1::PatchExtent& extent : output.patches()) count += extent.new_points();
  return count;
}

}  // namespace

SmoothTasks::SmoothTasks(const JobSpec& spec, SceneWaves& waves, std::shared_ptr<ScratchFile> scratch,
                         const FillTasks& fills)
    : spec_(spec), waves_(waves), scratch_(std::move(scratch)), fills_(fills) {}

absl::StatusOr<NewTask> SmoothTasks::TaskOf(SmoothWork& work) {
  const CellId cell = work.sides[0].cell;
  v1::SmoothSeamInput input;
  last_seam_ = work.number;
  input.set_number(work.number);
  seams_[{cell, work.number}] = {work.cells, work.vertices, {}};
  const LocalNumbers numbers = Localise(work.sides[0], work.sides[1]);
  TILEMEND_ASSIGN_OR_RETURN(*input.mutable_a(), SideOf(work.sides[0], work.holes[0]));
  TILEMEND_ASSIGN_OR_RETURN(*input.mutable_b(), SideOf(work.sides[1], work.holes[1]));
  for (size_t i = 0; i < work.vertices.size(); ++i) {
    input.add_seam_vertex(LocalNumber(numbers.seam_vertices, work.vertices[i]));
    input.add_height(work.heights[i]);
  }
  const WangOptions wang = WangOptionsOf(spec_);
  input.set_smoothing(wang.seam_smoothing);
  input.set_buffer(wang.seam_buffer);
  input.set_lattice_step(work.sides[0].lattice_step);
  return NewTask{cell, Stage::kSmoothSeam, input.SerializeAsString()};
}

absl::StatusOr<v1::SeamSide> SmoothTasks::SideOf(const CellHoles& cell, const std::vector<int32_t>& holes) {
  v1::SeamSide side;
  *side.mutable_vertices() = ToProto(cell.vertices);
  TILEMEND_ASSIGN_OR_RETURN(*side.mutable_patches(), fills_.PatchesOf(cell.cell));
  for (const int32_t hole : holes) side.add_holes(LocalNumber(fills_.HolesOf(cell.cell), hole));
  return side;
}

absl::Status SmoothTasks::Take(CellId cell, const v1::SmoothSeamOutput& output) {
  auto asked = seams_.extract({cell, output.number()});
  if (asked.empty()) return absl::InvalidArgumentError("a seam that was not asked for");
  SmoothedSeam& seam = asked.mapped();
  seam.heights.assign(output.height().begin(), output.height().end());
  for (const auto& [side, points] : {std::pair(seam.cells[0], &output.a()), std::pair(seam.cells[1], &output.b())}) {
    ScratchFile::Place& place = smoothed_[side][{seam.cells[0], seam.cells[1]}];
    TILEMEND_ASSIGN_OR_RETURN(place, WriteMessage(*scratch_, *points));
  }
  return waves_.Take(std::move(seam));
}

absl::StatusOr<std::vector<std::vector<SmoothedPoint>>> SmoothTasks::MovePoints(CellId cell, v1::AssembleInput& input) {
  std::vector<std::vector<SmoothedPoint>> moves;
  for (const auto& [seam, place] : smoothed_[cell]) {
    TILEMEND_ASSIGN_OR_RETURN(v1::SmoothedPoints points, ReadMessage<v1::SmoothedPoints>(*scratch_, place));
    TILEMEND_ASSIGN_OR_RETURN(moves.emplace_back(), FromProto(points, NewPointsOf(input.patches())));
    *input.add_smoothed() = std::move(points);
  }
  smoothed_.erase(cell);
  return moves;
}

}  // namespace tilemend
