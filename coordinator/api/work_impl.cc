// The worker's side of CoordinatorImpl: Sync and blobs.
#include <algorithm>
#include <optional>
#include <random>
#include <set>
#include <utility>

#include "absl/strings/str_cat.h"
#include "common/rpc/limits.h"
#include "common/rpc/status_proto.h"
#include "common/store/digest.h"
#include "common/store/fingerprint.h"
#include "common/util/error_info.h"
#include "common/util/status_macros.h"
#include "common/util/text.h"
#include "common/util/version.h"
#include "coordinator/api/coordinator_impl.h"

namespace tilemend {
namespace {

constexpr int32_t kMaxThreads = 2048;
constexpr size_t kMostNameBytes = 256;
constexpr size_t kMostErrorBytes = 2048;

// Small outputs that wait for a slow pipeline go to disk beyond this.
constexpr size_t kMaxQueuedBytes = size_t{64} << 20;

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

TaskKey KeyOf(const v1::TaskRef& ref) { return {ref.job(), ref.task()}; }

v1::TaskRef RefOf(const TaskKey& key, uint64_t token) {
  v1::TaskRef ref;
  ref.set_job(key.job);
  ref.set_task(key.task);
  ref.set_attempt_token(token);
  return ref;
}

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

}  // namespace

absl::StatusOr<v1::SyncResponse> CoordinatorImpl::Sync(const v1::SyncRequest& request,
                                                       const std::function<bool()>& alive,
                                                       const std::string& identity) {
  if (const absl::Status other = CheckProgram(request, options_.build); !other.ok()) {
    Lock lock(mutex_);
    events_.WorkerRefused(Shown(request.worker()), Shown(request.release()), other, options_.clock());
    return other;
  }
  TILEMEND_RETURN_IF_ERROR(CheckSync(request));
  std::vector<Report> reports = PrepareReports(request);
  v1::SyncResponse response;
  std::map<std::string, std::shared_ptr<BlobFolder>> blobs;
  {
    Lock lock(mutex_);
    TILEMEND_RETURN_IF_ERROR(CheckSecret(request, identity));
    uint64_t& sequence = callers_[request.worker()].sequence;
    sequence = std::max(sequence, request.sequence());
    work_changed_.notify_all();  // an older call of this worker ends
    const bool is_new = state_.FindWorker(request.worker()) == nullptr;
    TILEMEND_RETURN_IF_ERROR(
        Apply(WorkerSeen{request.worker(), request.threads(), request.draining(), options_.clock(), request.prefetch()})
            .status());
    if (is_new) {
      events_.WorkerCame(*state_.FindWorker(request.worker()), request.release(), identity);
      ShowMetrics();
    }
    TakeReports(request.worker(), std::move(reports), response);
    RenewHeld(request);
    if (const std::vector<std::string> unseen = TakeSeen(request); !unseen.empty()) {
      lock.unlock();
      FailJobsThatAreGone(unseen);
      lock.lock();
    }
    TILEMEND_RETURN_IF_ERROR(AwaitNews(request, alive, lock, response));
    blobs = BlobsOf(response);
  }
  journal_->Await();
  InlineInputs(blobs, response);
  return response;
}

absl::Status CoordinatorImpl::CheckSecret(const v1::SyncRequest& request, const std::string& identity) {
  const Caller caller{0, request.secret(), request.release(), identity, options_.clock()};
  const Caller& known = callers_.try_emplace(request.worker(), caller).first->second;
  if (known.secret == request.secret() && known.identity == identity) return absl::OkStatus();
  return WithErrorInfo(
      absl::PermissionDeniedError(absl::StrCat("another process is worker ", Printable(request.worker()))),
      {"WORKER_SECRET", {}});
}

std::vector<std::string> CoordinatorImpl::TakeSeen(const v1::SyncRequest& request) {
  std::vector<std::string> unseen;
  std::set<std::string> told;
  for (const v1::FoldersSeen& seen : request.seen()) {
    if (!told.insert(seen.job()).second) continue;  // a worker says it once
    const auto warning = trust_.TakeSeen(request.worker(), seen, options_.clock());
    if (!warning) continue;
    Warn(seen.job(), *warning);
    events_.WorkerBlind(request.worker(), seen.job(), *warning);
    unseen.push_back(seen.job());
  }
  metrics_.ShowTrust(trust_.set_aside(), trust_.blind());
  return unseen;
}

// A job whose folders the coordinator does not see either any more, or where it cannot write, has no worker to wait
// for.
void CoordinatorImpl::FailJobsThatAreGone(const std::vector<std::string>& jobs) {
  for (const std::string& job : jobs) {
    JobFolders folders;
    {
      Lock lock(mutex_);
      const JobFolders* known = trust_.FoldersOf(job);
      if (known == nullptr) continue;
      folders = *known;
    }
    const absl::Status fault = TryFolders(folders);
    if (fault.ok()) continue;
    Lock lock(mutex_);
    const auto entry = entries_.find(job);
    if (entry == entries_.end() || entry->second.runner == nullptr) continue;
    entry->second.runner->Fail(fault);
  }
}

std::vector<CoordinatorImpl::Report> CoordinatorImpl::PrepareReports(const v1::SyncRequest& request) {
  std::vector<Report> reports;
  reports.reserve(static_cast<size_t>(request.finished_size()));
  for (const v1::FinishedTask& finished : request.finished()) {
    reports.push_back(PrepareReport(request.worker(), finished));
  }
  return reports;
}

CoordinatorImpl::Report CoordinatorImpl::PrepareReport(const std::string& worker, const v1::FinishedTask& finished) {
  Report report{finished.ref(), static_cast<Stage>(finished.stage()), {}, std::nullopt};
  const TaskKey key = KeyOf(finished.ref());
  const uint64_t token = finished.ref().attempt_token();
  const std::optional<Holding> lease = HoldingOf(worker, finished.ref());
  report.held = lease.has_value();
  if (finished.has_output()) {
    report.event = TaskCompleted{key, worker, token, DigestOf(finished.output()), {}};
    if (lease) PrepareOutput(worker, *lease, finished.output(), report);
    return report;
  }
  absl::Status error = Bounded(StatusFromProto(finished.error()));
  if (error.ok()) error = absl::UnknownError("the worker reported neither an output nor an error");
  const bool machine = IsMachineError(error);
  report.event = TaskFailed{key, worker, token, machine, false, std::move(error), {}};
  return report;
}

std::optional<CoordinatorImpl::Holding> CoordinatorImpl::HoldingOf(const std::string& worker, const v1::TaskRef& ref) {
  Lock lock(mutex_);
  const Task* task = state_.FindTask(KeyOf(ref));
  if (task == nullptr || FindLease(*task, worker, ref.attempt_token()) == nullptr) return std::nullopt;
  const JobEntry& entry = entries_.at(ref.job());
  if (entry.blobs == nullptr) return std::nullopt;
  const bool queue_full = entry.runner != nullptr && entry.runner->queued_bytes() > kMaxQueuedBytes;
  return Holding{task->cell, task->stage, task->input, entry.blobs, queue_full};
}

// Puts down in the report what is to become of an output.
void CoordinatorImpl::PrepareOutput(const std::string& worker, const Holding& lease, const v1::BlobRef& output,
                                    Report& report) {
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
  } else if (IsInline(output) && !(lease.queue_full && lease.blobs->Put(output.content(), OutputSync()).ok())) {
    report.content = output.content();
  }
}

