#include "coordinator/api/result_intake.h"

#include <cstddef>
#include <cstdint>
#include <utility>

#include "absl/strings/str_cat.h"
#include "common/rpc/status_proto.h"
#include "common/store/digest.h"
#include "common/util/error_info.h"
#include "common/util/status_macros.h"
#include "common/util/text.h"
#include "coordinator/api/task_ref.h"
#include "coordinator/jobs/job_journal.h"
#include "coordinator/store/attempt_folder.h"

namespace tilemend {
namespace {

constexpr size_t kMostErrorBytes = 2048;

// Small outputs that wait for a slow pipeline go to disk beyond this.
constexpr size_t kMaxQueuedBytes = size_t{64} << 20;

bool IsInline(const v1::BlobRef& blob) { return blob.size() == static_cast<int64_t>(blob.content().size()); }

// As long as a digest, whatever the worker says.
std::string DigestOf(const v1::BlobRef& blob) {
  if (IsInline(blob)) return Sha256Hex(blob.content());
  return IsDigest(blob.digest()) ? blob.digest() : Sha256Hex(blob.digest());
}

bool IsMachineError(const absl::Status& status) {
  return absl::IsUnavailable(status) || absl::IsResourceExhausted(status);
}

// What a stranger says goes wrong is kept for as long as the job is, and shown on terminals.
absl::Status Bounded(const absl::Status& error) {
  const std::optional<ErrorInfo> info = GetErrorInfo(error);
  size_t bytes = info ? info->reason.size() : 0;
  if (info) {
    for (const auto& [key, value] : info->metadata) bytes += key.size() + value.size();
  }
  const absl::Status bounded(error.code(), Printable(std::string(error.message().substr(0, kMostErrorBytes))));
  return info && bytes <= kMostErrorBytes ? WithErrorInfo(bounded, *info) : bounded;
}

bool IsAboutFiles(const absl::Status& status) { return absl::IsNotFound(status) || absl::IsPermissionDenied(status); }

}  // namespace

std::vector<ResultIntake::Report> ResultIntake::Prepare(v1::SyncRequest& request) {
  std::vector<Report> reports;
  reports.reserve(static_cast<size_t>(request.finished_size()));
  for (v1::FinishedTask& finished : *request.mutable_finished()) {
    reports.push_back(PrepareReport(request.worker(), finished));
  }
  return reports;
}

ResultIntake::Report ResultIntake::PrepareReport(const std::string& worker, v1::FinishedTask& finished) {
  Report report{finished.ref(), static_cast<Stage>(finished.stage()), {}, std::nullopt};
  const TaskKey key = KeyOf(finished.ref());
  const uint64_t token = finished.ref().attempt_token();
  const std::optional<Holding> lease = HoldingOf(worker, finished.ref());
  report.held = lease.has_value();
  if (finished.has_output()) {
    report.event = TaskCompleted{key, worker, token, DigestOf(finished.output()), {}};
    if (cluster_.options.attempts_of && IsInline(finished.output())) {
      report.files = cluster_.options.attempts_of(report.stage, finished.output().content());
    }
    if (lease) PrepareOutput(worker, *lease, *finished.mutable_output(), report);
    return report;
  }
  absl::Status error = Bounded(StatusFromProto(finished.error()));
  if (error.ok()) error = absl::UnknownError("the worker reported neither an output nor an error");
  const bool machine = IsMachineError(error);
  report.event = TaskFailed{key, worker, token, machine, false, std::move(error), {}};
  return report;
}

std::optional<ResultIntake::Holding> ResultIntake::HoldingOf(const std::string& worker, const v1::TaskRef& ref) {
  ClusterLock lock(cluster_.mutex);
  const Task* task = cluster_.state.FindTask(KeyOf(ref));
  if (task == nullptr || FindLease(*task, worker, ref.attempt_token()) == nullptr) return std::nullopt;
  const JobEntry& entry = cluster_.jobs.at(ref.job());
  if (entry.blobs == nullptr) return std::nullopt;
  const bool queue_full = entry.runner != nullptr && entry.runner->inbox().queued_bytes() > kMaxQueuedBytes;
  return Holding{task->cell, task->stage, task->input, entry.blobs, queue_full};
}

// Puts down in the report what is to become of an output.
void ResultIntake::PrepareOutput(const std::string& worker, const Holding& lease, v1::BlobRef& output, Report& report) {
  const TaskKey key = KeyOf(report.ref);
  const uint64_t token = report.ref.attempt_token();
  if (const absl::Status status = Bounded(CheckOutput(lease, output)); absl::IsDataLoss(status)) {
    report.refusal =
        absl::StrCat("the result of worker ", Printable(worker), " for cell ", ToString(lease.cell), ", stage ",
                     std::string(StageName(lease.stage)), ", is wrong: ", std::string(status.message()));
    const absl::Status error = WithErrorInfo(absl::InternalError(report.refusal), {"RESULT_REFUSED", {}});
    report.event = TaskFailed{key, worker, token, true, false, error, {}, DigestOf(output)};
  } else if (!status.ok()) {
    report.event = TaskFailed{key, worker, token, true, false, absl::UnavailableError(status.message()), {}};
  } else if (const absl::Status kept = KeepOutput(lease, output, report); !kept.ok()) {
    report.event = TaskFailed{key, worker, token, true, false, kept, {}};
  }
}

// The content of an output goes to the job from memory, unless its queue is full, and into a file if it is too large
// for the journal.
absl::Status ResultIntake::KeepOutput(const Holding& lease, v1::BlobRef& output, Report& report) const {
  if (!IsInline(output)) return absl::OkStatus();
  const bool is_large = cluster_.journal->is_durable() && output.content().size() > kMostJournalledBytes;
  if (lease.queue_full || is_large) {
    const std::string& digest = std::get<TaskCompleted>(report.event).output;
    const absl::Status put = lease.blobs->Put(output.content(), OutputSync(cluster_), digest).status();
    if (is_large && !put.ok()) return IsMachineError(put) ? put : absl::UnavailableError(put.message());
    if (lease.queue_full && put.ok()) return absl::OkStatus();
  }
  report.content = std::move(*output.mutable_content());
  return absl::OkStatus();
}

absl::Status ResultIntake::CheckOutput(const Holding& lease, const v1::BlobRef& output) const {
  if (!IsInline(output) && !IsDigest(output.digest())) return absl::DataLossError("a blob without a digest");
  if (!IsInline(output) && !lease.blobs->Size(output.digest()).ok()) {
    return absl::UnavailableError(absl::StrCat("blob ", output.digest(), " did not arrive"));
  }
  if (!cluster_.options.check_result) return absl::OkStatus();
  TILEMEND_ASSIGN_OR_RETURN(const std::string input, lease.blobs->Read(lease.input));
  if (IsInline(output)) return cluster_.options.check_result(lease.stage, input, output.content());
  TILEMEND_ASSIGN_OR_RETURN(const std::string bytes, lease.blobs->Read(output.digest()));
  return cluster_.options.check_result(lease.stage, input, bytes);
}

std::vector<ResultIntake::Discarded> ResultIntake::Take(const std::string& worker, std::vector<Report> reports,
                                                        v1::SyncResponse& response) {
  std::vector<Discarded> discarded;
  for (Report& report : reports) {
    const int64_t bytes = report.content.has_value() ? static_cast<int64_t>(report.content->size()) : 0;
    const bool is_taken = TakeReport(worker, report);
    if (is_taken) {
      cluster_.metrics.BlobReceived(bytes);
    } else {
      cluster_.metrics.Refused(report.stage, true);
    }
    const JobFolders* folders = cluster_.trust.FoldersOf(report.ref.job());
    const auto job = cluster_.jobs.find(report.ref.job());
    // A result that was accepted before the job began again looks like a late one: its files may be wanted.
    const bool is_late = !is_taken && job != cluster_.jobs.end() && !job->second.began_again;
    if ((is_late || !report.refusal.empty()) && folders != nullptr && !report.files.empty()) {
      discarded.push_back({folders->attempts, std::move(report.files)});
    }
    *response.add_acknowledged() = std::move(report.ref);
  }
  return discarded;
}

void ResultIntake::Remove(const std::vector<Discarded>& discarded) {
  for (const Discarded& of_attempt : discarded) {
    for (const std::string& file : of_attempt.files) AttemptFolder::Discard(of_attempt.attempts, file);
  }
}

// False if it comes too late, or from one that does not hold the task.
bool ResultIntake::TakeReport(const std::string& worker, Report& report) {
  const Task* task = cluster_.state.FindTask(KeyOf(report.ref));
  if (!report.held && task != nullptr && task->state == TaskState::kLeased) return false;
  auto* failed = std::get_if<TaskFailed>(&report.event);
  if (failed != nullptr) {
    failed->time = cluster_.options.clock();
    // One that has yet to look at the folders counts: it may be the only one that can.
    const MayWork may = [this, now = failed->time](const std::string& id, const std::string& job) {
      return !cluster_.trust.IsBarred(id, job) && !cluster_.trust.SeemsStuck(id, job, now);
    };
    failed->another =
        task != nullptr && HasAnother(cluster_.state, worker, *cluster_.state.FindJob(report.ref.job()), *task, may);
    // A file that one machine cannot read another may.
    failed->machine = failed->machine || (failed->another && IsAboutFiles(failed->error));
  } else {
    std::get<TaskCompleted>(report.event).time = cluster_.options.clock();
  }
  const std::optional<Task> before = failed != nullptr && task != nullptr ? std::optional(*task) : std::nullopt;
  TaskContents contents;
  contents.push_back(std::move(report.content));  // a list of one would copy it
  const auto effects = updates_.Apply(report.event, std::move(contents));
  if (!effects.ok()) return false;
  if (before) {
    cluster_.events.AttemptFailed(*before, report.ref.job(), worker, cluster_.jobs.at(report.ref.job()).origin,
                                  failed->error);
  }
  if (failed != nullptr && ErrorReason(failed->error) == "FOLDER_NOT_SEEN")
    cluster_.trust.Doubt(worker, report.ref.job());
  if (!report.refusal.empty()) {
    cluster_.metrics.Refused(report.stage, false);
    updates_.Warn(report.ref.job(), report.refusal);
  }
  return true;
}

}  // namespace tilemend
