// Everything that can happen to the coordinator's state. An event carries every decision and the time, so that the same
// events give the same state.
#ifndef TILEMEND_COORDINATOR_STATE_EVENT_H_
#define TILEMEND_COORDINATOR_STATE_EVENT_H_

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "absl/status/status.h"
#include "absl/time/time.h"
#include "coordinator/state/job.h"

namespace tilemend {

struct JobCreated {
  std::string job;
  std::string request_id;  // may be empty
  absl::Time time;
};

struct TaskSpec {
  CellId cell;
  Stage stage = Stage::kSurvey;
  std::string input;  // digest of the input blob
};

struct TasksAdded {
  std::string job;
  std::vector<TaskSpec> tasks;
};

// A worker called.
struct WorkerSeen {
  std::string worker;
  int32_t threads = 1;
  bool draining = false;
  absl::Time time;
};

struct TaskLeased {
  TaskKey key;
  std::string worker;
  uint64_t token = 0;  // larger than any before
  absl::Time time;
  absl::Time deadline;
};

struct LeaseRenewed {
  TaskKey key;
  uint64_t token = 0;
  absl::Time deadline;
};

struct TaskCompleted {
  TaskKey key;
  uint64_t token = 0;
  std::string output;  // digest of the output blob
};

struct TaskFailed {
  TaskKey key;
  uint64_t token = 0;
  bool machine = false;  // the machine's failure, not the cell's: another attempt is worth it
  absl::Status error;    // not OK
};

// The holder did not renew in time: as if the worker was lost, for this task alone.
struct LeaseExpired {
  TaskKey key;
  uint64_t token = 0;
};

// The worker died or was cut off. Counts against every task that it held.
struct WorkerLost {
  std::string worker;
};

// The worker went away in good order. What it still held goes back without counting.
struct WorkerLeft {
  std::string worker;
};

struct JobProgressed {
  std::string job;
  Progress progress;
};

struct JobCancelled {
  std::string job;
  absl::Time time;
};

// `state` is kDone, kPartial or kFailed. kDone becomes kPartial if tasks were quarantined.
struct JobFinished {
  std::string job;
  JobState state = JobState::kDone;
  absl::Time time;
};

using Event = std::variant<JobCreated, TasksAdded, WorkerSeen, TaskLeased, LeaseRenewed, TaskCompleted, TaskFailed,
                           LeaseExpired, WorkerLost, WorkerLeft, JobProgressed, JobCancelled, JobFinished>;

// A task that an event brought to its end. Every task of a job that is not cut short is settled exactly once.
struct SettledTask {
  TaskKey key;
  CellId cell;
  Stage stage = Stage::kSurvey;
  TaskState state = TaskState::kCommitted;
  std::string output;    // kCommitted: digest
  absl::Status error;    // kFailed, kQuarantined (kAborted, QUARANTINED): why
  absl::Time leased_at;  // of the attempt that settled it
};

// What an event led to.
struct Effects {
  std::vector<SettledTask> settled;
  std::vector<Stage> retried;  // one for each task that went back to pending
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_STATE_EVENT_H_
