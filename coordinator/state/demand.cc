#include "coordinator/state/demand.h"

namespace tilemend {

Demand DemandOf(const CoordinatorState& state) {
  Demand demand;
  for (const auto& [number, id] : state.running()) {
    const Job& job = *state.FindJob(id);
    if (job.paused && job.counts.leased == 0) continue;
    ++demand.jobs;
    demand.tasks += (job.paused ? 0 : job.counts.pending) + job.counts.leased;
  }
  return demand;
}

}  // namespace tilemend
