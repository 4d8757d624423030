// Calls of clients on jobs.
#ifndef TILEMEND_COORDINATOR_API_JOBS_HANDLER_H_
#define TILEMEND_COORDINATOR_API_JOBS_HANDLER_H_

#include <cstdint>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "coordinator/jobs/cluster.h"
#include "coordinator/jobs/job_journal.h"
#include "coordinator/jobs/job_pipeline.h"
#include "coordinator/jobs/job_runs.h"
#include "coordinator/jobs/state_updates.h"
#include "coordinator/jobs/steer_job.h"
#include "coordinator/state/cell_board.h"
#include "tilemend/v1/jobs.pb.h"

namespace tilemend {

// How far a job is, cell by cell.
struct JobCells {
  CellLetters cells;  // the CellProgress of those that had a task; none of a job of an earlier process that is over
  std::vector<CellFailure> failures;
  std::set<CellId> held;  // cells of tasks that workers hold now
  JobState state = JobState::kRunning;
  uint64_t version = 0;  // another one whenever something of the job has changed
  JobSpec spec;
  std::string report;                                 // path of report.json, "" if there is none
  std::shared_ptr<const SceneSight> sight = nullptr;  // of a job that runs, once its scene is read
  // Of a job that is over: "jobs/ID" of the last job after it that completed the same output. If there is none, of the
  // last that may have begun to write there; "" without such a job.
  std::string later_job = {};
  bool later_is_complete = false;
};

// Thread-safe; every call is short. The messages say what each call does and which errors it has.
class JobsHandler {
 public:
  // All must outlive this.
  JobsHandler(Cluster& cluster, StateUpdates& updates, const JobJournal& journal, JobRuns& runs)
      : cluster_(cluster), runs_(runs), steering_(cluster, updates, journal) {}

  absl::StatusOr<v1::Job> CreateJob(const v1::CreateJobRequest& request, JobOrigin origin = {});
  absl::StatusOr<v1::Job> GetJob(const v1::GetJobRequest& request);
  absl::StatusOr<v1::ListJobsResponse> ListJobs(const v1::ListJobsRequest& request);
  absl::StatusOr<v1::Job> CancelJob(const v1::CancelJobRequest& request);
  absl::StatusOr<v1::Job> RetryJob(const v1::RetryJobRequest& request, JobOrigin origin = {});
  absl::StatusOr<v1::Job> PauseJob(const v1::PauseJobRequest& request);
  absl::StatusOr<v1::Job> ResumeJob(const v1::ResumeJobRequest& request);
  // How far the cells of the job `name` are. Errors of GetJob. Cost: O(cells).
  absl::StatusOr<JobCells> GetCells(const std::string& name);
  absl::StatusOr<v1::Job> PrioritizeJob(const v1::PrioritizeJobRequest& request);

 private:
  // What is wrong with a request; OK if a request with this id was taken before. Needs the lock.
  absl::Status OnlyIfNew(const std::string& request_id, const absl::Status& error) const;

  Cluster& cluster_;
  JobRuns& runs_;
  JobSteering steering_;
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_API_JOBS_HANDLER_H_
