#include "coordinator/api/work_handler.h"

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <iterator>
#include <optional>
#include <thread>
#include <utility>

#include "absl/strings/str_cat.h"
#include "common/rpc/limits.h"
#include "common/util/error_info.h"
#include "common/util/status_macros.h"
#include "common/util/text.h"
#include "common/util/version.h"
#include "coordinator/api/task_ref.h"
#include "coordinator/state/task_choice.h"

namespace tilemend {
namespace {

constexpr int32_t kMaxThreads = 2048;
constexpr size_t kMostNameBytes = 256;

// Each takes some 20 kB, and what it says.
constexpr size_t kMostSyncs = 4096;

// Calls that wait until what they report is checked. Beyond that it stays with its worker, which reports it again.
constexpr int64_t kMostUncheckedBytes = int64_t{64} << 20;

// All that is told at once waits for the disk once, so that two threads answer.
constexpr size_t kAnswering = 2;

// Checks read files and compute.
size_t CheckingThreads() { return std::clamp<size_t>(std::thread::hardware_concurrency(), 4, 16); }

// Of another protocol anything may be said.
std::string Shown(const std::string& text) { return Printable(text.substr(0, kMostNameBytes)); }

// Whether results of the worker's program fit to those of others here.
absl::Status CheckProgram(const v1::SyncRequest& request, const std::string& build) {
  const std::string worker = Shown(request.worker()), have = Shown(request.build());
  if (request.protocol() != kProtocolVersion) {
    return WithErrorInfo(
        absl::FailedPreconditionError(absl::StrCat("worker ", worker, " speaks protocol ", request.protocol(),
                                                   ", this coordinator ", kProtocolVersion, "; use the same release")),
        {"PROTOCOL_VERSION", {{"want", absl::StrCat(kProtocolVersion)}, {"have", absl::StrCat(request.protocol())}}});
  }
  if (request.build() == build) return absl::OkStatus();
  return WithErrorInfo(absl::FailedPreconditionError(absl::StrCat(
                           "worker ", worker, " is of build ", have, " (", Shown(request.release()),
                           "), this coordinator of ", build, " (", Version(), "); use programs of the same build")),
                       {"OTHER_BUILD", {{"want", build}, {"have", have}}});
}

absl::Status CheckSync(const v1::SyncRequest& request) {
  if (std::max({request.worker().size(), request.secret().size(), request.release().size()}) > kMostNameBytes) {
    return absl::InvalidArgumentError(
        absl::StrCat("a worker's id, secret and release have at most ", kMostNameBytes, " bytes"));
  }
  const auto in_range = [](int32_t tasks) { return tasks >= 0 && tasks <= kMaxThreads; };
  if (request.worker().empty() || !in_range(request.threads()) || !in_range(request.prefetch())) {
    return absl::InvalidArgumentError(
        absl::StrCat("a worker needs an id, 0 to ", kMaxThreads, " threads and as many tasks beyond them"));
  }
  return absl::OkStatus();
}

int64_t BytesOf(const v1::SyncRequest& request) { return static_cast<int64_t>(request.ByteSizeLong()); }

// All but the attempts they are of. The call may yet wait for long.
void LetGoOfResults(v1::SyncRequest& request) {
  for (v1::FinishedTask& finished : *request.mutable_finished()) finished.clear_result();
}

absl::Status TooManyResults() {
  return WithErrorInfo(
      absl::ResourceExhaustedError(absl::StrCat("results of ", kMostUncheckedBytes >> 20,
                                                " MiB wait to be checked, which is the limit; try again in a second")),
      {"TOO_MANY_CALLS", {{"limit", absl::StrCat(kMostUncheckedBytes)}, {"retry_after_s", "1"}}});
}

using InputFolders = std::map<std::string, std::shared_ptr<BlobFolder>>;  // by job

// Needs the lock.
InputFolders BlobsOf(const Cluster& cluster, const v1::SyncResponse& response) {
  InputFolders blobs;
  for (const v1::Task& task : response.start()) blobs[task.ref().job()] = cluster.jobs.at(task.ref().job()).blobs;
  return blobs;
}

// Puts small inputs of tasks into the answer, which saves a call for each. Without the lock.
void InlineInputs(Cluster& cluster, const InputFolders& blobs, v1::SyncResponse& response) {
  size_t left = kMaxInlineBytesPerSync;
  for (v1::Task& task : *response.mutable_start()) {
    const auto& folder = blobs.at(task.ref().job());
    if (folder == nullptr) continue;
    v1::BlobRef& input = *task.mutable_input();
    const auto size = folder->Size(input.digest());
    input.set_size(size.value_or(-1));  // no size: not inside, so that nobody takes it for empty
    if (!size.ok()) continue;           // the job has just ended, and the worker is told so next time; or it was lost
    if (static_cast<size_t>(*size) > std::min(left, kInlineBlobBytes)) continue;
    auto content = folder->Read(input.digest());
    if (!content.ok()) continue;
    left -= content->size();
    cluster.metrics.BlobSent(*size);
    input.set_content(*std::move(content));
  }
}

}  // namespace

WorkHandler::WorkHandler(Cluster& cluster, StateUpdates& updates, const JobJournal& journal)
    : cluster_(cluster),
      reports_(cluster, updates),
      news_(cluster, updates, journal),
      calls_(kMostSyncs),
      answers_(kAnswering, kMostSyncs, [this](std::vector<Answer> answers) { Give(std::move(answers)); }),
      waiting_(cluster, [this](const std::shared_ptr<WorkerSync>& sync) { return TryToAnswer(sync); }),
      checks_(CheckingThreads(), 1,
              [this](const std::vector<std::shared_ptr<WorkerSync>>& one) { Check(one.front()); }) {}

WorkHandler::~WorkHandler() { checks_.Finish(); }  // whose calls go on to wait

void WorkHandler::Sync(std::shared_ptr<WorkerSync> sync) {
  const v1::SyncRequest& request = sync->request;
  absl::Status refused = Refusal(request);
  if (refused.ok()) {
    auto call = calls_.Enter("", cluster_.options.clock(), [] {});
    refused = call.status();
    if (call.ok()) sync->call = *std::move(call);
  }
  if (!refused.ok()) return sync->answer(refused);
  if (request.finished().empty() && request.seen().empty()) return Enter(sync, {});
  if (!HasRoomFor(*sync)) return sync->answer(TooManyResults());
  checks_.Add(std::move(sync));
}

bool WorkHandler::HasRoomFor(const WorkerSync& sync) {
  const int64_t bytes = BytesOf(sync.request);
  const ClusterLock lock(cluster_.mutex);
  const bool fits = unchecked_bytes_ == 0 || unchecked_bytes_ + bytes <= kMostUncheckedBytes;
  if (fits) unchecked_bytes_ += bytes;
  reports_.CountChecks(sync, fits ? 1 : 0);  // it has been heard in any case
  return fits;
}

void WorkHandler::Gone(const std::string& worker) {
  const ClusterLock lock(cluster_.mutex);
  waiting_.TryCallsOf(worker);
}

absl::Status WorkHandler::Refusal(const v1::SyncRequest& request) {
  absl::Status other = CheckProgram(request, cluster_.options.build);
  if (other.ok()) return CheckSync(request);
  const ClusterLock lock(cluster_.mutex);
  cluster_.events.WorkerRefused(Shown(request.worker()), Shown(request.release()), other, cluster_.options.clock());
  return other;
}

void WorkHandler::Check(const std::shared_ptr<WorkerSync>& sync) {
  const int64_t bytes = BytesOf(sync->request);
  // A worker that hung up reports them again if it lives. If not, its leases end, and others do the tasks.
  std::vector<ResultIntake::Report> reports;
  if (sync->alive()) reports = reports_.Check(sync->request);
  LetGoOfResults(sync->request);
  {
    const ClusterLock lock(cluster_.mutex);
    reports_.CountChecks(*sync, -1);
    unchecked_bytes_ -= bytes;
  }
  Enter(sync, std::move(reports));
}

void WorkHandler::Enter(const std::shared_ptr<WorkerSync>& sync, std::vector<ResultIntake::Report> reports) {
  ClusterLock lock(cluster_.mutex);
  absl::Status status = reports_.TakeOver(sync->request, sync->identity);
  if (status.ok()) {
    waiting_.TryCallsOf(sync->request.worker());  // an older call of this worker ends
    status = reports_.Take(*sync, std::move(reports), lock);
  }
  if (!status.ok()) return answers_.Add({sync, status});
  const absl::Duration wait = std::clamp(absl::Milliseconds(sync->request.wait_ms()), absl::ZeroDuration(), kMaxPoll);
  sync->deadline = std::chrono::steady_clock::now() + absl::ToChronoMilliseconds(wait);
  if (!TryToAnswer(sync)) waiting_.Add(sync);
}

bool WorkHandler::TryToAnswer(const std::shared_ptr<WorkerSync>& sync) {
  const std::optional<absl::Status> end = news_.EndOf(*sync);
  if (!end) return false;
  answers_.Add({sync, *end, end->ok() ? BlobsOf(cluster_, sync->response) : InputFolders()});
  return true;
}

// All of them wait for the disk together.
void WorkHandler::Give(std::vector<Answer> answers) {
  cluster_.journal->Await();
  for (Answer& answer : answers) {
    if (!answer.status.ok()) {
      answer.sync->answer(answer.status);
      continue;
    }
    InlineInputs(cluster_, answer.blobs, answer.sync->response);
    answer.sync->answer(std::move(answer.sync->response));
  }
}

}  // namespace tilemend
