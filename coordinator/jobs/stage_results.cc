#include "coordinator/jobs/stage_results.h"

#include "common/rpc/look_payloads.h"
#include "common/rpc/stage_payloads.h"
#include "common/rpc/surface_payloads.h"
#include "common/util/status_macros.h"
#include "coordinator/waves/local_numbers.h"

namespace tilemend {

namespace {

absl::StatusOr<int32_t> PlanNumber(const std::vector<int32_t>& numbers, int32_t local) {
  const std::optional<int32_t> number = InPlan(numbers, local);
  if (!number) return absl::InvalidArgumentError("a number that was not asked for");
  return *number;
}

}  // namespace

absl::StatusOr<SurveyedTile> SurveyedTileOf(v1::SurveyOutput output, std::optional<SurveyRecord> record) {
  SurveyedTile tile;
  if (record) {
    tile.record = *std::move(record);
  } else {
    TILEMEND_ASSIGN_OR_RETURN(tile.record, FromProto(output));
  }
  TILEMEND_ASSIGN_OR_RETURN(tile.files, FromProto(output.files()));
  tile.digest = output.digest();
  tile.stamp = output.stamp();
  tile.cleared.assign(output.cleared().begin(), output.cleared().end());
  for (const int32_t nodes : output.level_nodes()) {
    if (nodes < 0) return absl::InvalidArgumentError("malformed payload: nodes of a level below 0");
    tile.levels.push_back({nodes, 0, 0, 0});
  }
  tile.lowest = std::move(*output.mutable_lowest());
  for (const v1::FileRead& read : output.witness().reads()) tile.reads.push_back({read.path(), read.digest()});
  return tile;
}

absl::StatusOr<ClusterSamples> SamplesOf(const v1::SampleClusterOutput& output, const AskedCluster& asked) {
  if (output.height_size() != output.seam_vertex_size() || output.laplacian_size() != output.seam_vertex_size() ||
      output.slope_x_size() != output.seam_vertex_size() || output.slope_y_size() != output.seam_vertex_size()) {
    return absl::InvalidArgumentError("columns of unequal length");
  }
  ClusterSamples samples{asked.cluster, {}, {}};
  for (int i = 0; i < output.height_size(); ++i) {
    TILEMEND_ASSIGN_OR_RETURN(const int32_t vertex, PlanNumber(asked.seam_vertices, output.seam_vertex(i)));
    samples.samples.push_back({vertex, output.height(i), output.laplacian(i), {output.slope_x(i), output.slope_y(i)}});
  }
  if (output.has_hold_out()) {
    TILEMEND_ASSIGN_OR_RETURN(samples.hold_out, FromProto(output.hold_out()));
  }
  return samples;
}

absl::StatusOr<std::vector<SeamSample>> SamplesOf(const v1::SampleLayerOutput& output, CellId cell,
                                                  const std::vector<int32_t>& seam_vertices) {
  if (output.height_size() != output.seam_vertex_size()) return absl::InvalidArgumentError("columns of unequal length");
  std::vector<SeamSample> samples;
  for (int i = 0; i < output.height_size(); ++i) {
    TILEMEND_ASSIGN_OR_RETURN(const int32_t vertex, PlanNumber(seam_vertices, output.seam_vertex(i)));
    samples.push_back({cell, vertex, output.height(i)});
  }
  return samples;
}

absl::StatusOr<CellPatches> PatchesOf(const v1::FillOutput& output, const std::vector<int32_t>& holes) {
  CellPatches patches;
  for (const v1::PatchExtent& extent : output.patches()) {
    PatchExtent& patch = patches.patches.emplace_back();
    TILEMEND_ASSIGN_OR_RETURN(patch.hole, PlanNumber(holes, extent.hole()));
    patch.failure = extent.failure();
    patch.new_vertices = extent.new_points();
    patch.triangles = extent.triangles();
    if (!v1::FillWay_IsValid(extent.way())) return absl::InvalidArgumentError("an unknown way of filling");
    patch.way = static_cast<FillWay>(extent.way());
    if (extent.loop_cuts() < 0 || extent.creases() < 0 || extent.creases() / 3 > extent.triangles() ||
        extent.crossings() < 0 || extent.crossings() > extent.triangles()) {
      return absl::InvalidArgumentError("counts that no patch has");
    }
    patch.loop_cuts = extent.loop_cuts();
    patch.creases = extent.creases();
    patch.crossings = extent.crossings();
    patch.rim_is_crossed = extent.rim_is_crossed();
    if (extent.has_hold_out()) {
      TILEMEND_ASSIGN_OR_RETURN(patch.hold_out, FromProto(extent.hold_out()));
    }
  }
  TILEMEND_ASSIGN_OR_RETURN(patches.quality, FromProto(output.quality()));
  return patches;
}

}  // namespace tilemend
