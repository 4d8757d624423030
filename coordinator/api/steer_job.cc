// Which jobs CoordinatorImpl prefers, which rest, and which are done again.
#include <algorithm>
#include <utility>

#include "absl/strings/str_cat.h"
#include "common/util/error_info.h"
#include "common/util/folders.h"
#include "common/util/status_macros.h"
#include "common/util/text.h"
#include "coordinator/api/coordinator_impl.h"
#include "coordinator/jobs/job_proto.h"

namespace tilemend {
namespace {

// Whether the output that a job has completed is gone. What begins with ".tilemend-" is kept for the jobs that come
// after.
absl::Status CheckOutputGone(const JobSpec& spec) {
  if (spec.overwrite() || spec.dry_run()) return absl::OkStatus();
  const auto names = ListFolder(spec.out());
  const bool gone = !names.ok() || std::all_of(names->begin(), names->end(),
                                               [](const std::string& name) { return name.starts_with(".tilemend-"); });
  if (gone) return absl::OkStatus();
  return WithErrorInfo(
      absl::AlreadyExistsError(
          absl::StrCat(Printable(spec.out()), ": the output is complete; give --overwrite to do the job again there")),
      {"OUTPUT_EXISTS", {}});
}

}  // namespace

absl::Status CheckPriority(int32_t priority) {
  constexpr int32_t kMost = 100;
  if (-kMost <= priority && priority <= kMost) return absl::OkStatus();
  return WithErrorInfo(
      absl::InvalidArgumentError(absl::StrCat("priority: ", priority, " is not between ", -kMost, " and ", kMost)),
      {"INVALID_PRIORITY", {{"priority", absl::StrCat(priority)}}});
}

absl::StatusOr<v1::Job> CoordinatorImpl::PauseJob(const v1::PauseJobRequest& request) {
  return Answer([&] { return Steer(request.name(), {.job = "", .paused = true}); });
}

absl::StatusOr<v1::Job> CoordinatorImpl::ResumeJob(const v1::ResumeJobRequest& request) {
  return Answer([&] { return Steer(request.name(), {.job = "", .paused = false}); });
}

absl::StatusOr<v1::Job> CoordinatorImpl::PrioritizeJob(const v1::PrioritizeJobRequest& request) {
  TILEMEND_RETURN_IF_ERROR(CheckPriority(request.priority()));
  return Answer([&] { return Steer(request.name(), {.job = "", .priority = request.priority()}); });
}

absl::StatusOr<v1::Job> CoordinatorImpl::Steer(const std::string& name, JobSteered change) {
  TILEMEND_ASSIGN_OR_RETURN(const Job* job, JobNamed(name));
  change.job = job->id;
  const uint64_t before = job->version;
  TILEMEND_RETURN_IF_ERROR(Apply(change).status());
  // One whose end is in the journal already must not be put there as running.
  if (job->version != before && !entries_.at(job->id).completed) PutJob(*job, false);
  Changed();
  return Describe(*job);
}

absl::StatusOr<v1::Job> CoordinatorImpl::RetryJob(const v1::RetryJobRequest& request, JobOrigin origin) {
  JobSpec spec;
  JobState state = JobState::kRunning;
  int32_t priority = 0;
  {
    Lock lock(mutex_);
    TILEMEND_ASSIGN_OR_RETURN(const Job* job, JobNamed(request.name()));
    state = job->state;
    priority = job->priority;
    if (!IsOver(state)) {
      return WithErrorInfo(
          absl::FailedPreconditionError(absl::StrCat(request.name(), ": still running; cancel it first")),
          {"JOB_NOT_OVER", {{"job", job->id}, {"state", std::string(JobStateName(state))}}});
    }
    spec = entries_.at(job->id).spec;
  }
  spec.set_overwrite(spec.overwrite() || request.overwrite());
  TILEMEND_RETURN_IF_ERROR(CheckRoots(spec));
  const bool was_completed = state == JobState::kDone || state == JobState::kPartial;
  const absl::Status vacant = was_completed ? CheckOutputGone(spec) : absl::OkStatus();
  return Answer([&]() -> absl::StatusOr<v1::Job> {
    TILEMEND_RETURN_IF_ERROR(OnlyIfNew(request.request_id(), vacant));
    return StartJob(spec, request.request_id(), priority, std::move(origin));
  });
}

}  // namespace tilemend
