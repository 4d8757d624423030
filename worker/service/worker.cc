#include "worker/service/worker.h"

#include <algorithm>
#include <chrono>
#include <exception>
#include <optional>
#include <set>
#include <utility>

#include "absl/random/random.h"
#include "absl/strings/str_cat.h"
#include "common/rpc/input_parts.h"
#include "common/rpc/limits.h"
#include "common/rpc/status_proto.h"
#include "common/store/digest.h"
#include "common/util/error_info.h"
#include "common/util/heap.h"
#include "common/util/status_macros.h"
#include "common/util/version.h"
#include "worker/service/worker_id.h"

namespace tilemend {
namespace {

// Ground rasters of three rows of 80 cells of 250 m.
constexpr size_t kMostPartBytes = size_t{32} << 20;

// To send or fetch a blob while the connection stands: with the pauses between them 2.6 seconds in all.
constexpr int kMostTries = 6;

constexpr char kNotYet[] = "has not reached its coordinator yet";

}  // namespace

Worker::Worker(const WorkerOptions& options, std::unique_ptr<WorkLink> link, StageRunner runner,
               MetricsRegistry& metrics)
    : options_(options),
      secret_(NewSecret()),
      link_(std::move(link)),
      runner_(std::move(runner)),
      parts_(kMostPartBytes),
      metrics_(metrics),
      cores_(options.threads),
      unconnected_(kNotYet) {
  threads_.emplace_back([this] { SyncLoop(); });
  const int reading_or_writing = std::min(1 + options_.threads / 4, options_.prefetch);
  for (int i = 0; i < options_.threads + reading_or_writing; ++i) threads_.emplace_back([this] { RunTasks(); });
}

Worker::~Worker() {
  Stop();
  Join().IgnoreError();
}

void Worker::Drain() { SetMode(Mode::kDraining); }
void Worker::Stop() { SetMode(Mode::kStopping); }
void Worker::Abandon() { SetMode(Mode::kAbandoned); }

void Worker::SetMode(Mode mode) {
  std::lock_guard<std::mutex> lock(mutex_);
  mode_ = std::max(mode_, mode);
  if (mode_ >= Mode::kStopping) {
    while (!ready_.empty()) {
      held_.erase(ready_.front()->task.ref().attempt_token());
      ready_.pop_front();
    }
    for (auto& [token, held] : held_) {
      held->dropped = true;
      held->cancel.Cancel();
    }
  }
  CallNow();
  changed_.notify_all();
}

absl::Status Worker::Join() {
  std::lock_guard<std::mutex> join_lock(join_mutex_);
  for (std::thread& thread : threads_) {
    if (thread.joinable()) thread.join();
  }
  std::lock_guard<std::mutex> lock(mutex_);
  return end_status_;
}

void Worker::SyncLoop() {
  absl::Duration backoff = options_.first_backoff;
  while (SyncOnce(backoff)) {
  }
  metrics_.SetConnected(false);
  std::unique_lock<std::mutex> lock(mutex_);
  ended_ = true;
  for (auto& [token, held] : held_) held->cancel.Cancel();
  changed_.notify_all();
  lock.unlock();
  if (options_.on_end) options_.on_end();
}

bool Worker::SyncOnce(absl::Duration& backoff) {
  const std::unique_ptr<SyncCall> call = link_->NewSync();
  v1::SyncRequest request;
  {
    std::unique_lock<std::mutex> lock(mutex_);
    RestWhileBusy(lock);
    if (mode_ == Mode::kAbandoned) return false;
    request = NextRequest();
    // With something to report the answer comes at once: no reason to interrupt.
    if (request.finished().empty()) waiting_call_ = call.get();
  }
  absl::StatusOr<v1::SyncResponse> response = call->Run(request);
  {
    std::lock_guard<std::mutex> lock(mutex_);
    waiting_call_ = nullptr;
    if (mode_ == Mode::kAbandoned) return false;
  }
  const std::optional<absl::Duration> wait = RetryAfter(response.status());
  if (response.ok() || wait) {
    SetConnected(absl::OkStatus());
    backoff = options_.first_backoff;
    in_vain_ = absl::ZeroDuration();
  }
  if (wait) return Pause(2 * std::max(*wait, backoff));  // twice: at least half of a pause is waited
  if (response.ok()) {
    const bool leave = response->leave();
    Take(request, *std::move(response));
    return !leave;
  }
  if (absl::IsCancelled(response.status()) || absl::IsAborted(response.status())) return true;  // call again
  return AfterFailure(response.status(), backoff);
}

void Worker::RestWhileBusy(std::unique_lock<std::mutex>& lock) {
  constexpr std::chrono::milliseconds kRest(100);
  news_.wait_for(lock, kRest, [this] {
    const bool is_busy = std::ssize(held_) > options_.threads + options_.prefetch / 2;
    size_t bytes = 0;
    for (const auto& [token, finished] : finished_) bytes += finished.output().content().size();
    const bool has_looked = std::ranges::any_of(seen_, [](const auto& seen) { return !seen.second.looking(); });
    return !is_busy || bytes > kInlineBlobBytes || has_looked || mode_ != Mode::kRunning;
  });
}

void Worker::CallNow() {
  if (waiting_call_ != nullptr) waiting_call_->Interrupt();
  news_.notify_one();
}

bool Worker::AfterFailure(const absl::Status& status, absl::Duration& backoff) {
  SetConnected(status);
  in_vain_ += backoff;
  const std::string reason = ErrorReason(status);
  if (reason == "PROTOCOL_VERSION" || reason == "OTHER_BUILD" || absl::IsInvalidArgument(status) ||
      in_vain_ > options_.patience) {
    std::lock_guard<std::mutex> lock(mutex_);
    end_status_ = status;
    return false;
  }
  return Pause(std::exchange(backoff, std::min(2 * backoff, options_.max_backoff)));
}

void Worker::SetConnected(const absl::Status& status) {
  metrics_.SetConnected(status.ok());
  std::string reason = status.ok() ? "" : absl::StrCat("cannot reach its coordinator: ", status.message());
  std::lock_guard<std::mutex> lock(mutex_);
  if (reason.empty() && !unconnected_.empty()) options_.log->Info("connected");
  // Once for each time, however the reason changes; an address that is wrong is told of as well.
  if (!reason.empty() && (unconnected_.empty() || unconnected_ == kNotYet))
    options_.log->Warn("not connected", {{"reason", reason}});
  unconnected_ = std::move(reason);
}

std::string Worker::WhyNotReady() {
  std::lock_guard<std::mutex> lock(mutex_);
  if (mode_ != Mode::kRunning) return "is ending";
  return unconnected_.empty() ? set_aside_ : unconnected_;
}

bool Worker::Pause(absl::Duration backoff) {
  absl::InsecureBitGen random;
  const absl::Duration pause = backoff * absl::Uniform(random, 0.5, 1.0);
  std::unique_lock<std::mutex> lock(mutex_);
  const Mode before = mode_;
  const auto is_over = [&] {
    if (mode_ == Mode::kDraining) return held_.empty() && finished_.empty();  // nothing to tell: no need to be released
    return mode_ >= Mode::kStopping;                                          // it would have told once, and could not
  };
  changed_.wait_for(lock, absl::ToChronoMilliseconds(pause), [&] { return mode_ != before || is_over(); });
  return !is_over();
}

v1::SyncRequest Worker::NextRequest() {
  v1::SyncRequest request;
  request.set_protocol(kProtocolVersion);
  request.set_worker(options_.id);
  request.set_secret(secret_);
  request.set_release(Version());
  request.set_build(options_.build);
  request.set_sequence(++sequence_);
  for (const auto& [job, seen] : seen_) *request.add_seen() = seen;
  int32_t threads = options_.threads;
  for (const auto& [token, held] : held_) {
    if (held->dropped) {
      --threads;  // still busy with it
    } else {
      *request.add_held() = held->task.ref();
      if (held->begun) request.add_begun(token);
    }
  }
  request.set_threads(std::max(threads, 0));
  request.set_prefetch(options_.prefetch);
  size_t bytes = 0;
  for (const auto& [token, finished] : finished_) {
    bytes += finished.output().content().size();
    if (bytes <= kMaxInlineBytesPerSync) {
      *request.add_finished() = finished;
    } else {
      *request.add_held() = finished.ref();  // still held in the coordinator's eyes
    }
  }
  request.set_draining(mode_ >= Mode::kDraining);
  request.set_wait_ms(static_cast<int32_t>(absl::ToInt64Milliseconds(kMaxPoll)));
  return request;
}

void Worker::Take(const v1::SyncRequest& request, v1::SyncResponse response) {
  std::set<uint64_t> kept;
  for (const v1::TaskRef& ref : response.keep()) kept.insert(ref.attempt_token());
  std::lock_guard<std::mutex> lock(mutex_);
  for (const v1::TaskRef& ref : response.acknowledged()) finished_.erase(ref.attempt_token());
  for (const v1::TaskRef& ref : request.held()) {
    if (!kept.contains(ref.attempt_token())) DropHeld(ref.attempt_token());
  }
  if (mode_ >= Mode::kStopping) return;
  TakeLooks(request, response);
  for (v1::Task& task : *response.mutable_start()) {
    const uint64_t token = task.ref().attempt_token();
    if (held_.contains(token) || finished_.contains(token)) continue;
    auto held = std::make_shared<Held>();
    held->task = std::move(task);
    held_[token] = held;
    ready_.push_back(std::move(held));
  }
  changed_.notify_all();
}

void Worker::TakeLooks(const v1::SyncRequest& request, const v1::SyncResponse& response) {
  for (const v1::FoldersSeen& seen : request.seen()) {
    if (!seen.looking()) seen_.erase(seen.job());
  }
  for (const v1::JobFolders& folders : response.look()) {
    v1::FoldersSeen looking;
    looking.set_job(folders.job());
    looking.set_looking(true);
    if (seen_.emplace(folders.job(), std::move(looking)).second) to_look_.push_back(folders);
  }
  if (response.set_aside() == set_aside_) return;
  set_aside_ = response.set_aside();
  if (set_aside_.empty()) {
    options_.log->Info("gets tasks again");
  } else {
    options_.log->Error("set aside", {{"reason", set_aside_}});
  }
}

void Worker::Look(const v1::JobFolders& folders) {
  v1::FoldersSeen seen = options_.look(folders);
  std::lock_guard<std::mutex> lock(mutex_);
  seen_[folders.job()] = std::move(seen);
  CallNow();
}

void Worker::DropHeld(uint64_t token) {
  finished_.erase(token);
  const auto it = held_.find(token);
  if (it == held_.end()) return;
  it->second->dropped = true;
  it->second->cancel.Cancel();
  const auto waiting = std::find(ready_.begin(), ready_.end(), it->second);
  if (waiting == ready_.end()) return;
  ready_.erase(waiting);
  held_.erase(it);
}

void Worker::RunTasks() {
  while (true) {
    std::shared_ptr<Held> held;
    std::optional<v1::JobFolders> folders;
    {
      std::unique_lock<std::mutex> lock(mutex_);
      AwaitTask(lock);
      if (ended_) return;
      if (!to_look_.empty()) {
        folders = std::move(to_look_.front());
        to_look_.pop_front();
      } else {
        held = std::move(ready_.front());
        ready_.pop_front();
      }
    }
    if (folders) {
      Look(*folders);
    } else {
      RunTask(*held);
    }
  }
}

void Worker::AwaitTask(std::unique_lock<std::mutex>& lock) {
  constexpr std::chrono::seconds kRest(1);  // as while a large scene is planned
  const auto has_task = [this] { return ended_ || !ready_.empty() || !to_look_.empty(); };
  if (changed_.wait_for(lock, kRest, has_task)) return;
  lock.unlock();
  ReturnHeap();
  lock.lock();
  changed_.wait(lock, has_task);
}

void Worker::RunTask(Held& held) {
  absl::StatusOr<std::string> input = InputOf(held);
  std::optional<absl::StatusOr<std::string>> output = input.ok() ? Compute(held, *input) : input.status();
  std::optional<v1::FinishedTask> report;
  if (output) report = Report(held, *std::move(output));
  if (report && report->has_error() && !held.cancel.cancelled()) LogFailure(held.task, report->error());
  if (!report) {
    std::lock_guard<std::mutex> lock(mutex_);
    held_.erase(held.task.ref().attempt_token());
  } else if (!TakeReport(held, *report) && report->has_output()) {
    options_.discard(static_cast<Stage>(held.task.stage()), *input, report->output().content());
  }
}

bool Worker::TakeReport(const Held& held, const v1::FinishedTask& report) {
  WorkerMetrics::PerStage& metrics = metrics_.Of(static_cast<Stage>(held.task.stage()));
  const uint64_t token = held.task.ref().attempt_token();
  std::lock_guard<std::mutex> lock(mutex_);
  held_.erase(token);
  if (held.dropped) {
    metrics.cancelled->Increment();
  } else {
    (report.has_output() ? metrics.finished : metrics.failed)->Increment();
    finished_[token] = report;
  }
  CallNow();
  return !held.dropped;
}

void Worker::LogFailure(const v1::Task& task, const v1::Status& error) const {
  options_.log->Warn("task failed", {{"job", task.ref().job()},
                                     {"trace", task.trace()},
                                     {"task", task.ref().task()},
                                     {"cell", absl::StrCat(task.cell().col(), ",", task.cell().row())},
                                     {"stage", StageName(static_cast<Stage>(task.stage()))},
                                     {"attempt", task.attempt()},
                                     {"error", error.message()}});
}

bool Worker::MayTryAgain(const Held& held, const absl::Status& status, int tried) {
  if (!absl::IsUnavailable(status) && !absl::IsDeadlineExceeded(status)) return false;
  const absl::Duration pause = std::min(options_.first_backoff * (1 << std::min(tried, 10)), options_.max_backoff);
  std::unique_lock<std::mutex> lock(mutex_);
  const auto is_over = [&] { return held.cancel.cancelled() || ended_ || mode_ >= Mode::kStopping; };
  changed_.wait_for(lock, absl::ToChronoMilliseconds(pause), is_over);
  // While it is not connected it does not count: a result is kept through any loss of connection.
  return !is_over() && (tried < kMostTries || !unconnected_.empty());
}

absl::StatusOr<std::string> Worker::InputOf(const Held& held) {
  const v1::Task& task = held.task;
  std::string input = task.input().content();
  if (task.input().size() != static_cast<int64_t>(input.size())) {
    TILEMEND_ASSIGN_OR_RETURN(input, Fetch(held, task.input().digest()));
  }
  for (const std::string& part : PartsOf(static_cast<Stage>(task.stage()), input)) {
    TILEMEND_ASSIGN_OR_RETURN(const auto bytes, Part(held, part));
    input += *bytes;
  }
  return input;
}

absl::StatusOr<std::shared_ptr<const std::string>> Worker::Part(const Held& held, const std::string& digest) {
  if (auto known = parts_.Find(digest)) return known;
  TILEMEND_ASSIGN_OR_RETURN(std::string bytes, Fetch(held, digest));
  auto part = std::make_shared<const std::string>(std::move(bytes));
  parts_.Put(digest, part, part->size());
  return part;
}

absl::StatusOr<std::string> Worker::Fetch(const Held& held, const std::string& digest) {
  auto read = link_->ReadBlob(held.task.ref().job(), digest);
  for (int tried = 0; !read.ok() && MayTryAgain(held, read.status(), tried); ++tried) {
    read = link_->ReadBlob(held.task.ref().job(), digest);
  }
  // What the coordinator has lost is no fault of the task.
  if (absl::IsNotFound(read.status())) return absl::UnavailableError(read.status().message());
  return read;
}

// None: it was dropped before there was a core for it.
std::optional<absl::StatusOr<std::string>> Worker::Compute(Held& held, const std::string& input) {
  const Cores::Held core(cores_);
  if (held.cancel.cancelled()) return std::nullopt;
  held.begun = true;
  const Stage stage = static_cast<Stage>(held.task.stage());
  WorkerMetrics::PerStage& metrics = metrics_.Of(stage);
  metrics.started->Increment();
  metrics.bytes_in->Increment(static_cast<double>(input.size()));
  const auto start = std::chrono::steady_clock::now();
  absl::StatusOr<std::string> output = RunStage(stage, input, held.cancel);
  metrics.seconds->Observe(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  return output;
}

absl::StatusOr<std::string> Worker::RunStage(Stage stage, const std::string& input, const CancelToken& cancel) {
  try {
    return runner_(stage, input, cancel);
  } catch (const std::bad_alloc&) {
    return absl::ResourceExhaustedError("the worker is out of memory");
  } catch (const std::exception& error) {
    return absl::InternalError(absl::StrCat("stage ", std::string(StageName(stage)), " threw: ", error.what()));
  }
}

v1::FinishedTask Worker::Report(const Held& held, absl::StatusOr<std::string> output) {
  const v1::Task& task = held.task;
  v1::FinishedTask report;
  *report.mutable_ref() = task.ref();
  report.set_stage(task.stage());
  if (output.ok()) {
    metrics_.Of(static_cast<Stage>(task.stage())).bytes_out->Increment(static_cast<double>(output->size()));
    v1::BlobRef blob;
    blob.set_size(static_cast<int64_t>(output->size()));
    if (output->size() <= kInlineBlobBytes) {
      blob.set_content(*std::move(output));
      *report.mutable_output() = std::move(blob);
      return report;
    }
    blob.set_digest(Sha256Hex(*output));
    const auto write = [&] { return link_->WriteBlob(task.ref(), options_.id, blob.digest(), *output); };
    absl::Status written = write();
    for (int tried = 0; !written.ok() && MayTryAgain(held, written, tried); ++tried) written = write();
    if (written.ok()) {
      *report.mutable_output() = std::move(blob);
      return report;
    }
    output = written;
  }
  *report.mutable_error() = StatusToProto(output.status());
  return report;
}

}  // namespace tilemend
