// The coordinator as a scaler for KEDA: what there is to do, in KEDA's words (proto/externalscaler).
//
// There is one metric, the tasks that wait or run. A worker's share of it is the number of tasks that it takes at once,
// which the trigger gives as `slots`. So the workers wanted are the tasks divided by the slots of a worker.
#ifndef TILEMEND_COORDINATOR_API_SCALER_H_
#define TILEMEND_COORDINATOR_API_SCALER_H_

#include "absl/status/statusor.h"
#include "coordinator/state/demand.h"
#include "externalscaler/externalscaler.pb.h"

namespace tilemend {

inline constexpr char kScalerMetric[] = "tilemend-tasks";

// kInvalidArgument (INVALID_SCALER) for slots that are no whole number from 1 to 1024.
absl::StatusOr<externalscaler::GetMetricSpecResponse> ScalerSpec(const externalscaler::ScaledObjectRef& object);

// kInvalidArgument (INVALID_SCALER) for a name other than kScalerMetric or none.
absl::StatusOr<externalscaler::GetMetricsResponse> ScalerMetrics(const externalscaler::GetMetricsRequest& request,
                                                                 const Demand& demand);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_API_SCALER_H_
