#include "coordinator/jobs/job_runs.h"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <random>
#include <system_error>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"
#include "common/options/job_options.h"
#include "common/rpc/trace.h"
#include "common/util/error_info.h"
#include "common/util/status_macros.h"
#include "coordinator/jobs/describe_job.h"
#include "coordinator/jobs/job_proto.h"
#include "coordinator/state/task_choice.h"

namespace tilemend {
namespace {

constexpr size_t kMaxRequestIdBytes = 128;
constexpr int kRetryAfter = 10;  // seconds, after a submission that was refused for want of room

std::string NewJobId() {
  std::random_device random;
  return absl::StrFormat("%08x%04x", random(), random() & 0xffff);
}

absl::Status InvalidRequestId() {
  return WithErrorInfo(
      absl::InvalidArgumentError(absl::StrCat("request_id: longer than ", kMaxRequestIdBytes, " bytes")),
      {"INVALID_SPEC", {{"field", "request_id"}}});
}

}  // namespace

std::string OutKeyOf(const JobSpec& spec) {
  if (spec.out().empty() || spec.dry_run()) return "";
  std::string key = std::filesystem::path(spec.out()).lexically_normal().string();
  while (key.size() > 1 && key.back() == '/') key.pop_back();
  return key;
}

absl::StatusOr<v1::Job> JobRuns::StartJob(const JobSpec& spec, const std::string& request_id, int32_t priority,
                                          JobOrigin origin) {
  if (request_id.size() > kMaxRequestIdBytes) return InvalidRequestId();
  if (const Job* job = request_id.empty() ? nullptr : cluster_.state.FindRequest(request_id); job != nullptr) {
    if (AreEqual(cluster_.jobs.at(job->id).spec, spec)) return DescribeJob(cluster_, *job);
    return WithErrorInfo(
        absl::InvalidArgumentError(absl::StrCat("request_id ", request_id, ": used before, with another spec")),
        {"REQUEST_ID_REUSED", {{"job", job->id}}});
  }
  const std::string out_key = OutKeyOf(spec);
  TILEMEND_RETURN_IF_ERROR(CheckNewJob(out_key));
  const std::string id = NewJobId();
  TILEMEND_ASSIGN_OR_RETURN(auto blobs, BlobFolder::Create(BlobsPathOf(cluster_, id)));
  TILEMEND_RETURN_IF_ERROR(updates_.Apply(JobCreated{id, request_id, cluster_.options.clock(), priority}).status());
  JobEntry& entry = cluster_.jobs[id];
  entry.spec = spec;
  entry.origin = std::move(origin);
  if (entry.origin.trace.empty()) entry.origin.trace = NewTrace();
  entry.out_key = out_key;
  entry.blobs = blobs;
  journal_.PutJob(*cluster_.state.FindJob(id), false);
  cluster_.events.JobCreated(*cluster_.state.FindJob(id), spec, entry.origin);
  if (const absl::Status begun = Begin(entry, id); !begun.ok()) return begun;
  cluster_.ShowMetrics();
  return DescribeJob(cluster_, *cluster_.state.FindJob(id));
}

absl::Status JobRuns::Begin(JobEntry& entry, const std::string& id) {
  try {
    entry.runner = std::make_unique<JobRunner>(entry.spec, FactoryOf(id), entry.blobs, SinkOf(id));
    return absl::OkStatus();
  } catch (const std::system_error& error) {  // no thread can be made
    cluster_.journal->DropJob(cluster_.state.FindJob(id)->number);
    entry.blobs->Remove();
    updates_.Apply(JobCancelled{id, cluster_.options.clock()}).IgnoreError();
    updates_.Apply(JobForgotten{id}).IgnoreError();
    cluster_.jobs.erase(id);
    return WithErrorInfo(absl::ResourceExhaustedError(absl::StrCat("no thread can be made for the job (", error.what(),
                                                                   "); try again in ", kRetryAfter, " s")),
                         {"TOO_MANY_JOBS", {{"retry_after_s", absl::StrCat(kRetryAfter)}}});
  }
}

absl::Status JobRuns::CheckNewJob(const std::string& out_key) const {
  size_t running = 0;
  for (const auto& [id, entry] : cluster_.jobs) {
    if (entry.runner == nullptr || !entry.runner->may_write()) continue;  // a cancelled job may for a while
    ++running;
    if (!out_key.empty() && entry.out_key == out_key) {
      return WithErrorInfo(
          absl::AbortedError(absl::StrCat(out_key, ": jobs/", id,
                                          " is writing there; wait for it, cancel it or choose another folder")),
          {"OUTPUT_IN_USE", {{"job", id}}});
    }
  }
  if (running < cluster_.options.max_running_jobs) return absl::OkStatus();
  return WithErrorInfo(
      absl::ResourceExhaustedError(
          absl::StrCat(running, " jobs are running, which is the limit; try again in ", kRetryAfter, " s")),
      {"TOO_MANY_JOBS",
       {{"limit", absl::StrCat(cluster_.options.max_running_jobs)}, {"retry_after_s", absl::StrCat(kRetryAfter)}}});
}

void JobRuns::Resume(const std::string& id, JobRunner::Mode mode) {
  JobEntry& entry = cluster_.jobs.at(id);
  entry.runner = std::make_unique<JobRunner>(entry.spec, FactoryOf(id), entry.blobs, SinkOf(id), mode);
}

JobRunner::Sink JobRuns::SinkOf(const std::string& id) {
  return {.recall = [this, id](std::vector<TaskSpec>& tasks) { return journal_.Recall(id, tasks); },
          .add_tasks =
              [this, id](std::vector<TaskSpec> tasks, TaskContents contents, const Progress& progress) {
                return OnTasks(id, std::move(tasks), std::move(contents), progress);
              },
          .await = [this] { cluster_.journal->Await(); },
          .completed = [this, id](const JobOutcome& outcome,
                                  const Progress& progress) { OnCompleted(id, outcome, progress); },
          .finished = [this, id](absl::StatusOr<JobOutcome> outcome) { OnFinished(id, std::move(outcome)); },
          .released = [this, id] { OnReleased(id); },
          .folders =
              [this, id](JobFolders folders) {
                ClusterLock lock(cluster_.mutex);
                cluster_.trust.AddJob(id, std::move(folders));
              },
          .sight =
              [this, id](std::shared_ptr<const SceneSight> sight) {
                ClusterLock lock(cluster_.mutex);
                cluster_.jobs.at(id).sight = std::move(sight);
              },
          .caught = [this, id](const CaughtWorker& caught) { return OnCaught(id, caught); },
          .begins_again = [this, id] { return OnBeginsAgain(id); },
          .notes = journal_.NotesOf(id)};
}

PipelineFactory JobRuns::FactoryOf(const std::string& id) {
  if (!cluster_.journal->is_durable()) return factory_;  // no other coordinator resumes the job
  return [this, id](const JobSpec& spec, const std::stop_token& stop) -> absl::StatusOr<std::unique_ptr<JobPipeline>> {
    TILEMEND_ASSIGN_OR_RETURN(const Preparations::Attempt attempt, preparations_.Begin(id, stop));
    return factory_(spec, stop);
  };
}

absl::Status JobRuns::OnTasks(const std::string& id, std::vector<TaskSpec> tasks, TaskContents contents,
                              const Progress& progress) {
  ClusterLock lock(cluster_.mutex);
  JobEntry& entry = cluster_.jobs.at(id);
  bool& resuming = entry.resuming;
  const bool is_known = std::all_of(tasks.begin(), tasks.end(), [](const TaskSpec& task) {
    return task.known.has_value() || IsBackground(task.stage);  // no journal knows a verification
  });
  resuming = resuming && is_known && progress.phase != kVerifyPhase;
  // Both fail only if the job is over; then its runner is being cancelled. A job that resumes runs through all it has
  // done; nobody is to see it begin again.
  if (!resuming) updates_.Apply(JobProgressed{id, progress}).IgnoreError();
  for (const TaskSpec& task : tasks) entry.board.TaskAdded(task.cell, task.stage);
  if (!tasks.empty()) updates_.Apply(TasksAdded{id, std::move(tasks)}, std::move(contents)).IgnoreError();
  cluster_.Changed();
  return absl::OkStatus();
}

void JobRuns::OnCompleted(const std::string& id, const JobOutcome& outcome, const Progress& progress) {
  {
    ClusterLock lock(cluster_.mutex);
    updates_.Apply(JobProgressed{id, progress}).IgnoreError();
    const Job& job = *cluster_.state.FindJob(id);
    // The end is durable now, and told when the output is free for others.
    const bool partial = outcome.partial || job.counts.quarantined > 0;
    JobEntry& entry = cluster_.jobs.at(id);
    entry.completed = true;
    entry.ended = cluster_.options.clock();
    v1::Job end = JobToProto(job, entry.spec, outcome, absl::OkStatus(), entry.origin);
    SetEnd(partial ? JobState::kPartial : JobState::kDone, entry.ended, end);
    journal_.PutJob(job, false, std::move(end));
  }
  cluster_.journal->Await();
}

void JobRuns::OnFinished(const std::string& id, absl::StatusOr<JobOutcome> outcome) {
  ClusterLock lock(cluster_.mutex);
  const Job* job = cluster_.state.FindJob(id);
  if (job == nullptr) return;
  JobEntry& entry = cluster_.jobs.at(id);
  entry.sight.reset();  // the page reads the report now; a job that was cancelled needs it no more
  if (IsOver(job->state)) return;
  JobState state = JobState::kFailed;
  if (outcome.ok()) {
    entry.outcome = *std::move(outcome);
    state = entry.outcome.partial ? JobState::kPartial : JobState::kDone;
  } else {
    entry.error = outcome.status();
    entry.ended = cluster_.options.clock();
  }
  updates_.Apply(JobFinished{id, state, entry.ended}).IgnoreError();
  cluster_.events.JobEnded(*job, entry.outcome, entry.error, entry.origin);
  if (state == JobState::kFailed) journal_.PutJob(*job, true);
  cluster_.ShowMetrics();
  cluster_.Changed();
  cluster_.job_changed.Wake();
}

absl::Status JobRuns::OnCaught(const std::string& id, const CaughtWorker& caught) {
  ClusterLock lock(cluster_.mutex);
  const bool another = HasOtherWorker(cluster_.state, caught.worker, id, cluster_.MayWorkNow());
  const auto effects = updates_.Apply(WorkerDisproved{id, caught.worker, caught.reason, another});
  updates_.Warn(id, caught.reason);
  if (effects.ok()) return absl::OkStatus();
  return WithErrorInfo(absl::AbortedError(caught.reason), {"OUTPUT_CHANGED", {}});
}

absl::Status JobRuns::OnBeginsAgain(const std::string& id) {
  int64_t number = 0;
  {
    ClusterLock lock(cluster_.mutex);
    TILEMEND_RETURN_IF_ERROR(updates_.Apply(JobRedone{id}).status());
    JobEntry& entry = cluster_.jobs.at(id);
    entry.resuming = entry.began_again = true;
    entry.board = CellBoard();
    number = cluster_.state.FindJob(id)->number;
    cluster_.Changed();
  }
  return cluster_.journal->ReadAgain(number);
}

void JobRuns::OnReleased(const std::string& id) {
  ClusterLock lock(cluster_.mutex);
  journal_.PutJob(*cluster_.state.FindJob(id), true);
}

}  // namespace tilemend
