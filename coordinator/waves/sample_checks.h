// Whether samples of workers can be those of a plan.
#ifndef TILEMEND_COORDINATOR_WAVES_SAMPLE_CHECKS_H_
#define TILEMEND_COORDINATOR_WAVES_SAMPLE_CHECKS_H_

#include <cstdint>
#include <span>

#include "absl/status/status.h"
#include "coordinator/plan/seam/seam_heights.h"
#include "coordinator/plan/types/plan_types.h"

namespace tilemend {

// kInvalidArgument for a vertex that is not in the plan and for a height, Laplacian or slope that is no number.
absl::Status CheckSample(const Plan& plan, int32_t vertex, double height);
absl::Status CheckSamples(const Plan& plan, std::span<const SeamSample> samples);
absl::Status CheckSamples(const Plan& plan, std::span<const ClusterSample> samples);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_WAVES_SAMPLE_CHECKS_H_
