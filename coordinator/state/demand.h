// How much work there is for workers, for whoever starts and stops them.
#ifndef TILEMEND_COORDINATOR_STATE_DEMAND_H_
#define TILEMEND_COORDINATOR_STATE_DEMAND_H_

#include <cstdint>

#include "coordinator/state/coordinator_state.h"

namespace tilemend {

struct Demand {
  int64_t jobs = 0;   // that are neither over nor paused; more tasks may come of them at any time
  int64_t tasks = 0;  // that wait for a worker or are with one
  bool operator==(const Demand&) const = default;
};

// O(jobs that run).
Demand DemandOf(const CoordinatorState& state);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_STATE_DEMAND_H_