absl::Status CoordinatorImpl::CheckOutput(const Holding& lease, const v1::BlobRef& output) const {
  if (!IsInline(output) && !IsDigest(output.digest())) return absl::DataLossError("a blob without a digest");
  if (!IsInline(output) && !lease.blobs->Size(output.digest()).ok()) {
    return absl::UnavailableError(absl::StrCat("blob ", output.digest(), " did not arrive"));
  }
  if (!options_.check_result) return absl::OkStatus();
  TILEMEND_ASSIGN_OR_RETURN(const std::string input, lease.blobs->Read(lease.input));
  if (IsInline(output)) return options_.check_result(lease.stage, input, output.content());
  TILEMEND_ASSIGN_OR_RETURN(const std::string bytes, lease.blobs->Read(output.digest()));
  return options_.check_result(lease.stage, input, bytes);
}

void CoordinatorImpl::TakeReports(const std::string& worker, std::vector<Report> reports, v1::SyncResponse& response) {
  for (Report& report : reports) {
    const int64_t bytes = report.content.has_value() ? static_cast<int64_t>(report.content->size()) : 0;
    if (TakeReport(worker, report)) {
      metrics_.BlobReceived(bytes);
    } else {
      metrics_.RefusedLate(report.stage);
    }
    *response.add_acknowledged() = std::move(report.ref);
  }
}

