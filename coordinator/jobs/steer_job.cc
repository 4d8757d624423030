#include "coordinator/jobs/steer_job.h"

#include "absl/strings/str_cat.h"
#include "common/util/error_info.h"
#include "common/util/status_macros.h"
#include "coordinator/jobs/describe_job.h"

namespace tilemend {

absl::Status CheckPriority(int32_t priority) {
  constexpr int32_t kMost = 100;
  if (-kMost <= priority && priority <= kMost) return absl::OkStatus();
  return WithErrorInfo(
      absl::InvalidArgumentError(absl::StrCat("priority: ", priority, " is not between ", -kMost, " and ", kMost)),
      {"INVALID_PRIORITY", {{"priority", absl::StrCat(priority)}}});
}

absl::StatusOr<v1::Job> JobSteering::Steer(const std::string& name, JobSteered change) {
  TILEMEND_ASSIGN_OR_RETURN(const Job* job, cluster_.JobNamed(name));
  change.job = job->id;
  const uint64_t before = job->version;
  TILEMEND_RETURN_IF_ERROR(updates_.Apply(change).status());
  // One whose end is in the journal already must not be put there as running.
  if (job->version != before && !cluster_.jobs.at(job->id).completed) journal_.PutJob(*job, false);
  cluster_.Changed();
  cluster_.job_changed.Wake();
  return DescribeJob(cluster_, *job);
}

absl::StatusOr<v1::Job> JobSteering::Cancel(const std::string& name) {
  TILEMEND_ASSIGN_OR_RETURN(const Job* job, cluster_.JobNamed(name));
  if (job->state == JobState::kCancelled) return DescribeJob(cluster_, *job);
  JobRunner* runner = IsOver(job->state) ? nullptr : cluster_.jobs.at(job->id).runner.get();
  if (runner != nullptr && !runner->inbox().Cancel()) {
    return WithErrorInfo(absl::FailedPreconditionError(absl::StrCat(name, ": too late, it is just ending")),
                         {"JOB_OVER", {{"job", job->id}, {"state", std::string(JobStateName(job->state))}}});
  }
  TILEMEND_RETURN_IF_ERROR(updates_.Apply(JobCancelled{job->id, cluster_.options.clock()}).status());
  cluster_.events.JobEnded(*job, {}, absl::OkStatus(), cluster_.jobs.at(job->id).origin);
  journal_.PutJob(*job, runner == nullptr);  // else its output is released by the runner, or after a restart
  cluster_.ShowMetrics();
  cluster_.Changed();
  cluster_.job_changed.Wake();
  return DescribeJob(cluster_, *job);
}

}  // namespace tilemend
