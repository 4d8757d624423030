// Jobs that are started, and what their pipelines report.
#ifndef TILEMEND_COORDINATOR_JOBS_JOB_RUNS_H_
#define TILEMEND_COORDINATOR_JOBS_JOB_RUNS_H_

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "coordinator/jobs/cluster.h"
#include "coordinator/jobs/job_journal.h"
#include "coordinator/jobs/job_pipeline.h"
#include "coordinator/jobs/job_runner.h"
#include "coordinator/jobs/preparations.h"
#include "coordinator/jobs/state_updates.h"
#include "tilemend/v1/jobs.pb.h"

namespace tilemend {

// Tells outputs apart: two spellings of one folder give one key. "" if the job writes nothing.
std::string OutKeyOf(const JobSpec& spec);

// Starts the runners of jobs and takes their calls. A runner ends before this does.
class JobRuns {
 public:
  // All but the factory must outlive this.
  JobRuns(Cluster& cluster, StateUpdates& updates, const JobJournal& journal, PipelineFactory factory)
      : cluster_(cluster),
        updates_(updates),
        journal_(journal),
        factory_(std::move(factory)),
        preparations_(cluster.options.work_folder + "/preparing") {}

  // A new job with this spec, or the job that this request made before. Needs the lock. kInvalidArgument
  // (INVALID_SPEC, REQUEST_ID_REUSED), kAborted (OUTPUT_IN_USE), kResourceExhausted (TOO_MANY_JOBS); errors of
  // BlobFolder::Create.
  absl::StatusOr<v1::Job> StartJob(const JobSpec& spec, const std::string& request_id, int32_t priority,
                                   JobOrigin origin);
  // Runs a job of an earlier process, which has an entry in the cluster. Needs the lock. std::system_error if there is
  // no thread.
  void Resume(const std::string& id, JobRunner::Mode mode);

 private:
  // Starts the job's thread. If none can be made, the job is forgotten as if it had never been there.
  absl::Status Begin(JobEntry& entry, const std::string& id);
  absl::Status CheckNewJob(const std::string& out_key) const;
  JobRunner::Sink SinkOf(const std::string& id);  // of a job that is in the state

  // Counts how often coordinators end while the pipeline of the job is made.
  PipelineFactory FactoryOf(const std::string& id);

  // Calls of the runners; each takes the lock.
  absl::Status OnTasks(const std::string& id, std::vector<TaskSpec> tasks, TaskContents contents,
                       const Progress& progress);
  void OnCompleted(const std::string& id, const JobOutcome& outcome, const Progress& progress);
  void OnFinished(const std::string& id, absl::StatusOr<JobOutcome> outcome);
  void OnReleased(const std::string& id);
  absl::Status OnCaught(const std::string& id, const CaughtWorker& caught);
  absl::Status OnBeginsAgain(const std::string& id);

  Cluster& cluster_;
  StateUpdates& updates_;
  const JobJournal& journal_;
  const PipelineFactory factory_;
  Preparations preparations_;
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_JOBS_JOB_RUNS_H_
