#include "coordinator/state/demand.h"

namespace tilemend {

Demand DemandOf(const CoordinatorState& state) {
  Demand demand;
  for (const auto& [number, id] : state.running()) {
    const TaskCounts& counts = state.FindJob(id)->counts;
    ++demand.jobs;
    demand.tasks += counts.pending + counts.leased;
  }
  return demand;
}

}  // namespace tilemend
