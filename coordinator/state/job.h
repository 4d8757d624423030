// Plain records of the coordinator's state: jobs, tasks, workers.
#ifndef TILEMEND_COORDINATOR_STATE_JOB_H_
#define TILEMEND_COORDINATOR_STATE_JOB_H_

#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "absl/time/time.h"
#include "common/grid/scene.h"
#include "common/util/stage.h"
#include "coordinator/state/given_results.h"

namespace tilemend {

enum class JobState { kRunning, kDone, kPartial, kFailed, kCancelled };

// "running", "done", "partial", "failed", "cancelled".
std::string_view JobStateName(JobState state);

inline bool IsOver(JobState state) { return state != JobState::kRunning; }

// How far a job is, as its pipeline tells it.
struct Progress {
  std::string phase;  // for people: "survey", "sample layer 2 of 3"
  int64_t cells = 0, cells_done = 0;
  int64_t holes = 0, holes_filled = 0;
  int64_t triangles = 0;   // new ones, of the holes that are filled
  int64_t taken_over = 0;  // results of an earlier job
  bool operator==(const Progress&) const = default;
};

// Pending -> leased -> one of the last three, which are final: the task is forgotten then. A lost lease goes back to
// pending.
enum class TaskState { kPending, kLeased, kCommitted, kFailed, kQuarantined };

inline bool IsSettled(TaskState state) { return state != TaskState::kPending && state != TaskState::kLeased; }

// A result that was not taken.
struct Refusal {
  std::string digest;
  std::string reason;  // for people; names the worker
};

// One attempt that may still bring a result.
struct Lease {
  uint64_t token = 0;  // not 0
  std::string worker;
  absl::Time since;
  absl::Time deadline;
  bool begun = false;  // the worker said that it is at it
};

struct Task {
  int64_t id = 0;  // 1, 2, ... within the job, in the order in which they were added
  CellId cell;
  Stage stage = Stage::kSurvey;
  std::string input;  // digest of the input blob
  TaskState state = TaskState::kPending;
  int32_t attempts = 0;                          // leases so far
  int32_t returns = 0;                           // attempts that the machine gave back with an error
  absl::Time not_before = absl::InfinitePast();  // when it may be given out again
  std::set<std::string> returned_by;             // who gave it back so, or was lost with it
  int32_t losses = 0;                            // leases that ended because a worker was lost
  std::vector<std::string> lost_workers;         // workers that were lost while they held it, each once
  std::string failed_by, failure;                // who said first that it cannot be done, and why
  std::map<std::string, Refusal> refused;        // by worker, until it is settled
  absl::Time refused_at = absl::InfinitePast();  // the last of them
  std::vector<Lease> leases;                     // one, or two if the first takes long
};

// Tells an attempt from others, in the few bytes that stay of a task.
inline uint64_t MarkOf(const std::string& worker, uint64_t token) { return token ^ std::hash<std::string>()(worker); }

// Null if that attempt is no lease of the task.
inline const Lease* FindLease(const Task& task, const std::string& worker, uint64_t token) {
  for (const Lease& lease : task.leases) {
    if (lease.token == token && lease.worker == worker) return &lease;
  }
  return nullptr;
}
// Null if the worker does not hold the task.
inline const Lease* LeaseOf(const Task& task, const std::string& worker) {
  for (const Lease& lease : task.leases) {
    if (lease.worker == worker) return &lease;
  }
  return nullptr;
}

// Names a task everywhere in the coordinator.
struct TaskKey {
  std::string job;
  int64_t task = 0;
  auto operator<=>(const TaskKey&) const = default;
};

inline constexpr size_t kMostWarnings = 20;

// Whether tasks of a stage are given out only after all other pending tasks of their job.
inline bool IsBackground(Stage stage) { return stage == Stage::kVerify; }

struct TaskCounts {
  int64_t added = 0;
  int64_t pending = 0, leased = 0, committed = 0, failed = 0, quarantined = 0;  // sum is `added` while the job runs
  int64_t retried = 0;       // leases that were lost or given back and led to another
  int64_t doubled = 0;       // second attempts beside one that took long
  int64_t refused_late = 0;  // results of attempts that had been given up
  int64_t settled() const { return committed + failed + quarantined; }
  // Attempts beside the first ones, as clients and the log tell of them.
  int64_t given_again() const { return retried + doubled; }
  // Of a job that begins again.
  TaskCounts WithoutTasks() const { return {.retried = retried, .doubled = doubled, .refused_late = refused_late}; }
  bool operator==(const TaskCounts&) const = default;
};

// Of the tasks that were committed.
struct StageTime {
  int64_t tasks = 0;
  absl::Duration total;
};

// Why an accepted result is wrong.
struct Disproof {
  std::string reason;         // for people
  bool others_do_it = false;  // other workers compute the results again
};

// What speaks against workers of a job.
struct Doubts {
  std::set<int64_t> tasks;                    // ids of those that are not settled and have refusals
  std::map<std::string, int64_t> refusals;    // how many of those each worker has
  std::map<std::string, Disproof> disproved;  // by worker
};

// Ids of the tasks in state kPending.
struct PendingTasks {
  std::set<int64_t> first, background;  // the second: those of IsBackground

  std::set<int64_t>& Of(Stage stage) { return IsBackground(stage) ? background : first; }
  size_t size() const { return first.size() + background.size(); }
};

struct Job {
  std::string id;
  std::string request_id;
  int64_t number = 0;  // 1, 2, ... in order of creation
  JobState state = JobState::kRunning;
  absl::Time created;
  absl::Time started = absl::InfiniteFuture();  // when its first task was given to a worker
  absl::Time ended = absl::InfiniteFuture();
  uint64_t version = 0;  // grows with each change of the job
  int32_t priority = 0;  // while it has tasks to give out, those of jobs with a lower one wait
  bool paused = false;   // none of its tasks is given out
  Progress progress;
  std::vector<std::string> warnings;  // each once, at most kMostWarnings
  TaskCounts counts;
  std::map<int64_t, Task> tasks;  // that are not settled; none when the job is over
  // By id - 1, of the tasks that are settled: MarkOf the attempt whose report did so, else 0.
  std::vector<uint64_t> settled_by;
  PendingTasks pending;
  std::set<std::pair<absl::Time, int64_t>> alone;  // tasks with one lease, since when
  Doubts doubts;
  std::map<Stage, StageTime> times;
  GivenResults given;  // the results that were accepted
};

struct WorkerRecord {
  std::string id;
  int32_t threads = 0;
  int32_t prefetch = 0;  // tasks that it would hold beyond its threads
  bool draining = false;
  absl::Time last_seen;
  std::set<TaskKey> held;
  int32_t troubles = 0;                           // attempts that failed by its machine since one that did not
  absl::Time rests_until = absl::InfinitePast();  // gets nothing before
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_STATE_JOB_H_
