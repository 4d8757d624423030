// What the coordinator must not forget: its jobs, and the results of tasks that it has committed.
//
// A pipeline is a function of the spec and of the tasks' results. So that is all there is to keep: after a restart the
// pipeline of a job that is not over runs again from its beginning, and each task whose result is here is answered from
// here instead of by a worker. Leases, workers and progress are not kept.
//
// The rule: what is put here takes effect in memory at once, and nobody hears of it before Await has returned. So
// whatever anybody has heard of is still true after a crash.
#ifndef TILEMEND_COORDINATOR_JOURNAL_JOURNAL_H_
#define TILEMEND_COORDINATOR_JOURNAL_JOURNAL_H_

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "common/grid/scene.h"
#include "common/util/stage.h"
#include "coordinator/state/job.h"

namespace tilemend {

struct JobRecord {
  int64_t number = 0;           // names the job here
  std::string request_id = {};  // as the client chose it
  std::string body = {};        // the job as it is told to clients; the journal does not look into it
  bool over = false;            // its results are not needed any more
  bool released = false;        // over, and its output holds nothing of it that is in the way of others
  bool damaged = false;         // what is here is not what was put; the number is right
};

// A worker that gets no task any more.
struct SetAsideRecord {
  std::string worker;
  std::string reason;  // empty: it gets tasks again
  bool operator==(const SetAsideRecord&) const = default;
};

// Names a task by what it is asked, over all restarts of its job.
struct TaskName {
  CellId cell;
  Stage stage = Stage::kSurvey;
  std::string input;  // 64 hexadecimal digits that stand for what is asked
  bool operator==(const TaskName&) const = default;
};

// What is known of a task: how it was settled, or kPending and the workers that were lost with it so far.
struct ResultRecord {
  TaskState state = TaskState::kCommitted;
  std::string output = {};                  // kCommitted: digest of the output
  std::optional<std::string> content = {};  // the output itself, unless it is a blob in the job's folder
  std::string error = {};                   // kFailed, kQuarantined: why; the journal does not look into it
  std::vector<std::string> lost_workers = {};
  std::string worker = {};  // kCommitted: who gave it; "" where that is not known
  bool operator==(const ResultRecord&) const = default;
};

// Thread-safe. No call waits for the disk but Await, Find and Outputs.
class Journal {
 public:
  virtual ~Journal() = default;

  // How many times it has been opened: larger than in any earlier process that held it, at least 1.
  virtual uint32_t epoch() const = 0;
  // The jobs as they were when it was opened, the oldest first. Once.
  virtual std::vector<JobRecord> TakeJobs() = 0;

  // Puts a job in, or in the place of what is there of that number.
  virtual void PutJob(JobRecord job) = 0;
  virtual void PutResult(int64_t job, TaskName task, ResultRecord result) = 0;
  // Of a job that is over: it was never there.
  virtual void DropJob(int64_t job) = 0;
  // As they were when it was opened. Once.
  virtual std::vector<SetAsideRecord> TakeSetAside() = 0;
  virtual void PutSetAside(SetAsideRecord record) = 0;
  // Waits until all that was put before is durable. A journal that cannot be written ends the process: nobody can know
  // what of it is on the disk.
  virtual void Await() = 0;

  // Forgets the results that the worker gave in the job.
  virtual void DropResults(int64_t job, const std::string& worker) = 0;

  // What an earlier process put last for this task; none if it put nothing. kDataLoss if it is damaged. After ReadAgain
  // also what this process had put before that.
  virtual absl::StatusOr<std::optional<ResultRecord>> Find(int64_t job, const TaskName& task) = 0;
  // The digests of the outputs, of what an earlier process put, that are blobs in the job's folder; also of what it put
  // anew later. kDataLoss.
  virtual absl::StatusOr<std::vector<std::string>> Outputs(int64_t job) = 0;

  // From now on Find knows what was put for the job so far. Waits as Await does. Cost O(results of all jobs).
  virtual absl::Status ReadAgain(int64_t /*job*/) {
    Await();  // which is all for a journal whose Find reads what is there
    return absl::OkStatus();
  }

  // Whether anything outlives the process. If not, nothing else needs to.
  virtual bool is_durable() const = 0;
};

// Forgets everything: for a coordinator that ends with its only job.
std::unique_ptr<Journal> NewForgetfulJournal();

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_JOURNAL_JOURNAL_H_
