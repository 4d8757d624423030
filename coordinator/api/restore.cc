// What CoordinatorImpl gives to its journal, and how it goes on with what it finds there.
#include <chrono>
#include <filesystem>
#include <set>
#include <system_error>
#include <utility>

#include "absl/strings/str_cat.h"
#include "common/rpc/status_proto.h"
#include "common/store/digest.h"
#include "common/util/failpoint.h"
#include "common/util/files.h"
#include "common/util/status_macros.h"
#include "coordinator/api/coordinator_impl.h"
#include "coordinator/jobs/job_proto.h"

namespace tilemend {
namespace {

// Contents that wait for the pipeline in memory; beyond that they go to disk.
constexpr size_t kMostKnownBytes = size_t{64} << 20;

// Each takes some KB: its paths, its error, its warnings.
constexpr size_t kMostJobsOver = 10'000;

absl::Status ErrorOf(const std::string& bytes) {
  v1::Status proto;
  if (!proto.ParseFromString(bytes)) return absl::DataLossError("the journal's text of an error cannot be read");
  return StatusFromProto(proto);
}

}  // namespace

void CoordinatorImpl::PutJob(const Job& job, bool released, std::optional<v1::Job> message) {
  if (!journal_->is_durable()) return;
  if (!message) message = Describe(job);
  const bool over = message->state() != v1::RUNNING;
  journal_->PutJob({job.number, job.request_id, message->SerializeAsString(), over, released});
}

TaskName CoordinatorImpl::NameOf(CellId cell, Stage stage, const std::string& input) const {
  return {cell, stage, Sha256Hex(absl::StrCat(options_.build, "\n", input))};
}

void CoordinatorImpl::PutResult(const SettledTask& task, const std::optional<std::string>& content) {
  if (!journal_->is_durable()) return;
  ResultRecord result{task.state, task.output, content, "", {}};
  if (task.state != TaskState::kCommitted) result.error = StatusToProto(task.error).SerializeAsString();
  journal_->PutResult(state_.FindJob(task.key.job)->number, NameOf(task.cell, task.stage, task.input),
                      std::move(result));
}

void CoordinatorImpl::PutStrike(const StruckTask& task) {
  if (!journal_->is_durable()) return;
  ResultRecord result;
  result.state = TaskState::kPending;
  result.lost_workers = task.lost_workers;
  journal_->PutResult(state_.FindJob(task.key.job)->number, NameOf(task.cell, task.stage, task.input),
                      std::move(result));
}

absl::StatusOr<CoordinatorImpl::Contents> CoordinatorImpl::Recall(const std::string& id, std::vector<TaskSpec>& tasks) {
  Contents contents;
  int64_t number = 0;
  std::shared_ptr<BlobFolder> blobs;
  {
    Lock lock(mutex_);
    number = state_.FindJob(id)->number;
    blobs = entries_.at(id).blobs;
  }
  size_t bytes = 0;
  for (TaskSpec& task : tasks) {
    TILEMEND_ASSIGN_OR_RETURN(std::optional<ResultRecord> found,
                              journal_->Find(number, NameOf(task.cell, task.stage, task.input)));
    if (!found) continue;
    if (!IsSettled(found->state)) {
      task.lost_workers = std::move(found->lost_workers);
      continue;
    }
    const bool is_blob = found->state == TaskState::kCommitted && !found->content;
    if (is_blob && !blobs->Read(found->output).ok()) continue;  // it was lost or damaged: the task is done again
    task.known = KnownResult{found->state, found->output, absl::OkStatus()};
    if (found->state != TaskState::kCommitted) task.known->error = ErrorOf(found->error);
    if (found->content) bytes += found->content->size();
    if (found->content && bytes > kMostKnownBytes && blobs->Put(*found->content).ok()) found->content.reset();
    contents.push_back(std::move(found->content));
  }
  return contents;
}

absl::Status CoordinatorImpl::Restore() {
  for (const SetAsideRecord& aside : journal_->TakeSetAside()) trust_.SetAside(aside.worker, aside.reason);
  for (JobRecord& record : journal_->TakeJobs()) {
    const int64_t number = record.number;
    // One job's damage is not that of the others.
    if (const absl::Status status = RestoreJob(std::move(record)); !status.ok()) {
      TILEMEND_RETURN_IF_ERROR(RestoreAsFailed(number, status));
    }
  }
  {
    Lock lock(mutex_);  // the runners are at work
    ShowMetrics();
  }
  return SweepFolders();
}

absl::Status CoordinatorImpl::RestoreJob(JobRecord record) {
  v1::Job message;
  if (record.damaged || !message.ParseFromString(record.body)) {
    return absl::DataLossError(absl::StrCat("its record in the journal of ", options_.work_folder, " is damaged"));
  }
  ToldJob told = JobFromProto(message);
  told.job.number = record.number;
  told.job.request_id = std::move(record.request_id);
  const std::string id = told.job.id;
  if (!record.over) told.job.progress.phase = kResumePhase;
  // The lock is for the runners of the jobs before.
  Lock lock(mutex_);
  TILEMEND_RETURN_IF_ERROR(Apply(JobRestored{std::move(told.job)}).status());
  JobEntry& entry = entries_[id];
  entry.spec = std::move(told.spec);
  entry.out_key = OutKey(entry.spec);
  entry.origin = std::move(told.origin);
  entry.outcome = std::move(told.outcome);
  entry.error = std::move(told.error);
  if (record.over) events_.JobRemembered(*state_.FindJob(id));
  if (record.over && record.released) return absl::OkStatus();
  const auto mode = record.over ? JobRunner::Mode::kRelease : JobRunner::Mode::kResume;
  if (!record.over) {
    TILEMEND_ASSIGN_OR_RETURN(entry.blobs, BlobFolder::Create(FolderOf(id)));
    TILEMEND_ASSIGN_OR_RETURN(const std::vector<std::string> outputs, journal_->Outputs(record.number));
    TILEMEND_RETURN_IF_ERROR(entry.blobs->KeepOnly({outputs.begin(), outputs.end()}));
    FailPoint("restore.swept");
    entry.resuming = true;
    events_.JobRestored(*state_.FindJob(id), entry.origin);
  }
  entry.runner = std::make_unique<JobRunner>(entry.spec, factory_, entry.blobs, SinkOf(id), mode);
  return absl::OkStatus();
}

absl::Status CoordinatorImpl::RestoreAsFailed(int64_t number, const absl::Status& why) {
  Lock lock(mutex_);
  const auto known = state_.job_numbers().find(number);
  const std::string id = known != state_.job_numbers().end() ? known->second : absl::StrCat("damaged-", number);
  if (known == state_.job_numbers().end()) {
    Job job;
    job.id = id;
    job.number = number;
    job.created = options_.clock();
    TILEMEND_RETURN_IF_ERROR(Apply(JobRestored{std::move(job)}).status());
  }
  JobEntry& entry = entries_[id];
  entry.blobs.reset();  // its folder is swept
  entry.error = absl::Status(why.code(), absl::StrCat("the job cannot go on after a restart of the coordinator: ",
                                                      std::string(why.message()), "; submit it again"));
  TILEMEND_RETURN_IF_ERROR(Apply(JobFinished{id, JobState::kFailed, options_.clock()}).status());
  PutJob(*state_.FindJob(id), true);
  return absl::OkStatus();
}

void CoordinatorImpl::ForgetOldJobs(absl::Time now) {
  if (state_.job_numbers().empty()) return;
  const int64_t newest = state_.job_numbers().rbegin()->first;  // stays, or its number would be given out again
  size_t over = state_.job_numbers().size() - state_.running().size();
  std::vector<std::string> old;
  for (const auto& [number, id] : state_.job_numbers()) {
    const Job& job = *state_.FindJob(id);
    if (!IsOver(job.state) || entries_.at(id).runner != nullptr || number == newest) continue;
    if (over <= kMostJobsOver && job.ended + options_.keep_jobs > now) continue;
    --over;
    old.push_back(id);
    journal_->DropJob(number);
  }
  for (const std::string& id : old) {
    Apply(JobForgotten{id}).IgnoreError();
    entries_.erase(id);
  }
  if (!old.empty()) job_changed_.notify_all();
}

absl::Status CoordinatorImpl::SweepFolders() {
  if (!journal_->is_durable()) return absl::OkStatus();
  namespace fs = std::filesystem;
  std::error_code error;
  std::vector<fs::path> old;
  const fs::path jobs = fs::path(options_.work_folder) / "jobs";
  if (!fs::exists(jobs, error)) return absl::OkStatus();
  {
    Lock lock(mutex_);
    for (fs::directory_iterator at(jobs, error), end; !error && at != end; at.increment(error)) {
      const auto entry = entries_.find(at->path().filename().string());
      if (entry == entries_.end() || entry->second.blobs == nullptr) old.push_back(at->path());
    }
  }
  // Some disks take minutes for many files: what is not done soon is done while jobs run.
  const SteadyTime deadline = std::chrono::steady_clock::now() + std::chrono::seconds(1);
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
