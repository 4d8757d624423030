#include "coordinator/service/stage_results.h"

#include "common/rpc/look_payloads.h"
#include "common/rpc/stage_payloads.h"
#include "common/util/status_macros.h"

namespace tilemend {

absl::StatusOr<SurveyedTile> SurveyedTileOf(const std::string& survey_output) {
  v1::SurveyOutput output;
  if (!output.ParseFromString(survey_output)) return absl::InvalidArgumentError("not the expected message");
  SurveyedTile tile;
  TILEMEND_ASSIGN_OR_RETURN(tile.record, FromProto(output));
  TILEMEND_ASSIGN_OR_RETURN(tile.files, FromProto(output.files()));
  tile.digest = output.digest();
  return tile;
}

absl::StatusOr<ClusterSamples> SamplesOf(const v1::SampleClusterOutput& output) {
  if (output.height_size() != output.seam_vertex_size() || output.laplacian_size() != output.seam_vertex_size() ||
      output.slope_x_size() != output.seam_vertex_size() || output.slope_y_size() != output.seam_vertex_size()) {
    return absl::InvalidArgumentError("columns of unequal length");
  }
  ClusterSamples samples{output.cluster(), {}, {}};
  for (int i = 0; i < output.height_size(); ++i) {
    samples.samples.push_back(
        {output.seam_vertex(i), output.height(i), output.laplacian(i), {output.slope_x(i), output.slope_y(i)}});
  }
  if (output.has_hold_out()) {
    TILEMEND_ASSIGN_OR_RETURN(samples.hold_out, FromProto(output.hold_out()));
  }
  return samples;
}

absl::StatusOr<std::vector<SeamSample>> SamplesOf(const v1::SampleLayerOutput& output, CellId cell) {
  if (output.height_size() != output.seam_vertex_size()) return absl::InvalidArgumentError("columns of unequal length");
  std::vector<SeamSample> samples;
  for (int i = 0; i < output.height_size(); ++i) samples.push_back({cell, output.seam_vertex(i), output.height(i)});
  return samples;
}

absl::StatusOr<CellPatches> PatchesOf(const v1::FillOutput& output) {
  CellPatches patches;
  for (const v1::PatchExtent& extent : output.patches()) {
    PatchExtent& patch = patches.patches.emplace_back();
    patch.hole = extent.hole();
    patch.failure = extent.failure();
    patch.new_vertices = extent.new_points();
    patch.triangles = extent.triangles();
    if (!v1::FillWay_IsValid(extent.way())) return absl::InvalidArgumentError("an unknown way of filling");
    patch.way = static_cast<FillWay>(extent.way());
    if (extent.has_hold_out()) {
      TILEMEND_ASSIGN_OR_RETURN(patch.hold_out, FromProto(extent.hold_out()));
    }
  }
  TILEMEND_ASSIGN_OR_RETURN(patches.quality, FromProto(output.quality()));
  return patches;
}

}  // namespace tilemend
