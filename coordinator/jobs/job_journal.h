// Jobs and results of tasks in the journal.
#ifndef TILEMEND_COORDINATOR_JOBS_JOB_JOURNAL_H_
#define TILEMEND_COORDINATOR_JOBS_JOB_JOURNAL_H_

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "coordinator/jobs/cluster.h"
#include "coordinator/state/event.h"
#include "coordinator/store/job_notes.h"
#include "tilemend/v1/jobs.pb.h"

namespace tilemend {

// A larger output is in the journal by its digest: its bytes are a blob in the job's folder before it is put.
inline constexpr size_t kMostJournalledBytes = size_t{32} << 10;

// Puts what changed into the journal of a cluster, and finds there what an earlier process put. The methods that put
// need the lock and do nothing if the journal forgets everything.
class JobJournal {
 public:
  // `cluster` must outlive this.
  explicit JobJournal(Cluster& cluster) : cluster_(cluster) {}

  // The job as it is now, or as `message` tells it. `released`: its output holds nothing that is in the way of others.
  void PutJob(const Job& job, bool released, std::optional<v1::Job> message = std::nullopt) const;
  void PutResult(const SettledTask& task, const std::optional<std::string>& content) const;
  // A worker was lost with the task.
  void PutLoss(const StruckTask& task) const;

  // What a worker gave in a job is to be done again.
  void DropResults(const Revoked& revoked) const;

  // Adds to `tasks` what earlier processes know of them, but for results of workers that are set aside. Returns the
  // contents of the known ones in order. Takes the lock. kDataLoss if the journal is damaged.
  absl::StatusOr<TaskContents> Recall(const std::string& job, std::vector<TaskSpec>& tasks) const;

  // Notes that are results of no task: those that a worker gave are dropped with its results. Needs the lock.
  std::shared_ptr<JobNotes> NotesOf(const std::string& job) const;

 private:
  // Takes the lock.
  bool IsOfSetAside(const ResultRecord& result) const;
  Cluster& cluster_;
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_JOBS_JOB_JOURNAL_H_
