#include "coordinator/jobs/restore_jobs.h"

#include <chrono>
#include <filesystem>
#include <system_error>
#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"
#include "common/util/failpoint.h"
#include "common/util/status_macros.h"
#include "coordinator/jobs/job_proto.h"

namespace tilemend {

void JobRestorer::StopSweeping() {
  leaving_.store(true);
  if (sweeper_.joinable()) sweeper_.join();
}

absl::Status JobRestorer::Restore() {
  for (const SetAsideRecord& aside : cluster_.journal->TakeSetAside())
    cluster_.trust.SetAside(aside.worker, aside.reason);
  for (JobRecord& record : cluster_.journal->TakeJobs()) {
    const int64_t number = record.number;
    // One job's damage is not that of the others.
    if (const absl::Status status = RestoreJob(std::move(record)); !status.ok()) {
      TILEMEND_RETURN_IF_ERROR(RestoreAsFailed(number, status));
    }
  }
  {
    ClusterLock lock(cluster_.mutex);  // the runners are at work
    cluster_.ShowMetrics();
  }
  return SweepFolders();
}

absl::Status JobRestorer::RestoreJob(JobRecord record) {
  v1::Job message;
  if (record.damaged || !message.ParseFromString(record.body)) {
    return absl::DataLossError(
        absl::StrCat("its record in the journal of ", cluster_.options.work_folder, " is damaged"));
  }
  ToldJob told = JobFromProto(message);
  told.job.number = record.number;
  told.job.request_id = std::move(record.request_id);
  const std::string id = told.job.id;
  if (!record.over) told.job.progress.phase = kResumePhase;
  // The lock is for the runners of the jobs before.
  ClusterLock lock(cluster_.mutex);
  TILEMEND_RETURN_IF_ERROR(updates_.Apply(JobRestored{std::move(told.job)}).status());
  JobEntry& entry = cluster_.jobs[id];
  entry.spec = std::move(told.spec);
  entry.out_key = OutKeyOf(entry.spec);
  entry.origin = std::move(told.origin);
  entry.outcome = std::move(told.outcome);
  entry.error = std::move(told.error);
  if (record.over) cluster_.job_metrics.CountEnd(*cluster_.state.FindJob(id));
  if (record.over && record.released) return absl::OkStatus();
  const auto mode = record.over ? JobRunner::Mode::kRelease : JobRunner::Mode::kResume;
  if (!record.over) {
    TILEMEND_ASSIGN_OR_RETURN(entry.blobs, BlobFolder::Create(BlobsPathOf(cluster_, id)));
    TILEMEND_ASSIGN_OR_RETURN(const std::vector<std::string> outputs, cluster_.journal->Outputs(record.number));
    TILEMEND_RETURN_IF_ERROR(entry.blobs->KeepOnly({outputs.begin(), outputs.end()}));
    FailPoint("restore.swept");
    entry.resuming = entry.began_again = true;
    cluster_.events.JobRestored(*cluster_.state.FindJob(id), entry.origin);
  }
  runs_.Resume(id, mode);
  return absl::OkStatus();
}

absl::Status JobRestorer::RestoreAsFailed(int64_t number, const absl::Status& why) {
  ClusterLock lock(cluster_.mutex);
  const auto known = cluster_.state.job_numbers().find(number);
  const std::string id = known != cluster_.state.job_numbers().end() ? known->second : absl::StrCat("damaged-", number);
  if (known == cluster_.state.job_numbers().end()) {
    Job job;
    job.id = id;
    job.number = number;
    job.created = cluster_.options.clock();
    TILEMEND_RETURN_IF_ERROR(updates_.Apply(JobRestored{std::move(job)}).status());
  }
  JobEntry& entry = cluster_.jobs[id];
  entry.blobs.reset();  // its folder is swept
  entry.error = absl::Status(why.code(), absl::StrCat("the job cannot go on after a restart of the coordinator: ",
                                                      std::string(why.message()), "; submit it again"));
  TILEMEND_RETURN_IF_ERROR(updates_.Apply(JobFinished{id, JobState::kFailed, cluster_.options.clock()}).status());
  journal_.PutJob(*cluster_.state.FindJob(id), true);
  return absl::OkStatus();
}

absl::Status JobRestorer::SweepFolders() {
  if (!cluster_.journal->is_durable()) return absl::OkStatus();
  namespace fs = std::filesystem;
  std::error_code error;
  std::vector<fs::path> old;
  const fs::path jobs = fs::path(cluster_.options.work_folder) / "jobs";
  if (!fs::exists(jobs, error)) return absl::OkStatus();
  {
    ClusterLock lock(cluster_.mutex);
    for (fs::directory_iterator at(jobs, error), end; !error && at != end; at.increment(error)) {
      const auto entry = cluster_.jobs.find(at->path().filename().string());
      if (entry == cluster_.jobs.end() || entry->second.blobs == nullptr) old.push_back(at->path());
    }
  }
  // Some disks take minutes for many files: what is not done soon is done while jobs run.
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(1);
  std::vector<fs::path> left;
  for (const fs::path& path : old) {
    bool is_late = false;
    BlobFolder(path.string()).Remove([&] { return is_late = std::chrono::steady_clock::now() > deadline; });
    if (!fs::exists(path, error)) continue;
    if (!is_late) return absl::PermissionDeniedError(absl::StrCat(path.string(), ": no job needs it, and it stays"));
    left.push_back(path);
  }
  if (left.empty()) return absl::OkStatus();
  sweeper_ = std::thread([this, left = std::move(left)] {
    for (const fs::path& path : left) BlobFolder(path.string()).Remove([this] { return leaving_.load(); });
  });
  return absl::OkStatus();
}

}  // namespace tilemend
