#include "coordinator/api/work_handler.h"

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <random>
#include <set>
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
#include "coordinator/store/blob_folder.h"

namespace tilemend {
namespace {

constexpr int32_t kMaxThreads = 2048;
constexpr size_t kMostNameBytes = 256;

// Each takes some 20 kB, and what it says.
constexpr size_t kMostSyncs = 4096;

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

v1::TaskRef RefOf(const TaskKey& key, uint64_t token) {
  v1::TaskRef ref;
  ref.set_job(key.job);
  ref.set_task(key.task);
  ref.set_attempt_token(token);
  return ref;
}

// Of an attempt. Nobody is to guess it.
uint64_t NewToken() {
  std::random_device random;
  const uint64_t token = static_cast<uint64_t>(random()) << 32 | random();
  return token == 0 ? 1 : token;
}

v1::Task TaskMessage(const TaskKey& key, const Task& task, const Lease& lease) {
  v1::Task message;
  *message.mutable_ref() = RefOf(key, lease.token);
  message.mutable_cell()->set_col(task.cell.col);
  message.mutable_cell()->set_row(task.cell.row);
  message.set_stage(static_cast<v1::Stage>(task.stage));
  message.set_attempt(task.attempts);
  message.mutable_input()->set_digest(task.input);
  return message;
}

bool IsSameCaller(const WorkerCaller& known, const v1::SyncRequest& request, const std::string& identity) {
  return known.secret == request.secret() && known.identity == identity;
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
      updates_(updates),
      journal_(journal),
      results_(cluster, updates),
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
  if (!request.finished().empty()) {
    const ClusterLock lock(cluster_.mutex);
    StartCheck(*sync, 1);
  }
  checks_.Add(std::move(sync));
}

void WorkHandler::Gone(const std::string& worker) {
  const ClusterLock lock(cluster_.mutex);
  waiting_.Look(worker);
}

absl::Status WorkHandler::Refusal(const v1::SyncRequest& request) {
  const absl::Status other = CheckProgram(request, cluster_.options.build);
  if (other.ok()) return CheckSync(request);
  const ClusterLock lock(cluster_.mutex);
  cluster_.events.WorkerRefused(Shown(request.worker()), Shown(request.release()), other, cluster_.options.clock());
  return other;
}

void WorkHandler::StartCheck(const WorkerSync& sync, int change) {
  const auto caller = cluster_.callers.find(sync.request.worker());
  if (caller == cluster_.callers.end() || !IsSameCaller(caller->second, sync.request, sync.identity)) return;
  caller->second.calls = std::max(0, caller->second.calls + change);
  // Its silence begins when it has been looked at.
  const WorkerRecord* worker = cluster_.state.FindWorker(sync.request.worker());
  if (worker == nullptr) return;
  updates_.Apply(WorkerSeen{worker->id, worker->threads, worker->draining, cluster_.options.clock(), worker->prefetch})
      .IgnoreError();
  RenewHeld(sync.request);
}

void WorkHandler::Check(const std::shared_ptr<WorkerSync>& sync) {
  if (sync->request.finished().empty()) return Enter(sync, {});
  // Whoever has waited too long in the queue reports them again.
  std::vector<ResultIntake::Report> reports;
  if (sync->alive()) reports = results_.Prepare(sync->request);
  {
    const ClusterLock lock(cluster_.mutex);
    StartCheck(*sync, -1);
  }
  Enter(sync, std::move(reports));
}

void WorkHandler::Enter(const std::shared_ptr<WorkerSync>& sync, std::vector<ResultIntake::Report> reports) {
  ClusterLock lock(cluster_.mutex);
  const absl::Status status = TakeAll(*sync, std::move(reports), lock);
  if (!status.ok()) return answers_.Add({sync, status});
  const absl::Duration wait = std::clamp(absl::Milliseconds(sync->request.wait_ms()), absl::ZeroDuration(), kMaxPoll);
  sync->deadline = std::chrono::steady_clock::now() + absl::ToChronoMilliseconds(wait);
  if (!TryToAnswer(sync)) waiting_.Add(sync);
}

absl::Status WorkHandler::TakeAll(WorkerSync& sync, std::vector<ResultIntake::Report> reports, ClusterLock& lock) {
  const v1::SyncRequest& request = sync.request;
  TILEMEND_RETURN_IF_ERROR(CheckSecret(request, sync.identity));
  uint64_t& sequence = cluster_.callers[request.worker()].sequence;
  sequence = std::max(sequence, request.sequence());
  waiting_.Look(request.worker());  // an older call of this worker ends
  const bool is_new = cluster_.state.FindWorker(request.worker()) == nullptr;
  TILEMEND_RETURN_IF_ERROR(updates_
                               .Apply(WorkerSeen{request.worker(), request.threads(), request.draining(),
                                                 cluster_.options.clock(), request.prefetch()})
                               .status());
  if (is_new) {
    cluster_.events.WorkerCame(*cluster_.state.FindWorker(request.worker()), request.release(), sync.identity);
    cluster_.ShowMetrics();
  }
  TakeResults(request, std::move(reports), lock, sync.response);
  if (const std::vector<std::string> unseen = TakeSeen(request); !unseen.empty()) {
    lock.unlock();
    FailJobsThatAreGone(unseen);
    lock.lock();
  }
  return absl::OkStatus();
}

bool WorkHandler::TryToAnswer(const std::shared_ptr<WorkerSync>& sync) {
  const std::optional<absl::Status> end = EndOf(*sync);
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

void WorkHandler::TakeResults(const v1::SyncRequest& request, std::vector<ResultIntake::Report> reports,
                              ClusterLock& lock, v1::SyncResponse& response) {
  const std::vector<ResultIntake::Discarded> discarded = results_.Take(request.worker(), std::move(reports), response);
  RenewHeld(request);
  if (discarded.empty()) return;
  lock.unlock();
  ResultIntake::Remove(discarded);
  lock.lock();
}

absl::Status WorkHandler::CheckSecret(const v1::SyncRequest& request, const std::string& identity) {
  const WorkerCaller caller{0, request.secret(), request.release(), identity, cluster_.options.clock()};
  const WorkerCaller& known = cluster_.callers.try_emplace(request.worker(), caller).first->second;
  if (IsSameCaller(known, request, identity)) return absl::OkStatus();
  return WithErrorInfo(
      absl::PermissionDeniedError(absl::StrCat("another process is worker ", Printable(request.worker()))),
      {"WORKER_SECRET", {}});
}

std::vector<std::string> WorkHandler::TakeSeen(const v1::SyncRequest& request) {
  std::vector<std::string> unseen;
  std::set<std::string> told;
  for (const v1::FoldersSeen& seen : request.seen()) {
    if (!told.insert(seen.job()).second) continue;  // a worker says it once
    const auto warning = cluster_.trust.TakeSeen(request.worker(), seen, cluster_.options.clock());
    if (!warning) continue;
    updates_.Warn(seen.job(), *warning);
    cluster_.events.WorkerBlind(request.worker(), seen.job(), *warning);
    unseen.push_back(seen.job());
  }
  cluster_.metrics.ShowTrust(cluster_.trust.set_aside(), cluster_.trust.blind());
  return unseen;
}

// A job whose folders the coordinator does not see either any more, or where it cannot write, has no worker to wait
// for.
void WorkHandler::FailJobsThatAreGone(const std::vector<std::string>& jobs) {
  for (const std::string& job : jobs) {
    JobFolders folders;
    {
      ClusterLock lock(cluster_.mutex);
      const JobFolders* known = cluster_.trust.FoldersOf(job);
      if (known == nullptr) continue;
      folders = *known;
    }
    const absl::Status fault = TryFolders(folders);
    if (fault.ok()) continue;
    ClusterLock lock(cluster_.mutex);
    const auto entry = cluster_.jobs.find(job);
    if (entry == cluster_.jobs.end() || entry->second.runner == nullptr) continue;
    entry->second.runner->Fail(fault);
  }
}

void WorkHandler::RenewHeld(const v1::SyncRequest& request) {
  const absl::Time deadline = cluster_.options.clock() + cluster_.options.lease;
  const std::set<uint64_t> begun(request.begun().begin(), request.begun().end());
  for (const v1::TaskRef& ref : request.held()) {
    const uint64_t token = ref.attempt_token();
    // Fails if the lease was lost; TellState then leaves the task out.
    updates_.Apply(LeaseRenewed{KeyOf(ref), request.worker(), token, deadline, begun.contains(token)}).IgnoreError();
  }
  for (const v1::FinishedTask& finished : request.finished()) {  // whose results are not taken yet
    const v1::TaskRef& ref = finished.ref();
    updates_.Apply(LeaseRenewed{KeyOf(ref), request.worker(), ref.attempt_token(), deadline, true}).IgnoreError();
  }
}

std::optional<absl::Status> WorkHandler::EndOf(WorkerSync& sync) {
  const v1::SyncRequest& request = sync.request;
  v1::SyncResponse& response = sync.response;
  const auto caller = cluster_.callers.find(request.worker());
  if (caller == cluster_.callers.end() || caller->second.sequence > request.sequence()) {
    return absl::AbortedError("a newer call of this worker took over");
  }
  if (!sync.alive()) return absl::CancelledError("the worker went away");
  if (request.draining() && request.held().empty()) {
    updates_.Apply(WorkerLeft{request.worker()}).IgnoreError();
    cluster_.ForgetWorker(request.worker());
    cluster_.events.WorkerLeft(request.worker());
    cluster_.ShowMetrics();
    response.set_leave(true);
    return absl::OkStatus();
  }
  TellState(request, response);
  const bool news = response.start_size() > 0 || response.look_size() > 0 || response.acknowledged_size() > 0 ||
                    response.keep_size() < request.held_size();
  if (cluster_.stopping && !news) return absl::UnavailableError("the coordinator is shutting down");
  if (news || std::chrono::steady_clock::now() >= sync.deadline) return absl::OkStatus();
  return std::nullopt;
}

void WorkHandler::TellState(const v1::SyncRequest& request, v1::SyncResponse& response) {
  response.clear_start();
  response.clear_keep();
  response.clear_look();
  response.set_set_aside(cluster_.trust.WhySetAside(request.worker()));
  if (!cluster_.stopping && !request.draining()) TellToLook(request, response);
  if (!cluster_.stopping) LeaseTasks(request.worker());
  const WorkerRecord* worker = cluster_.state.FindWorker(request.worker());
  if (worker == nullptr) return;  // it was lost while it waited; its next call makes it known again
  std::set<uint64_t> known;
  for (const v1::TaskRef& ref : request.held()) {
    const Task* task = cluster_.state.FindTask(KeyOf(ref));
    if (task == nullptr || FindLease(*task, request.worker(), ref.attempt_token()) == nullptr) continue;
    known.insert(ref.attempt_token());
    *response.add_keep() = ref;
  }
  // Also what it was given before, if that answer was lost.
  for (const TaskKey& key : worker->held) {
    const Task& task = *cluster_.state.FindTask(key);
    const Lease& lease = *LeaseOf(task, request.worker());
    if (known.contains(lease.token)) continue;
    v1::Task message = TaskMessage(key, task, lease);
    message.set_trace(cluster_.jobs.at(key.job).origin.trace);
    *response.add_start() = std::move(message);
  }
}

void WorkHandler::TellToLook(const v1::SyncRequest& request, v1::SyncResponse& response) const {
  std::set<std::string> busy;
  for (const v1::FoldersSeen& seen : request.seen()) {
    if (seen.looking()) busy.insert(seen.job());
  }
  for (v1::JobFolders& folders : cluster_.trust.ToLookAt(request.worker(), busy, cluster_.options.clock())) {
    *response.add_look() = std::move(folders);
  }
}

void WorkHandler::LeaseTasks(const std::string& worker) {
  const absl::Time now = cluster_.options.clock();
  for (const TaskKey& key : ChooseTasks(cluster_.state, worker, now, cluster_.MayWorkNow())) {
    const Stage stage = cluster_.state.FindTask(key)->stage;
    const Job& job = *cluster_.state.FindJob(key.job);
    const bool starts = job.started == absl::InfiniteFuture();
    if (!updates_.Apply(TaskLeased{key, worker, NewToken(), now, now + cluster_.options.lease}).ok()) continue;
    cluster_.metrics.Started(stage);
    if (!starts) continue;
    journal_.PutJob(job, false);
    cluster_.events.JobStarted(job, cluster_.jobs.at(key.job).origin);
  }
}

}  // namespace tilemend