// False if it comes too late, or from one that does not hold the task.
bool CoordinatorImpl::TakeReport(const std::string& worker, Report& report) {
  const Task* task = state_.FindTask(KeyOf(report.ref));
  if (!report.held && task != nullptr && task->state == TaskState::kLeased) return false;
  auto* failed = std::get_if<TaskFailed>(&report.event);
  if (failed != nullptr) {
    failed->time = options_.clock();
    // One that has yet to look at the folders counts: it may be the only one that can.
    const MayWork may = [this, now = failed->time](const std::string& id, const std::string& job) {
      return !trust_.IsBarred(id, job) && !trust_.SeemsStuck(id, job, now);
    };
    failed->another = task != nullptr && HasAnother(state_, worker, *state_.FindJob(report.ref.job()), *task, may);
    // A file that one machine cannot read another may.
    failed->machine = failed->machine || (failed->another && IsAboutFiles(failed->error));
  } else {
    std::get<TaskCompleted>(report.event).time = options_.clock();
  }
  const std::optional<Task> before = failed != nullptr && task != nullptr ? std::optional(*task) : std::nullopt;
  const auto effects = Apply(report.event, {std::move(report.content)});
  if (!effects.ok()) return false;
  if (before) {
    events_.AttemptFailed(*before, report.ref.job(), worker, entries_.at(report.ref.job()).origin, failed->error);
  }
  if (failed != nullptr && ErrorReason(failed->error) == "FOLDER_NOT_SEEN") trust_.Doubt(worker, report.ref.job());
  if (!report.refusal.empty()) {
    metrics_.Refused(report.stage);
    Warn(report.ref.job(), report.refusal);
  }
  return true;
}

void CoordinatorImpl::TakeVerdicts(const Effects& effects) {
  if (effects.suspected.empty() && effects.convicted.empty() && effects.cleared.empty()) return;
  for (const Blamed& blamed : effects.convicted) {
    trust_.SetAside(blamed.worker, blamed.reason);
    journal_->PutSetAside({blamed.worker, blamed.reason});
    events_.WorkerSetAside(blamed.worker, blamed.reason);
  }
  for (const Blamed& blamed : effects.suspected) {
    trust_.Suspect(blamed.worker, blamed.reason);
    events_.WorkerSuspected(blamed.worker, blamed.reason);
  }
  for (const std::string& worker : effects.cleared) {
    if (trust_.Clear(worker)) events_.WorkerCleared(worker);
  }
  metrics_.ShowTrust(trust_.set_aside(), trust_.blind());
  work_changed_.notify_all();
  for (const auto* blamed : {&effects.convicted, &effects.suspected}) {
    for (const auto& [worker, reason] : *blamed) Apply(WorkerLeft{worker}).IgnoreError();  // others do what it holds
  }
}

void CoordinatorImpl::Warn(const std::string& job, const std::string& warning) {
  const Job* warned = state_.FindJob(job);
  const uint64_t before = warned == nullptr ? 0 : warned->version;
  if (!Apply(JobWarned{job, warning}).ok() || warned->version == before) return;
  job_changed_.notify_all();
  if (!entries_.at(job).completed) PutJob(*warned, false);  // else its end is put down already
}

void CoordinatorImpl::ForgetWorker(const std::string& worker) {
  callers_.erase(worker);
  trust_.RemoveWorker(worker);
}

void CoordinatorImpl::RenewHeld(const v1::SyncRequest& request) {
  const absl::Time deadline = options_.clock() + options_.lease;
  const std::set<uint64_t> begun(request.begun().begin(), request.begun().end());
  for (const v1::TaskRef& ref : request.held()) {
    const uint64_t token = ref.attempt_token();
    // Fails if the lease was lost; TellState then leaves the task out.
    Apply(LeaseRenewed{KeyOf(ref), request.worker(), token, deadline, begun.contains(token)}).IgnoreError();
  }
}

