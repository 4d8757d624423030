// What the coordinator's state consists of.
#ifndef TILEMEND_COORDINATOR_STATE_STATE_TABLES_H_
#define TILEMEND_COORDINATOR_STATE_STATE_TABLES_H_

#include <cstdint>
#include <map>
#include <string>

#include "absl/time/time.h"
#include "coordinator/state/job.h"
#include "coordinator/state/job_table.h"

namespace tilemend {

struct StateOptions {
  int32_t quarantine_after = 3;  // >= 1, lost workers; or three times as many losses with fewer
  absl::Duration longest_attempt = absl::InfiniteDuration();  // then the lease ends, however often it is renewed
  int32_t max_refusals = 3;                                   // >= 1, workers whose results were refused
  // So long a task waits for a worker when all that there are failed with it, or their results were refused.
  absl::Duration wait_for_another = absl::Seconds(10);
  // >= 1, machine errors reported by living workers before one counts as the task's own, unless there is a worker left
  // that has not given it back; or three times as many.
  int32_t max_returns = 3;
  absl::Duration first_pause = absl::Milliseconds(250);  // after a machine error; doubles with each
  absl::Duration longest_pause = absl::Seconds(30);
  // A second attempt is worth it when the first takes this many times the mean of its job and stage, and this long.
  double straggler_factor = 3;
  absl::Duration least_straggling = absl::Seconds(1);
  // Versions of jobs start at epoch << 32. A coordinator that starts anew takes a larger epoch: its jobs are news to
  // whoever watched them before.
  uint32_t epoch = 0;
};

struct StateTables {
  StateOptions options;
  JobTable jobs;
  std::map<std::string, WorkerRecord> workers;
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_STATE_STATE_TABLES_H_
