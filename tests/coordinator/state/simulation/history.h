// One history of a simulated cluster: jobs, faults for a while, then a calm time in which every job comes to its end.
#ifndef TILEMEND_TESTS_COORDINATOR_STATE_SIMULATION_HISTORY_H_
#define TILEMEND_TESTS_COORDINATOR_STATE_SIMULATION_HISTORY_H_

#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "tests/coordinator/state/simulation/coordinator.h"

namespace tilemend::simulation {

struct HistoryResult {
  std::vector<std::string> broken;  // what must never be
  Tally tally;
  int jobs = 0, done = 0, partial = 0, cancelled = 0, failed = 0;
  std::set<std::string> set_aside;  // workers that were set aside
};

// Each fault in some histories and not in others.
Faults FaultsOf(uint64_t seed);

// The same seed and faults give the same history, on every machine.
HistoryResult RunHistory(uint64_t seed, const Faults& faults);

}  // namespace tilemend::simulation

#endif  // TILEMEND_TESTS_COORDINATOR_STATE_SIMULATION_HISTORY_H_