absl::Status CoordinatorImpl::AwaitNews(const v1::SyncRequest& request, const std::function<bool()>& alive, Lock& lock,
                                        v1::SyncResponse& response) {
  const absl::Duration wait = std::clamp(absl::Milliseconds(request.wait_ms()), absl::ZeroDuration(), kMaxPoll);
  const SteadyTime deadline = std::chrono::steady_clock::now() + absl::ToChronoMilliseconds(wait);
  while (true) {
    const auto caller = callers_.find(request.worker());
    if (caller == callers_.end() || caller->second.sequence > request.sequence()) {
      return absl::AbortedError("a newer call of this worker took over");
    }
    if (!alive()) return absl::CancelledError("the worker went away");
    if (request.draining() && request.held().empty()) {
      Apply(WorkerLeft{request.worker()}).IgnoreError();
      ForgetWorker(request.worker());
      events_.WorkerLeft(request.worker());
      ShowMetrics();
      response.set_leave(true);
      return absl::OkStatus();
    }
    TellState(request, response);
    const bool news = response.start_size() > 0 || response.look_size() > 0 || response.acknowledged_size() > 0 ||
                      response.keep_size() < request.held_size();
    if (stopping_ && !news) return absl::UnavailableError("the coordinator is shutting down");
    if (news || std::chrono::steady_clock::now() >= deadline) return absl::OkStatus();
    work_changed_.wait_until(lock, deadline);
  }
}

void CoordinatorImpl::TellState(const v1::SyncRequest& request, v1::SyncResponse& response) {
  response.clear_start();
  response.clear_keep();
  response.clear_look();
  response.set_set_aside(trust_.WhySetAside(request.worker()));
  if (!stopping_ && !request.draining()) TellToLook(request, response);
  if (!stopping_) LeaseTasks(request.worker());
  const WorkerRecord* worker = state_.FindWorker(request.worker());
  if (worker == nullptr) return;  // it was lost while it waited; its next call makes it known again
  std::set<uint64_t> known;
  for (const v1::TaskRef& ref : request.held()) {
    const Task* task = state_.FindTask(KeyOf(ref));
    if (task == nullptr || FindLease(*task, request.worker(), ref.attempt_token()) == nullptr) continue;
    known.insert(ref.attempt_token());
    *response.add_keep() = ref;
  }
  // Also what it was given before, if that answer was lost.
  for (const TaskKey& key : worker->held) {
    const Task& task = *state_.FindTask(key);
    const Lease& lease = *LeaseOf(task, request.worker());
    if (known.contains(lease.token)) continue;
    v1::Task message = TaskMessage(key, task, lease);
    message.set_trace(entries_.at(key.job).origin.trace);
    *response.add_start() = std::move(message);
  }
}

void CoordinatorImpl::TellToLook(const v1::SyncRequest& request, v1::SyncResponse& response) const {
  std::set<std::string> busy;
  for (const v1::FoldersSeen& seen : request.seen()) {
    if (seen.looking()) busy.insert(seen.job());
  }
  for (v1::JobFolders& folders : trust_.ToLookAt(request.worker(), busy, options_.clock())) {
    *response.add_look() = std::move(folders);
  }
}

MayWork CoordinatorImpl::MayWorkNow() const {
  return [this](const std::string& worker, const std::string& job) { return trust_.MayWorkOn(worker, job); };
}

void CoordinatorImpl::LeaseTasks(const std::string& worker) {
  const absl::Time now = options_.clock();
  for (const TaskKey& key : ChooseTasks(state_, worker, now, MayWorkNow())) {
    const Stage stage = state_.FindTask(key)->stage;
    const Job& job = *state_.FindJob(key.job);
    const bool starts = job.started == absl::InfiniteFuture();
    if (!Apply(TaskLeased{key, worker, NewToken(), now, now + options_.lease}).ok()) continue;
    metrics_.Started(stage);
    if (!starts) continue;
    PutJob(job, false);
    events_.JobStarted(job, entries_.at(key.job).origin);
  }
}

}  // namespace tilemend
