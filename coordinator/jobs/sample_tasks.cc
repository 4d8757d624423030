#include "coordinator/jobs/sample_tasks.h"

#include "common/rpc/stage_payloads.h"
#include "common/util/status_macros.h"
#include "coordinator/waves/local_numbers.h"

namespace tilemend {

absl::StatusOr<NewTask> SampleTasks::TaskOf(ClusterWork& work) {
  v1::SampleClusterInput input;
  const int32_t number = clusters_of_[work.holes.cell]++;
  clusters_[{work.holes.cell, number}] = {work.cluster, Localise(work.holes).seam_vertices};
  input.set_cluster(number);
  *input.mutable_holes() = ToProto(work.holes);
  *input.mutable_options() = options_;
  return NewTask{work.holes.cell, Stage::kSampleCluster, input.SerializeAsString()};
}

absl::StatusOr<NewTask> SampleTasks::TaskOf(LayerWork& work) {
  v1::SampleLayerInput input;
  layers_[work.holes.cell] = Localise(work.holes).seam_vertices;
  *input.mutable_holes() = ToProto(work.holes);
  return NewTask{work.holes.cell, Stage::kSampleLayer, input.SerializeAsString()};
}

absl::Status SampleTasks::Take(CellId cell, const v1::SampleClusterOutput& output) {
  const auto asked = clusters_.extract({cell, output.cluster()});
  if (asked.empty()) return absl::InvalidArgumentError("a cluster that was not asked for");
  TILEMEND_ASSIGN_OR_RETURN(ClusterSamples samples, SamplesOf(output, asked.mapped()));
  return waves_.Take(std::move(samples));
}

absl::Status SampleTasks::Take(CellId cell, const v1::SampleLayerOutput& output) {
  TILEMEND_ASSIGN_OR_RETURN(auto samples, SamplesOf(output, cell, layers_[cell]));
  return waves_.Take(LayerSamples{std::move(samples)});
}

}  // namespace tilemend
