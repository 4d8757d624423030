// Calls on the cluster as a whole: its workers, and what there is to do.
#ifndef TILEMEND_COORDINATOR_API_CLUSTER_HANDLER_H_
#define TILEMEND_COORDINATOR_API_CLUSTER_HANDLER_H_

#include "absl/status/statusor.h"
#include "coordinator/jobs/cluster.h"
#include "coordinator/state/demand.h"
#include "tilemend/v1/jobs.pb.h"

namespace tilemend {

// Thread-safe; every call is short.
class ClusterHandler {
 public:
  // `cluster` must outlive this.
  explicit ClusterHandler(Cluster& cluster) : cluster_(cluster) {}

  // kInvalidArgument (INVALID_PAGE).
  absl::StatusOr<v1::ListWorkersResponse> ListWorkers(const v1::ListWorkersRequest& request);
  // What there is for workers to do.
  Demand DemandNow();

 private:
  Cluster& cluster_;
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_API_CLUSTER_HANDLER_H_
