#include "coordinator/state/job_table.h"

#include "absl/strings/str_cat.h"
#include "common/util/error_info.h"

namespace tilemend {
namespace {

absl::Status JobNotFound(const std::string& job) {
  return WithErrorInfo(absl::NotFoundError(absl::StrCat("jobs/", job, ": no such job")),
                       {"JOB_NOT_FOUND", {{"job", job}}});
}

absl::Status JobOver(const Job& job) {
  const std::string state(JobStateName(job.state));
  return WithErrorInfo(absl::FailedPreconditionError(absl::StrCat("jobs/", job.id, ": the job is over (", state, ")")),
                       {"JOB_OVER", {{"job", job.id}, {"state", state}}});
}

}  // namespace

std::string_view JobStateName(JobState state) {
  switch (state) {
    case JobState::kRunning:
      return "running";
    case JobState::kDone:
      return "done";
    case JobState::kPartial:
      return "partial";
    case JobState::kFailed:
      return "failed";
    case JobState::kCancelled:
      return "cancelled";
  }
  return "unknown";
}

const Job* JobTable::Find(const std::string& id) const {
  const auto it = jobs_.find(id);
  return it == jobs_.end() ? nullptr : &it->second;
}

const Job* JobTable::FindRequest(const std::string& request_id) const {
  const auto it = requests_.find(request_id);
  return it == requests_.end() ? nullptr : Find(it->second);
}

const Task* JobTable::FindTask(const TaskKey& key) const {
  const Job* job = Find(key.job);
  if (job == nullptr) return nullptr;
  const auto it = job->tasks.find(key.task);
  return it == job->tasks.end() ? nullptr : &it->second;
}

absl::StatusOr<Job*> JobTable::FindRunning(const std::string& id) {
  Job* job = Find(id);
  if (job == nullptr) return JobNotFound(id);
  if (IsOver(job->state)) return JobOver(*job);
  return job;
}

void JobTable::Insert(Job job) {
  last_number_ = job.number;
  numbers_[job.number] = job.id;
  if (!IsOver(job.state)) running_[job.number] = job.id;
  if (!job.request_id.empty()) requests_[job.request_id] = job.id;
  jobs_[job.id] = std::move(job);
}

void JobTable::End(Job& job, JobState state) {
  job.state = state;
  running_.erase(job.number);
}

absl::Status JobTable::Forget(const std::string& id) {
  const auto job = jobs_.find(id);
  if (job == jobs_.end()) return JobNotFound(id);
  if (!IsOver(job->second.state)) return absl::InvalidArgumentError(absl::StrCat("jobs/", id, ": not over"));
  numbers_.erase(job->second.number);
  if (!job->second.request_id.empty()) requests_.erase(job->second.request_id);
  jobs_.erase(job);
  return absl::OkStatus();
}

}  // namespace tilemend
