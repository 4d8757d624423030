#include "coordinator/api/coordinator_impl.h"

#include <algorithm>
#include <filesystem>
#include <random>
#include <system_error>
#include <utility>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"
#include "absl/strings/strip.h"
#include "common/options/job_options.h"
#include "common/rpc/limits.h"
#include "common/rpc/trace.h"
#include "common/util/error_info.h"
#include "common/util/folders.h"
#include "common/util/heap.h"
#include "common/util/status_macros.h"
#include "common/util/text.h"
#include "coordinator/jobs/job_proto.h"

namespace tilemend {
namespace {

constexpr size_t kMaxRequestIdBytes = 128;
constexpr std::chrono::milliseconds kWatchInterval(50);
constexpr int kRetryAfter = 10;  // seconds, after a submission that was refused for want of room

std::function<absl::Time()> SteadyWallClock() {
  return [wall = absl::Now(), steady = std::chrono::steady_clock::now()] {
    return wall + absl::FromChrono(std::chrono::steady_clock::now() - steady);
  };
}

std::string NewJobId() {
  std::random_device random;
  return absl::StrFormat("%08x%04x", random(), random() & 0xffff);
}

absl::Status CheckScene(const std::string& scene) {
  if (scene.find("://") != std::string::npos) return absl::OkStatus();
  const absl::Status look = LookAt(scene).status();
  if (look.ok()) return absl::OkStatus();
  const std::string why = absl::IsNotFound(look) ? "" : absl::StrCat(" (", std::string(look.message()), ")");
  return WithErrorInfo(absl::NotFoundError(absl::StrCat(Printable(scene), ": no such scene", why)),
                       {"SCENE_NOT_FOUND", {{"scene", scene}}});
}

absl::Status InvalidRequestId() {
  return WithErrorInfo(
      absl::InvalidArgumentError(absl::StrCat("request_id: longer than ", kMaxRequestIdBytes, " bytes")),
      {"INVALID_SPEC", {{"field", "request_id"}}});
}

}  // namespace

absl::StatusOr<std::unique_ptr<CoordinatorImpl>> CoordinatorImpl::Create(CoordinatorOptions options,
                                                                         PipelineFactory factory,
                                                                         MetricsRegistry& metrics) {
  if (options.lease <= 2 * kMaxPoll) {
    return absl::InvalidArgumentError(absl::StrCat("a lease of ", absl::FormatDuration(options.lease),
                                                   " is too short: workers renew once a second, so more than 2 s"));
  }
  std::error_code error;
  std::filesystem::create_directories(options.work_folder, error);
  if (error) {
    return absl::PermissionDeniedError(
        absl::StrCat(options.work_folder, ": cannot create the work folder: ", error.message()));
  }
  if (!options.clock) options.clock = SteadyWallClock();
  if (options.journal == nullptr) options.journal = NewForgetfulJournal();
  options.state.epoch = options.journal->epoch();
  std::unique_ptr<CoordinatorImpl> impl(new CoordinatorImpl(std::move(options), std::move(factory), metrics));
  TILEMEND_RETURN_IF_ERROR(impl->Restore());
  if (impl->options_.background_ticks) impl->ticker_ = std::thread([&impl = *impl] { impl.TickLoop(); });
  return impl;
}

CoordinatorImpl::CoordinatorImpl(CoordinatorOptions options, PipelineFactory factory, MetricsRegistry& metrics)
    : options_(std::move(options)),
      journal_(options_.journal),
      factory_(std::move(factory)),
      metrics_(metrics),
      events_(metrics, *options_.log),
      state_(options_.state) {}

CoordinatorImpl::~CoordinatorImpl() {
  StopWaiting();
  leaving_.store(true);
  for (std::thread* thread : {&ticker_, &sweeper_}) {
    if (thread->joinable()) thread->join();
  }
  std::vector<std::unique_ptr<JobRunner>> runners;
  {
    Lock lock(mutex_);
    for (auto& [id, entry] : entries_) {
      if (entry.runner != nullptr) runners.push_back(std::move(entry.runner));
    }
  }
  for (const auto& runner : runners) runner->Abandon();
  runners.clear();  // joins; their sinks take the lock
}

void CoordinatorImpl::StopWaiting() {
  Lock lock(mutex_);
  stopping_ = true;
  stop_changed_.notify_all();
  Changed();
}

std::string CoordinatorImpl::OutKey(const JobSpec& spec) {
  if (spec.out().empty() || spec.dry_run()) return "";
  std::string key = std::filesystem::path(spec.out()).lexically_normal().string();
  while (key.size() > 1 && key.back() == '/') key.pop_back();
  return key;
}

std::string CoordinatorImpl::FolderOf(const std::string& job) const {
  return absl::StrCat(options_.work_folder, "/jobs/", job);
}

void CoordinatorImpl::Changed() {
  work_changed_.notify_all();
  job_changed_.notify_all();
}

absl::StatusOr<Effects> CoordinatorImpl::Apply(const Event& event, Contents contents) {
  TILEMEND_ASSIGN_OR_RETURN(Effects effects, state_.Apply(event));
  for (const Stage stage : effects.retried) metrics_.Retried(stage);
  for (const StruckTask& task : effects.struck) {
    PutStrike(task);
    events_.AttemptLost(task, entries_.at(task.key.job).origin);
  }
  for (const SettledTask& task : effects.settled) {
    std::optional<std::string> content;
    if (!contents.empty()) {
      content = std::move(contents.front());
      contents.pop_front();
    }
    if (!task.known) {
      metrics_.Settled(task, options_.clock());
      PutResult(task, content);
    }
    if (JobRunner* runner = entries_.at(task.key.job).runner.get(); runner != nullptr) {
      runner->Deliver(task, std::move(content));
    }
  }
  for (const Contradicted& c : effects.contradicted) {
    Warn(c.key.job,
         absl::StrCat("worker ", Printable(c.worker), " could not do cell ", ToString(c.cell), ", stage ",
                      std::string(StageName(c.stage)), ", which worker ", Printable(c.by), " did: ", c.reason));
  }
  if (!effects.retried.empty() || !effects.settled.empty()) Changed();
  TakeVerdicts(effects);
  return effects;
}

absl::StatusOr<const Job*> CoordinatorImpl::JobNamed(const std::string& name) const {
  absl::string_view id = name;
  if (!absl::ConsumePrefix(&id, "jobs/") || id.empty() || id.find('/') != absl::string_view::npos) {
    return WithErrorInfo(absl::InvalidArgumentError(absl::StrCat("'", name, "': expected jobs/ID")),
                         {"INVALID_NAME", {{"name", name}}});
  }
  const Job* job = state_.FindJob(std::string(id));
  if (job != nullptr) return job;
  return WithErrorInfo(absl::NotFoundError(absl::StrCat(name, ": no such job; `tilemend list` shows all")),
                       {"JOB_NOT_FOUND", {{"job", std::string(id)}}});
}

absl::Status CoordinatorImpl::CheckRoots(const JobSpec& spec) const {
  if (options_.roots == nullptr) return absl::OkStatus();
  const bool water_is_file = spec.water() != "auto" && spec.water() != "off";
  for (const auto& [field, path] : {std::pair("scene", spec.scene()), std::pair("out", spec.out()),
                                    std::pair("water", water_is_file ? spec.water() : ""),
                                    std::pair("clear", spec.clear()), std::pair("area", spec.area())}) {
    const absl::Status status = path.empty() ? absl::OkStatus() : options_.roots->Check(path);
    if (!status.ok()) {
      return WithErrorInfo(absl::PermissionDeniedError(absl::StrCat(field, ": ", std::string(status.message()))),
                           {"OUTSIDE_ROOTS", {{"field", field}}});
    }
  }
  return absl::OkStatus();
}

absl::StatusOr<v1::Job> CoordinatorImpl::CreateJob(const v1::CreateJobRequest& request, JobOrigin origin) {
  const JobSpec spec = WithDefaults(request.spec());
  TILEMEND_RETURN_IF_ERROR(CheckJob(spec));
  TILEMEND_RETURN_IF_ERROR(CheckPriority(request.priority()));
  TILEMEND_RETURN_IF_ERROR(CheckRoots(spec));
  const absl::Status scene = CheckScene(spec.scene());  // without the lock: a mount may hang
  return Answer([&]() -> absl::StatusOr<v1::Job> {
    TILEMEND_RETURN_IF_ERROR(OnlyIfNew(request.request_id(), scene));
    return StartJob(spec, request.request_id(), request.priority(), std::move(origin));
  });
}

absl::Status CoordinatorImpl::OnlyIfNew(const std::string& request_id, const absl::Status& error) const {
  const bool is_new = request_id.empty() || state_.FindRequest(request_id) == nullptr;
  return is_new ? error : absl::OkStatus();
}

absl::StatusOr<v1::Job> CoordinatorImpl::StartJob(const JobSpec& spec, const std::string& request_id, int32_t priority,
                                                  JobOrigin origin) {
  if (request_id.size() > kMaxRequestIdBytes) return InvalidRequestId();
  if (const Job* job = request_id.empty() ? nullptr : state_.FindRequest(request_id); job != nullptr) {
    if (AreEqual(entries_.at(job->id).spec, spec)) return Describe(*job);
    return WithErrorInfo(
        absl::InvalidArgumentError(absl::StrCat("request_id ", request_id, ": used before, with another spec")),
        {"REQUEST_ID_REUSED", {{"job", job->id}}});
  }
  const std::string out_key = OutKey(spec);
  TILEMEND_RETURN_IF_ERROR(CheckNewJob(out_key));
  const std::string id = NewJobId();
  TILEMEND_ASSIGN_OR_RETURN(auto blobs, BlobFolder::Create(FolderOf(id)));
  TILEMEND_RETURN_IF_ERROR(Apply(JobCreated{id, request_id, options_.clock(), priority}).status());
  JobEntry& entry = entries_[id];
  entry.spec = spec;
  entry.origin = std::move(origin);
  if (entry.origin.trace.empty()) entry.origin.trace = NewTrace();
  entry.out_key = out_key;
  entry.blobs = blobs;
  PutJob(*state_.FindJob(id), false);
  events_.JobCreated(*state_.FindJob(id), spec, entry.origin);
  if (const absl::Status begun = Begin(entry, id); !begun.ok()) return begun;
  ShowMetrics();
  return Describe(*state_.FindJob(id));
}

absl::Status CoordinatorImpl::Begin(JobEntry& entry, const std::string& id) {
  try {
    entry.runner = std::make_unique<JobRunner>(entry.spec, factory_, entry.blobs, SinkOf(id));
    return absl::OkStatus();
  } catch (const std::system_error& error) {  // no thread can be made
    journal_->DropJob(state_.FindJob(id)->number);
    entry.blobs->Remove();
    Apply(JobCancelled{id, options_.clock()}).IgnoreError();
    Apply(JobForgotten{id}).IgnoreError();
    entries_.erase(id);
    return WithErrorInfo(absl::ResourceExhaustedError(absl::StrCat("no thread can be made for the job (", error.what(),
                                                                   "); try again in ", kRetryAfter, " s")),
                         {"TOO_MANY_JOBS", {{"retry_after_s", absl::StrCat(kRetryAfter)}}});
  }
}

absl::Status CoordinatorImpl::CheckNewJob(const std::string& out_key) const {
  size_t running = 0;
  for (const auto& [id, entry] : entries_) {
    if (entry.runner == nullptr || !entry.runner->may_write()) continue;  // a cancelled job may for a while
    ++running;
    if (!out_key.empty() && entry.out_key == out_key) {
      return WithErrorInfo(
          absl::AbortedError(absl::StrCat(out_key, ": jobs/", id,
                                          " is writing there; wait for it, cancel it or choose another folder")),
          {"OUTPUT_IN_USE", {{"job", id}}});
    }
  }
  if (running < options_.max_running_jobs) return absl::OkStatus();
  return WithErrorInfo(
      absl::ResourceExhaustedError(
          absl::StrCat(running, " jobs are running, which is the limit; try again in ", kRetryAfter, " s")),
      {"TOO_MANY_JOBS",
       {{"limit", absl::StrCat(options_.max_running_jobs)}, {"retry_after_s", absl::StrCat(kRetryAfter)}}});
}

JobRunner::Sink CoordinatorImpl::SinkOf(const std::string& id) {
  return {.add_tasks = [this, id](std::vector<TaskSpec> tasks,
                                  const Progress& progress) { return OnTasks(id, std::move(tasks), progress); },
          .await = [this] { journal_->Await(); },
          .completed = [this, id](const JobOutcome& outcome,
                                  const Progress& progress) { OnCompleted(id, outcome, progress); },
          .finished = [this, id](absl::StatusOr<JobOutcome> outcome) { OnFinished(id, std::move(outcome)); },
          .released = [this, id] { OnReleased(id); },
          .folders =
              [this, id](JobFolders folders) {
                Lock lock(mutex_);
                trust_.AddJob(id, std::move(folders));
              }};
}

absl::Status CoordinatorImpl::OnTasks(const std::string& id, std::vector<TaskSpec> tasks, const Progress& progress) {
  TILEMEND_ASSIGN_OR_RETURN(Contents contents, Recall(id, tasks));
  Lock lock(mutex_);
  bool& resuming = entries_.at(id).resuming;
  resuming = resuming && std::all_of(tasks.begin(), tasks.end(), [](const TaskSpec& t) { return t.known.has_value(); });
  // Both fail only if the job is over; then its runner is being cancelled. A job that resumes runs through all it has
  // done; nobody is to see it begin again.
  if (!resuming) Apply(JobProgressed{id, progress}).IgnoreError();
  if (!tasks.empty()) Apply(TasksAdded{id, std::move(tasks)}, std::move(contents)).IgnoreError();
  Changed();
  return absl::OkStatus();
}

void CoordinatorImpl::OnCompleted(const std::string& id, const JobOutcome& outcome, const Progress& progress) {
  {
    Lock lock(mutex_);
    Apply(JobProgressed{id, progress}).IgnoreError();
    const Job& job = *state_.FindJob(id);
    // The end is durable now, and told when the output is free for others.
    const bool partial = outcome.partial || job.counts.quarantined > 0;
    JobEntry& entry = entries_.at(id);
    entry.completed = true;
    entry.ended = options_.clock();
    v1::Job end = JobToProto(job, entry.spec, outcome, absl::OkStatus(), entry.origin);
    SetEnd(partial ? JobState::kPartial : JobState::kDone, entry.ended, end);
    PutJob(job, false, std::move(end));
  }
  journal_->Await();
}

void CoordinatorImpl::OnFinished(const std::string& id, absl::StatusOr<JobOutcome> outcome) {
  Lock lock(mutex_);
  const Job* job = state_.FindJob(id);
  if (job == nullptr || IsOver(job->state)) return;
  JobEntry& entry = entries_.at(id);
  JobState state = JobState::kFailed;
  if (outcome.ok()) {
    entry.outcome = *std::move(outcome);
    state = entry.outcome.partial ? JobState::kPartial : JobState::kDone;
  } else {
    entry.error = outcome.status();
    entry.ended = options_.clock();
  }
  Apply(JobFinished{id, state, entry.ended}).IgnoreError();
  events_.JobEnded(*job, entry.outcome, entry.error, entry.origin);
  if (state == JobState::kFailed) PutJob(*job, true);
  ShowMetrics();
  Changed();
}

void CoordinatorImpl::OnReleased(const std::string& id) {
  Lock lock(mutex_);
  PutJob(*state_.FindJob(id), true);
}

absl::StatusOr<v1::Job> CoordinatorImpl::GetJob(const v1::GetJobRequest& request) {
  return Answer([&]() -> absl::StatusOr<v1::Job> {
    TILEMEND_ASSIGN_OR_RETURN(const Job* job, JobNamed(request.name()));
    return Describe(*job);
  });
}

absl::StatusOr<v1::Job> CoordinatorImpl::CancelJob(const v1::CancelJobRequest& request) {
  return Answer([&] { return Cancel(request.name()); });
}

absl::StatusOr<v1::Job> CoordinatorImpl::Cancel(const std::string& name) {
  TILEMEND_ASSIGN_OR_RETURN(const Job* job, JobNamed(name));
  if (job->state == JobState::kCancelled) return Describe(*job);
  JobRunner* runner = IsOver(job->state) ? nullptr : entries_.at(job->id).runner.get();
  if (runner != nullptr && !runner->Cancel()) {
    return WithErrorInfo(absl::FailedPreconditionError(absl::StrCat(name, ": too late, it is just ending")),
                         {"JOB_OVER", {{"job", job->id}, {"state", std::string(JobStateName(job->state))}}});
  }
  TILEMEND_RETURN_IF_ERROR(Apply(JobCancelled{job->id, options_.clock()}).status());
  events_.JobEnded(*job, {}, absl::OkStatus(), entries_.at(job->id).origin);
  PutJob(*job, runner == nullptr);  // else its output is released by the runner, or after a restart
  ShowMetrics();
  Changed();
  return Describe(*job);
}

absl::Status CoordinatorImpl::WatchJob(const v1::WatchJobRequest& request,
                                       const std::function<bool(const v1::Job&)>& send,
                                       const std::function<bool()>& alive) {
  TILEMEND_ASSIGN_OR_RETURN(const auto call, watches_.Enter(request.name(), options_.clock(), [] {}));
  uint64_t cursor = request.cursor();
  SteadyTime next_send{};
  Lock lock(mutex_);
  while (true) {
    TILEMEND_ASSIGN_OR_RETURN(const Job* job, JobNamed(request.name()));
    const SteadyTime now = std::chrono::steady_clock::now();
    const bool over = IsOver(job->state);
    if (over || (job->version > cursor && now >= next_send)) {
      const v1::Job message = Describe(*job);
      lock.unlock();
      journal_->Await();
      if (!send(message)) return absl::CancelledError("the watcher went away");
      if (over) return absl::OkStatus();
      cursor = message.cursor();
      next_send = now + kWatchInterval;
      lock.lock();
      continue;
    }
    if (stopping_) return absl::UnavailableError("the coordinator is shutting down; watch again with the last cursor");
    job_changed_.wait_until(lock, job->version > cursor ? next_send : now + absl::ToChronoMilliseconds(kMaxPoll));
    if (!alive()) return absl::CancelledError("the watcher went away");
  }
}

void CoordinatorImpl::Tick() {
  std::vector<std::unique_ptr<JobRunner>> ended;
  Lock lock(mutex_);
  const absl::Time now = options_.clock();
  for (const Event& event : may_lose_ ? Overdue(state_, now, options_.lease) : std::vector<Event>()) {
    if (const auto* lost = std::get_if<WorkerLost>(&event)) {
      events_.WorkerLost(*state_.FindWorker(lost->worker), now);
      ForgetWorker(lost->worker);
    }
    Apply(event).IgnoreError();
  }
  for (const Event& event : Abandoned(state_, now, MayWorkNow())) Apply(event).IgnoreError();
  for (auto& [id, entry] : entries_) {
    if (entry.runner == nullptr || !entry.runner->ended()) continue;
    ended.push_back(std::move(entry.runner));
    trust_.RemoveJob(id);
    entry.blobs.reset();
  }
  ForgetOldJobs(now);
  ForgetSent();
  StopIdleStreams(now);
  ShowMetrics();
  lock.unlock();  // before the runners are joined
  if (ended.empty()) return;
  ended.clear();
  ReturnHeap();  // what a large job took stays with the process otherwise
}

void CoordinatorImpl::TickLoop() {
  const absl::Duration interval = std::min(options_.lease / 4, absl::Seconds(1));
  Patience patience(interval, options_.lease);
  Lock lock(mutex_);
  while (!stopping_) {
    stop_changed_.wait_for(lock, absl::ToChronoMilliseconds(interval));
    if (stopping_) return;
    may_lose_ = patience.IsOver(options_.clock());
    lock.unlock();
    Tick();
    lock.lock();
  }
}

}  // namespace tilemend
