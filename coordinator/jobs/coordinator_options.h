// What a coordinator is started with.
#ifndef TILEMEND_COORDINATOR_JOBS_COORDINATOR_OPTIONS_H_
#define TILEMEND_COORDINATOR_JOBS_COORDINATOR_OPTIONS_H_

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "absl/time/time.h"
#include "common/rpc/limits.h"
#include "common/util/log.h"
#include "common/util/roots.h"
#include "coordinator/jobs/result_checks.h"
#include "coordinator/journal/journal.h"
#include "coordinator/state/coordinator_state.h"

namespace tilemend {

struct CoordinatorOptions {
  std::string work_folder;  // of this process alone; blobs go to work_folder/jobs/{id}; made if missing
  // Its jobs go on. Null: a journal that forgets, for a coordinator whose jobs end with it.
  std::shared_ptr<Journal> journal;
  absl::Duration lease = absl::Seconds(30);  // > 2 s: a worker calls at least once a second
  StateOptions state;                        // its epoch is that of the journal
  size_t max_running_jobs = 64;
  absl::Duration keep_jobs = absl::Hours(30 * 24);  // then a job that is over is forgotten; beyond 10,000 earlier
  // Never goes back. Default: the wall clock at construction plus a steady clock since.
  std::function<absl::Time()> clock;
  // Looks at every result before it is taken; none: all are.
  ResultCheck check_result = {};
  // The files to delete when a result is not accepted. Without it they stay until the job ends.
  AttemptsOf attempts_of = {};
  // BuildId(), or whatever else tells results that fit together from others: workers of another build are refused, and
  // what the journal knows of another build is not used.
  std::string build = {};
  int64_t most_sent = kMaxBlobBytes;  // bytes of blobs by one attempt
  // Looks for overdue leases in the background; without it only Tick does (tests).
  bool background_ticks = true;
  std::shared_ptr<const Roots> roots;  // that jobs may name files below; null: anywhere
  Log* log = Log::Null();              // outlives the coordinator
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_JOBS_COORDINATOR_OPTIONS_H_
