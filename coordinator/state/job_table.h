// The jobs that the coordinator knows.
#ifndef TILEMEND_COORDINATOR_STATE_JOB_TABLE_H_
#define TILEMEND_COORDINATOR_STATE_JOB_TABLE_H_

#include <cstdint>
#include <map>
#include <string>
#include <utility>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "coordinator/state/job.h"

namespace tilemend {

// Jobs by id, by number, and by the request that made them. Ids, numbers and requests are each of one job alone, and
// the number of a new one is the largest. Pointers hold until the job is forgotten.
class JobTable {
 public:
  // Null if there is none.
  const Job* Find(const std::string& id) const;
  Job* Find(const std::string& id) { return const_cast<Job*>(std::as_const(*this).Find(id)); }
  const Job* FindRequest(const std::string& request_id) const;
  // Null as well for a task that is settled: it is gone.
  const Task* FindTask(const TaskKey& key) const;
  // kNotFound (JOB_NOT_FOUND), kFailedPrecondition (JOB_OVER).
  absl::StatusOr<Job*> FindRunning(const std::string& id);

  const std::map<std::string, Job>& all() const { return jobs_; }
  // By number: the oldest job first.
  const std::map<int64_t, std::string>& numbers() const { return numbers_; }
  // Those of the jobs that are not over.
  const std::map<int64_t, std::string>& running() const { return running_; }
  int64_t last_number() const { return last_number_; }

  // Precondition: its id and request are new, and its number is larger than last_number().
  void Insert(Job job);
  void End(Job& job, JobState state);
  // kNotFound (JOB_NOT_FOUND), kInvalidArgument if it is not over.
  absl::Status Forget(const std::string& id);

 private:
  std::map<std::string, Job> jobs_;
  std::map<int64_t, std::string> numbers_;
  std::map<int64_t, std::string> running_;
  std::map<std::string, std::string> requests_;
  int64_t last_number_ = 0;
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_STATE_JOB_TABLE_H_
