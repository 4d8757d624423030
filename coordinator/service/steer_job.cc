// Which jobs CoordinatorImpl prefers, and which rest.
#include "absl/strings/str_cat.h"
#include "common/util/error_info.h"
#include "common/util/status_macros.h"
#include "coordinator/service/coordinator_impl.h"
#include "coordinator/service/job_proto.h"

namespace tilemend {

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

}  // namespace tilemend
