#include "coordinator/api/jobs_handler.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>

#include "absl/strings/numbers.h"
#include "absl/strings/str_cat.h"
#include "common/options/job_options.h"
#include "common/util/error_info.h"
#include "common/util/folders.h"
#include "common/util/object_store.h"
#include "common/util/roots.h"
#include "common/util/status_macros.h"
#include "common/util/text.h"
#include "coordinator/api/page.h"
#include "coordinator/jobs/describe_job.h"
#include "coordinator/jobs/output_cells.h"

namespace tilemend {
namespace {

// Then a page ends: one job more, with its longest paths, error and warnings, fits into a message.
constexpr size_t kMostPageBytes = size_t{2} << 20;

absl::Status CheckScene(const std::string& scene) {
  if (scene.find("://") != std::string::npos && !IsObjectPath(scene)) return absl::OkStatus();
  const absl::Status look = LookAt(scene).status();
  if (look.ok()) return absl::OkStatus();
  if (IsObjectPath(scene) && !absl::IsNotFound(look)) return look;
  const std::string why = absl::IsNotFound(look) ? "" : absl::StrCat(" (", std::string(look.message()), ")");
  return WithErrorInfo(absl::NotFoundError(absl::StrCat(Printable(scene), ": no such scene", why)),
                       {"SCENE_NOT_FOUND", {{"scene", scene}}});
}

struct FieldPath {
  const char* field;
  std::string path;
};

// The files that a job reads beside its scene.
std::vector<FieldPath> FilesOf(const JobSpec& spec) {
  const bool water_is_file = spec.water() != "auto" && spec.water() != "off";
  std::vector<FieldPath> files = {{"water", water_is_file ? spec.water() : ""},
                                  {"clear", spec.clear()},
                                  {"decisions", spec.decisions()},
                                  {"area", spec.area()}};
  std::erase_if(files, [](const FieldPath& file) { return file.path.empty(); });
  return files;
}

// FILE_NOT_FOUND names the first field whose file is not there. Other faults of the file are told by the job. Without
// the lock: a mount may hang.
absl::Status CheckFiles(const JobSpec& spec) {
  for (const auto& [field, path] : FilesOf(spec)) {
    if (!absl::IsNotFound(LookAt(path).status())) continue;
    return WithErrorInfo(absl::NotFoundError(absl::StrCat(field, ": ", Printable(path), ": no such file")),
                         {"FILE_NOT_FOUND", {{"field", field}}});
  }
  return absl::OkStatus();
}

// OUTSIDE_ROOTS names the first field whose path is not below the roots. Without the lock: a mount may hang.
absl::Status CheckRoots(const Roots* roots, const JobSpec& spec) {
  if (roots == nullptr) return absl::OkStatus();
  std::vector<FieldPath> paths = FilesOf(spec);
  paths.insert(paths.begin(), {{"scene", spec.scene()}, {"out", spec.out()}});
  for (const auto& [field, path] : paths) {
    const absl::Status status = roots->Check(path);
    if (!status.ok()) {
      return WithErrorInfo(absl::PermissionDeniedError(absl::StrCat(field, ": ", std::string(status.message()))),
                           {"OUTSIDE_ROOTS", {{"field", field}}});
    }
  }
  return absl::OkStatus();
}

// Whether the output that a job has completed is gone. What begins with ".tilemend-" is kept for the jobs that come
// after.
absl::Status CheckOutputGone(const JobSpec& spec) {
  if (spec.overwrite() || spec.dry_run()) return absl::OkStatus();
  const auto names = ListFolder(spec.out());
  if (!names.ok() && !absl::IsNotFound(names.status())) return names.status();
  const bool gone = !names.ok() || std::all_of(names->begin(), names->end(),
                                               [](const std::string& name) { return name.starts_with(".tilemend-"); });
  if (gone) return absl::OkStatus();
  return WithErrorInfo(
      absl::AlreadyExistsError(
          absl::StrCat(Printable(spec.out()), ": the output is complete; give --overwrite to do the job again there")),
      {"OUTPUT_EXISTS", {}});
}

// Sets what `cells` says of later jobs: the last that is complete, else the last. Needs the lock. Cost: O(later jobs).
void SetLaterJob(const Cluster& cluster, const Job& job, JobCells& cells) {
  const std::string& out_key = cluster.jobs.at(job.id).out_key;
  if (!IsOver(job.state) || out_key.empty()) return;
  const auto& numbers = cluster.state.job_numbers();
  for (auto it = numbers.rbegin(); it != numbers.rend() && it->first > job.number; ++it) {
    const auto other = cluster.jobs.find(it->second);
    if (other == cluster.jobs.end() || other->second.out_key != out_key) continue;
    cells.later_is_complete = other->second.completed || !other->second.outcome.report.empty();
    if (cells.later_is_complete || cells.later_job.empty()) cells.later_job = absl::StrCat("jobs/", it->second);
    if (cells.later_is_complete) return;
  }
}

}  // namespace

absl::StatusOr<v1::Job> JobsHandler::CreateJob(const v1::CreateJobRequest& request, JobOrigin origin) {
  const JobSpec spec = WithDefaults(request.spec());
  TILEMEND_RETURN_IF_ERROR(CheckJob(spec));
  TILEMEND_RETURN_IF_ERROR(CheckPriority(request.priority()));
  TILEMEND_RETURN_IF_ERROR(CheckRoots(cluster_.options.roots.get(), spec));
  // All without the lock: a mount may hang.
  absl::Status folders = CheckScene(spec.scene());
  folders.Update(CheckFiles(spec));
  folders.Update(CheckOutputTakes(spec));
  return AnswerWhenDurable(cluster_, [&]() -> absl::StatusOr<v1::Job> {
    TILEMEND_RETURN_IF_ERROR(OnlyIfNew(request.request_id(), folders));
    return runs_.StartJob(spec, request.request_id(), request.priority(), std::move(origin));
  });
}

absl::StatusOr<v1::Job> JobsHandler::GetJob(const v1::GetJobRequest& request) {
  return AnswerWhenDurable(cluster_, [&]() -> absl::StatusOr<v1::Job> {
    TILEMEND_ASSIGN_OR_RETURN(const Job* job, cluster_.JobNamed(request.name()));
    return DescribeJob(cluster_, *job);
  });
}

absl::StatusOr<JobCells> JobsHandler::GetCells(const std::string& name) {
  return AnswerWhenDurable(cluster_, [&]() -> absl::StatusOr<JobCells> {
    TILEMEND_ASSIGN_OR_RETURN(const Job* job, cluster_.JobNamed(name));
    const JobEntry& entry = cluster_.jobs.at(job->id);
    JobCells answer{entry.board.Cells(), entry.board.failures(), {},         job->state, job->version,
                    entry.spec,          entry.outcome.report,   entry.sight};
    for (const auto& [id, task] : job->tasks) {
      if (!task.leases.empty()) answer.held.insert(task.cell);
    }
    SetLaterJob(cluster_, *job, answer);
    return answer;
  });
}

absl::StatusOr<v1::Job> JobsHandler::CancelJob(const v1::CancelJobRequest& request) {
  return AnswerWhenDurable(cluster_, [&] { return steering_.Cancel(request.name()); });
}

absl::StatusOr<v1::ListJobsResponse> JobsHandler::ListJobs(const v1::ListJobsRequest& request) {
  if (request.page_size() < 0) return InvalidPage("page_size: below 0");
  int64_t below = std::numeric_limits<int64_t>::max();  // the token is the number of the last job that was looked at
  if (!request.page_token().empty() &&
      (!absl::SimpleAtoi(request.page_token(), &below) || below <= 0 || absl::StrCat(below) != request.page_token())) {
    return InvalidPage(absl::StrCat("page_token: '", request.page_token(), "' was not given out here"));
  }
  const std::set<int> states(request.states().begin(), request.states().end());
  return AnswerWhenDurable(cluster_, [&] {
    const auto& numbers = cluster_.state.job_numbers();
    v1::ListJobsResponse response;
    auto it = numbers.lower_bound(below);
    size_t bytes = 0;
    while (it != numbers.begin() && response.jobs_size() < PageSize(request.page_size()) && bytes < kMostPageBytes) {
      --it;
      v1::Job job = DescribeJob(cluster_, *cluster_.state.FindJob(it->second));
      if (!states.empty() && !states.contains(job.state())) continue;
      bytes += job.ByteSizeLong();
      *response.add_jobs() = std::move(job);
    }
    if (it != numbers.begin()) response.set_next_page_token(absl::StrCat(it->first));
    return response;
  });
}

absl::StatusOr<v1::Job> JobsHandler::PauseJob(const v1::PauseJobRequest& request) {
  return AnswerWhenDurable(cluster_, [&] { return steering_.Steer(request.name(), {.job = "", .paused = true}); });
}

absl::StatusOr<v1::Job> JobsHandler::ResumeJob(const v1::ResumeJobRequest& request) {
  return AnswerWhenDurable(cluster_, [&] { return steering_.Steer(request.name(), {.job = "", .paused = false}); });
}

absl::StatusOr<v1::Job> JobsHandler::PrioritizeJob(const v1::PrioritizeJobRequest& request) {
  TILEMEND_RETURN_IF_ERROR(CheckPriority(request.priority()));
  return AnswerWhenDurable(
      cluster_, [&] { return steering_.Steer(request.name(), {.job = "", .priority = request.priority()}); });
}

absl::StatusOr<v1::Job> JobsHandler::RetryJob(const v1::RetryJobRequest& request, JobOrigin origin) {
  JobSpec spec;
  JobState state = JobState::kRunning;
  int32_t priority = 0;
  {
    ClusterLock lock(cluster_.mutex);
    TILEMEND_ASSIGN_OR_RETURN(const Job* job, cluster_.JobNamed(request.name()));
    state = job->state;
    priority = job->priority;
    if (!IsOver(state)) {
      return WithErrorInfo(
          absl::FailedPreconditionError(absl::StrCat(request.name(), ": still running; cancel it first")),
          {"JOB_NOT_OVER", {{"job", job->id}, {"state", std::string(JobStateName(state))}}});
    }
    spec = cluster_.jobs.at(job->id).spec;
  }
  spec.set_overwrite(spec.overwrite() || request.overwrite());
  TILEMEND_RETURN_IF_ERROR(CheckRoots(cluster_.options.roots.get(), spec));
  const bool was_completed = state == JobState::kDone || state == JobState::kPartial;
  const absl::Status vacant = was_completed ? CheckOutputGone(spec) : absl::OkStatus();
  return AnswerWhenDurable(cluster_, [&]() -> absl::StatusOr<v1::Job> {
    TILEMEND_RETURN_IF_ERROR(OnlyIfNew(request.request_id(), vacant));
    return runs_.StartJob(spec, request.request_id(), priority, std::move(origin));
  });
}

absl::Status JobsHandler::OnlyIfNew(const std::string& request_id, const absl::Status& error) const {
  const bool is_new = request_id.empty() || cluster_.state.FindRequest(request_id) == nullptr;
  return is_new ? error : absl::OkStatus();
}

}  // namespace tilemend
