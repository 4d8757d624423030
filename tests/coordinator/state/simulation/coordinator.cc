#include "tests/coordinator/state/simulation/coordinator.h"

#include <algorithm>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_split.h"
#include "coordinator/state/task_choice.h"

namespace tilemend::simulation {
namespace {

constexpr absl::Duration kInterval = absl::Seconds(1);

}  // namespace

void Coordinator::WhenAwake(std::function<void()> action) {
  const int process = process_;
  if (process == 0) return;
  if (world_.now() >= paused_until_) return action();
  world_.After(paused_until_ - world_.now(), [this, process, action = std::move(action)] {
    if (process_ == process) WhenAwake(action);
  });
}

void Coordinator::WhenDurable(std::function<void()> action) {
  if (store_.committed() == store_.put() && waiting_.empty()) return action();
  waiting_.emplace_back(store_.put(), std::move(action));
  CommitSoon();
}

void Coordinator::CommitSoon() {
  if (std::exchange(is_committing_, true)) return;
  const int process = process_;
  world_.After(world_.random.Time(1, 8), [this, process] {
    if (process_ != process) return;
    WhenAwake([this] {
      if (world_.random.Chance(world_.faults.failing_store)) return Crash();
      is_committing_ = false;
      store_.Commit();
      while (!waiting_.empty() && waiting_.front().first <= store_.committed()) {
        const auto action = std::move(waiting_.front().second);
        waiting_.pop_front();
        action();
      }
      if (!waiting_.empty()) CommitSoon();
    });
  });
}

void Coordinator::Boot() {
  process_ = ++last_process_;
  paused_until_ = absl::InfinitePast();
  store_.Open();
  StateOptions options;
  options.epoch = store_.epoch();
  state_ = std::make_unique<CoordinatorState>(options);
  patience_.emplace(kInterval, kLease);
  for (const SetAsideRecord& aside : store_.TakeSetAside()) set_aside_.insert(aside.worker);
  for (const JobRecord& record : store_.TakeJobs()) Restore(record);
  Tick();
}

void Coordinator::Crash() {
  if (process_ == 0) return;
  ++tally_.crashes;
  process_ = 0;
  store_.Crash();
  waiting_.clear();
  is_committing_ = false;
  entries_.clear();
  sequences_.clear();
  set_aside_.clear();
  suspected_.clear();
  valid_.clear();
  world_.After(world_.random.Time(100, 3000), [this] { Boot(); });
}

void Coordinator::Tick() {
  if (patience_->IsOver(world_.now())) {
    for (const Event& event : Overdue(*state_, world_.now(), kLease)) {
      if (const auto* lost = std::get_if<WorkerLost>(&event)) sequences_.erase(lost->worker);
      Apply(event);
    }
  }
  const auto may = [this](const std::string& worker, const std::string&) { return MayWork(worker); };
  for (const Event& event : Abandoned(*state_, world_.now(), may)) {
    Require(Apply(event).has_value(), "a task cannot be abandoned");
  }
  CheckState();
  const int process = process_;
  world_.After(kInterval, [this, process] {
    if (process_ == process) WhenAwake([this] { Tick(); });
  });
}

void Coordinator::Trace(const Event& event) {
  ++tally_.events;
  tally_.trace = tally_.trace * 31 + event.index();
  tally_.trace = tally_.trace * 31 + static_cast<uint64_t>(absl::ToUnixMillis(world_.now()));
}

std::optional<Effects> Coordinator::Apply(const Event& event) {
  Trace(event);
  const auto effects = state_->Apply(event);
  if (!effects.ok()) return std::nullopt;
  Account(event, *effects);
  tally_.struck += static_cast<int64_t>(effects->struck.size());
  for (const StruckTask& task : effects->struck) {
    ResultRecord record;
    record.state = TaskState::kPending;
    record.lost_workers = task.lost_workers;
    store_.PutResult(state_->FindJob(task.key.job)->number, {task.cell, task.stage, task.input}, std::move(record));
    CommitSoon();
  }
  std::map<std::string, int> beginnings;  // as they are now: what is delivered below may make a job begin again
  for (const SettledTask& task : effects->settled) beginnings[task.key.job] = entries_.at(task.key.job).beginnings;
  for (const SettledTask& task : effects->settled) {
    const std::string output = task.state == TaskState::kCommitted ? task.output : "-";
    if (!task.known) {
      Require(task.state != TaskState::kCommitted || task.output == Mix(task.input) || task.output == kPlausible,
              "a wrong result was committed");
      (task.state == TaskState::kCommitted ? tally_.committed
       : task.state == TaskState::kFailed  ? tally_.failed
                                           : tally_.quarantined) += 1;
      ResultRecord record;
      record.state = task.state;
      record.output = task.output;
      record.worker = task.worker;
      store_.PutResult(state_->FindJob(task.key.job)->number, {task.cell, task.stage, task.input}, std::move(record));
    }
    WhenDurable([this, process = process_, beginning = beginnings[task.key.job], task, output] {
      if (process_ == process && entries_.at(task.key.job).beginnings == beginning) Deliver(task, output);
    });
  }
  TakeVerdicts(*effects);
  for (const Revoked& revoked : effects->revoked) Revoke(revoked);
  return *effects;
}

void Coordinator::TakeVerdicts(const Effects& effects) {
  for (const auto& [worker, reason] : effects.set_aside) {
    set_aside_.insert(worker);
    ever_set_aside_.insert(worker);
    suspected_.erase(worker);
    store_.PutSetAside({worker, reason});
  }
  for (const auto& [worker, reason] : effects.suspected) {
    ++tally_.suspected;
    const bool is_disproved = !effects.revoked.empty();  // maybe by several jobs, long after its last task
    Require(MayWork(worker) || is_disproved, "a worker that was set aside got a task");
    suspected_.insert(worker);
  }
  for (const std::string& worker : effects.cleared) tally_.cleared += static_cast<int64_t>(suspected_.erase(worker));
  for (const auto* blamed : {&effects.set_aside, &effects.suspected}) {
    for (const auto& [worker, reason] : *blamed) {
      if (state_->FindWorker(worker) != nullptr) Apply(WorkerLeft{worker});
    }
  }
}

void Coordinator::Deliver(const SettledTask& task, const std::string& output) {
  const std::string& id = task.key.job;
  if (IsOver(state_->FindJob(id)->state)) return;
  Entry& entry = entries_.at(id);
  const int beginnings = entry.beginnings;
  if (output == kPlausible) entry.wrong.push_back(task.worker);
  if (!entry.wrong.empty() && world_.random.Chance(20)) return Disprove(id, entry.wrong.front());
  AddTasks(id, entry.pipeline->Take(task.cell, output));
  if (entry.beginnings == beginnings && !IsOver(state_->FindJob(id)->state)) EndIfDone(id);
}

void Coordinator::AddTasks(const std::string& id, std::vector<TaskSpec> tasks) {
  if (tasks.empty()) return;
  const int64_t number = state_->FindJob(id)->number;
  for (TaskSpec& task : tasks) {
    const auto found = store_.Find(number, {task.cell, task.stage, task.input});
    if (!found.ok() || !*found) continue;
    const ResultRecord& record = **found;
    if (IsSettled(record.state)) {
      task.known = KnownResult{record.state, record.output, absl::OkStatus(), record.worker};
    } else {
      task.lost_workers = record.lost_workers;
    }
  }
  Apply(TasksAdded{id, std::move(tasks)});
}

void Coordinator::EndIfDone(const std::string& id) {
  Entry& entry = entries_.at(id);
  if (entry.pipeline->outcome().empty()) return;
  if (!entry.wrong.empty()) return Disprove(id, entry.wrong.front());
  const TaskCounts& counts = state_->FindJob(id)->counts;
  EndJob(id, counts.failed > 0 ? JobState::kPartial : JobState::kDone, entry.pipeline->outcome());
}

void Coordinator::EndJob(const std::string& id, JobState state, const std::string& outcome) {
  entries_.at(id).outcome = outcome;
  Apply(JobFinished{id, state, world_.now()});
  PutJob(*state_->FindJob(id));
}

void Coordinator::Disprove(const std::string& id, const std::string& worker) {
  const auto may = [this](const std::string& w, const std::string&) { return MayWork(w); };
  const bool another = HasOtherWorker(*state_, worker, id, may);
  if (!Apply(WorkerDisproved{id, worker, "it swindled", another})) EndJob(id, JobState::kFailed, "-");
}

void Coordinator::Revoke(const Revoked& revoked) {
  ++tally_.revoked;
  store_.DropResults(state_->FindJob(revoked.job)->number, revoked.worker);
  const int beginning = ++entries_.at(revoked.job).beginnings;
  WhenDurable([this, process = process_, id = revoked.job, beginning] {
    if (process_ == process) BeginAgain(id, beginning);
  });
}

void Coordinator::BeginAgain(const std::string& id, int beginning) {
  Entry& entry = entries_.at(id);
  if (entry.beginnings != beginning || IsOver(state_->FindJob(id)->state)) return;
  Require(Apply(JobRedone{id}).has_value(), "a job could not begin again");
  entry.pipeline = std::make_unique<Pipeline>(id);
  entry.wrong.clear();
  // Since the revocation more was settled: it is found when it is asked for.
  WhenDurable([this, process = process_, id, last = ++entry.beginnings] {
    if (process_ != process || entries_.at(id).beginnings != last) return;
    if (!IsOver(state_->FindJob(id)->state)) AddTasks(id, entries_.at(id).pipeline->Start());
  });
}

void Coordinator::PutJob(const Job& job) {
  const std::string body = absl::StrCat(job.id, " ", static_cast<int>(job.state), " ", entries_[job.id].outcome);
  store_.PutJob({job.number, job.request_id, body, IsOver(job.state), true});
  CommitSoon();
}

void Coordinator::Restore(const JobRecord& record) {
  const std::vector<std::string> words = absl::StrSplit(record.body, ' ');
  Job job;
  job.id = words[0];
  job.request_id = record.request_id;
  job.number = record.number;
  job.state = static_cast<JobState>(words[1].front() - '0');
  const std::string id = job.id;
  entries_[id].outcome = words[2];
  const bool is_over = IsOver(job.state);
  Require(Apply(JobRestored{std::move(job)}).has_value(), "a job could not be restored");
  if (is_over) return;
  Entry& entry = entries_[id];
  entry.pipeline = std::make_unique<Pipeline>(id);
  AddTasks(id, entry.pipeline->Start());
}

void Coordinator::OnSubmit(const std::string& name, const std::function<void()>& answer) {
  WhenAwake([this, name, answer] {
    if (state_->FindRequest(name) == nullptr) {
      Apply(JobCreated{name, name, world_.now()});
      Entry& entry = entries_[name];
      entry.pipeline = std::make_unique<Pipeline>(name);
      PutJob(*state_->FindJob(name));
      WhenDurable([this, name, process = process_] {
        if (process_ == process && !IsOver(state_->FindJob(name)->state)) {
          AddTasks(name, entries_.at(name).pipeline->Start());
        }
      });
    }
    WhenDurable(answer);
  });
}

void Coordinator::OnCancel(const std::string& name) {
  WhenAwake([this, name] {
    const Job* job = state_->FindJob(name);
    if (job == nullptr || IsOver(job->state)) return;
    Apply(JobCancelled{name, world_.now()});
    PutJob(*job);
  });
}

void Coordinator::OnGet(const std::string& name, const std::function<void(Told)>& answer) {
  WhenAwake([this, name, answer] {
    const Job* job = state_->FindJob(name);
    Require(job != nullptr, "a job that a client was told of is not there");
    if (job == nullptr) return;
    WhenDurable([answer, told = Told{job->state, entries_.at(name).outcome}] { answer(told); });
  });
}

void Coordinator::OnSync(const Request& request, const std::function<void(Response)>& answer) {
  WhenAwake([this, request, answer] {
    uint64_t& last = sequences_[request.worker];
    if (request.sequence < last) return;  // a newer call took over
    last = request.sequence;
    const Response response = Sync(request);
    WhenDurable([answer, response] { answer(response); });
  });
}

Response Coordinator::Sync(const Request& request) {
  Response response;
  Apply(WorkerSeen{request.worker, request.threads, request.draining, world_.now(), request.prefetch});
  for (const Report& report : request.finished) {
    TakeReport(request.worker, report);
    response.acknowledged.push_back(report.attempt);
  }
  for (const Attempt& a : request.held) {
    Apply(LeaseRenewed{a.key, request.worker, a.token, world_.now() + kLease, request.begun.contains(a.token)});
  }
  if (request.draining && request.held.empty()) {
    Apply(WorkerLeft{request.worker});
    sequences_.erase(request.worker);
    response.leave = true;
    return response;
  }
  const auto may = [this](const std::string& worker, const std::string&) { return MayWork(worker); };
  for (const TaskKey& key : ChooseTasks(*state_, request.worker, world_.now(), may)) {
    tally_.doubled += state_->FindTask(key)->leases.empty() ? 0 : 1;
    const uint64_t token = world_.random.Next() | 1;
    Require(Apply(TaskLeased{key, request.worker, token, world_.now(), world_.now() + kLease}).has_value(),
            "a chosen task could not be leased");
  }
  const WorkerRecord* worker = state_->FindWorker(request.worker);
  if (worker == nullptr) return response;
  std::set<uint64_t> known;
  for (const Attempt& a : request.held) {
    const Task* task = state_->FindTask(a.key);
    if (task == nullptr || FindLease(*task, request.worker, a.token) == nullptr) continue;
    known.insert(a.token);
    response.keep.push_back(a);
  }
  for (const TaskKey& key : worker->held) {
    const Task& task = *state_->FindTask(key);
    const uint64_t token = LeaseOf(task, request.worker)->token;
    if (!known.contains(token)) response.start.push_back({{key, token}, task.cell, task.stage, task.input});
  }
  return response;
}

Event Coordinator::EventOf(const std::string& worker, const Report& report, const Task* task) {
  const auto& [key, token] = report.attempt;
  const auto may = [this](const std::string& w, const std::string&) { return MayWork(w); };
  const bool another = task != nullptr && HasAnother(*state_, worker, *state_->FindJob(key.job), *task, may);
  if (report.output.empty()) {
    return TaskFailed{key, worker, token, true, another, absl::UnavailableError("disk"), world_.now()};
  }
  const bool is_held = task != nullptr && FindLease(*task, worker, token) != nullptr;
  if (is_held && report.output != Mix(task->input) && report.output != kPlausible) {
    return TaskFailed{key, worker, token, true, another, absl::InternalError("wrong"), world_.now(), report.output};
  }
  return TaskCompleted{key, worker, token, report.output, world_.now()};
}

void Coordinator::TakeReport(const std::string& worker, const Report& report) {
  const Task* task = state_->FindTask(report.attempt.key);
  const bool is_valid = IsValid(report.attempt, worker);
  const Event event = EventOf(worker, report, task);
  const auto effects = Apply(event);
  const bool has_effect = effects && (!effects->settled.empty() || !effects->retried.empty());
  Require(is_valid || !has_effect, "the result of an attempt that was given up has been taken");
  Require(!is_valid || effects.has_value(), "the result of an attempt that was not given up has been refused");
  tally_.refused_late += !effects ? 1 : 0;
}

bool Coordinator::IsValid(const Attempt& attempt, const std::string& worker) const {
  const auto found = valid_.find(attempt.token);
  return found != valid_.end() && found->second == std::pair(attempt.key, worker);
}

void Coordinator::Account(const Event& event, const Effects& effects) {
  const auto drop = [this](const auto& is_ended) {
    std::erase_if(valid_,
                  [&](const auto& entry) { return is_ended(entry.first, entry.second.first, entry.second.second); });
  };
  if (const auto* leased = std::get_if<TaskLeased>(&event)) valid_[leased->token] = {leased->key, leased->worker};
  if (const auto* failed = std::get_if<TaskFailed>(&event)) valid_.erase(failed->token);
  if (const auto* expired = std::get_if<LeaseExpired>(&event)) valid_.erase(expired->token);
  const auto* lost = std::get_if<WorkerLost>(&event);
  const auto* left = std::get_if<WorkerLeft>(&event);
  if (lost != nullptr || left != nullptr) {
    const std::string& gone = lost != nullptr ? lost->worker : left->worker;
    drop([&](uint64_t, const TaskKey&, const std::string& worker) { return worker == gone; });
  }
  for (const SettledTask& settled : effects.settled) {
    drop([&](uint64_t, const TaskKey& key, const std::string&) { return key == settled.key; });
  }
  const auto drop_job = [&](const std::string& job) {
    drop([&](uint64_t, const TaskKey& key, const std::string&) { return key.job == job; });
  };
  if (const auto* cancelled = std::get_if<JobCancelled>(&event)) drop_job(cancelled->job);
  if (const auto* finished = std::get_if<JobFinished>(&event)) drop_job(finished->job);
  if (const auto* redone = std::get_if<JobRedone>(&event)) drop_job(redone->job);
}

void Coordinator::CheckState() {
  size_t leases = 0;
  for (const auto& [id, job] : state_->jobs()) {
    if (IsOver(job.state)) {
      Require(job.tasks.empty() && job.pending.size() == 0 && job.alone.empty(), "a job that is over has tasks");
      continue;
    }
    for (const auto& [worker, disproof] : job.doubts.disproved) {
      Require(!disproof.others_do_it || !MayWork(worker), "a worker whose results were revoked may work");
    }
    const TaskCounts& c = job.counts;
    Require(c.added == c.pending + c.leased + c.settled(), "a task was lost");
    Require(static_cast<size_t>(c.pending) == job.pending.size(), "the pending tasks are not those counted");
    int64_t leased = 0;
    size_t alone = 0, doubted = 0;
    std::map<std::string, int64_t> refusals;
    for (const auto& [number, task] : job.tasks) {
      doubted += task.refused.empty() ? 0 : 1;
      for (const auto& [worker, refusal] : task.refused) ++refusals[worker];
      leased += task.leases.empty() ? 0 : 1;
      alone += task.leases.size() == 1 ? 1 : 0;
      leases += task.leases.size();
      Require((task.state == TaskState::kLeased) == !task.leases.empty(), "a task is leased to nobody");
      for (const Lease& lease : task.leases) {
        const WorkerRecord* worker = state_->FindWorker(lease.worker);
        Require(worker != nullptr && worker->held.contains({id, number}), "a lease whose holder does not know of it");
      }
    }
    Require(doubted == job.doubts.tasks.size() && refusals == job.doubts.refusals,
            "the refusals are not those counted");
    Require(leased == c.leased && alone == job.alone.size(), "the leased tasks are not those counted");
  }
  Require(leases == valid_.size(), "other attempts are valid than were given out");
}

}  // namespace tilemend::simulation
