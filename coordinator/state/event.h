// Everything that can happen to the coordinator's state. An event carries every decision and the time, so that the same
// events give the same state.
#ifndef TILEMEND_COORDINATOR_STATE_EVENT_H_
#define TILEMEND_COORDINATOR_STATE_EVENT_H_

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
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
  int32_t priority = 0;
};

// A job as an earlier process knew it. Its tasks are added anew.
struct JobRestored {
  Job job;  // without tasks, pending or counts of tasks unless it is over; its number is larger than any before
};

// How a task was settled in an earlier process.
struct KnownResult {
  TaskState state = TaskState::kCommitted;  // a settled one
  std::string output;                       // kCommitted: digest of the output blob
  absl::Status error;                       // kFailed, kQuarantined: why
  std::string worker = {};                  // kCommitted: who gave it; "" if not known
};

struct TaskSpec {
  CellId cell;
  Stage stage = Stage::kSurvey;
  std::string input;                           // digest of the input blob
  std::optional<KnownResult> known = {};       // then it is settled as soon as it is added
  std::vector<std::string> lost_workers = {};  // in earlier processes, fewer than make a quarantine
  std::vector<std::string> avoid = {};         // workers that get it only if no other may have it
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
  int32_t prefetch = 0;  // tasks that it would hold beyond its threads
};

// Of a pending task, or a second attempt by another worker than the first.
struct TaskLeased {
  TaskKey key;
  std::string worker;
  uint64_t token = 0;  // random and not 0, so that nobody guesses it
  absl::Time time;
  absl::Time deadline;
};

struct LeaseRenewed {
  TaskKey key;
  std::string worker;
  uint64_t token = 0;
  absl::Time deadline;
  bool begun = false;  // the worker says that it is at it
};

struct TaskCompleted {
  TaskKey key;
  std::string worker;
  uint64_t token = 0;
  std::string output;  // digest of the output blob
  absl::Time time;
};

struct TaskFailed {
  TaskKey key;
  std::string worker;
  uint64_t token = 0;
  bool machine = false;  // the machine's failure, not the cell's: another attempt is worth it
  bool another = false;  // there is a worker that may have it, has not given it back and was not refused with it
  absl::Status error;    // not OK
  absl::Time time;
  // The digest of a result that was refused, else empty; then `error` names the worker and says what was wrong.
  std::string refused = {};
};

// Nobody is left that may have a task of which results were refused.
struct TaskAbandoned {
  TaskKey key;
};

// The holder did not renew in time: as if the worker was lost, for this task alone. Does not count against it if the
// worker had begun others that it still holds, and not this one.
struct LeaseExpired {
  TaskKey key;
  std::string worker;
  uint64_t token = 0;
};

// The worker died or was cut off. Counts against the tasks that it had begun; if it told of none, against all that it
// held.
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

// Something that a user should know of the job.
struct JobWarned {
  std::string job;
  std::string warning;
};

// A job is to have another priority, to pause or to go on.
struct JobSteered {
  std::string job;
  std::optional<int32_t> priority = {};
  std::optional<bool> paused = {};
};

struct JobCancelled {
  std::string job;
  absl::Time time;
};

// A job that is over is of interest to nobody any more.
struct JobForgotten {
  std::string job;
};

// An accepted result of the worker is wrong.
struct WorkerDisproved {
  std::string job;
  std::string worker;
  std::string reason;    // for people
  bool another = false;  // another worker may have tasks of the job
};

// The job begins again from its first task, after results of it were revoked.
struct JobRedone {
  std::string job;
};

// `state` is kDone, kPartial or kFailed. kDone becomes kPartial if tasks were quarantined.
struct JobFinished {
  std::string job;
  JobState state = JobState::kDone;
  absl::Time time;
};

using Event = std::variant<JobCreated, JobRestored, TasksAdded, WorkerSeen, TaskLeased, LeaseRenewed, TaskCompleted,
                           TaskFailed, TaskAbandoned, LeaseExpired, WorkerLost, WorkerLeft, JobProgressed, JobWarned,
                           JobSteered, JobCancelled, WorkerDisproved, JobRedone, JobFinished, JobForgotten>;

// A task that an event brought to its end. Every task of a job that is not cut short is settled exactly once.
struct SettledTask {
  TaskKey key;
  CellId cell;
  Stage stage = Stage::kSurvey;
  std::string input;  // digest
  TaskState state = TaskState::kCommitted;
  std::string output;    // kCommitted: digest
  std::string worker;    // kCommitted: who gave it; "" if not known
  absl::Status error;    // kFailed, kQuarantined (kAborted, QUARANTINED): why
  bool known = false;    // the result is of an earlier process
  absl::Time leased_at;  // of the attempt that settled it, unless known
};

// Without what it is a result of.
inline SettledTask SettledAs(KnownResult result) {
  SettledTask settled;
  settled.state = result.state;
  settled.output = std::move(result.output);
  settled.error = std::move(result.error);
  settled.worker = std::move(result.worker);
  return settled;
}

// A task that counts a worker that was lost with it, and is not settled.
struct StruckTask {
  TaskKey key;
  CellId cell;
  Stage stage = Stage::kSurvey;
  std::string input;                      // digest
  std::vector<std::string> lost_workers;  // all so far
};

// A worker whose result was refused.
struct Blamed {
  std::string worker;
  std::string reason;  // for people
};

// A worker that said a task cannot be done, which then was.
struct Contradicted {
  TaskKey key;
  CellId cell;
  Stage stage = Stage::kSurvey;
  std::string worker;
  std::string reason;  // what it said
  std::string by;      // who did it
};

// All results of a worker in a job. They are to be computed again.
struct Revoked {
  std::string job;
  std::string worker;
  std::vector<int64_t> tasks;  // ids; may be empty
};

// What an event led to.
struct Effects {
  std::vector<SettledTask> settled;
  std::vector<Stage> retried;  // one for each task that went back to pending
  std::vector<StruckTask> struck;
  std::vector<StruckTask> relieved;  // they count a worker less, which has come back
  std::vector<Contradicted> contradicted;
  // Who is to get no task until it is cleared: the first worker whose result a job refuses.
  std::vector<Blamed> suspected;
  // Who is to get no task any more: another worker has done the same task well.
  std::vector<Blamed> set_aside;
  // Who is suspected no more, unless it was set aside: what it was suspected of was the job's fault, or is of no
  // interest any more.
  std::vector<std::string> cleared;
  // Results of workers that were set aside or disproved, in jobs that are not over. The job is to begin again without
  // them (JobRedone).
  std::vector<Revoked> revoked;
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_STATE_EVENT_H_
