// Random histories: whatever workers do, and however often the coordinator ends and starts again from what it has put
// down, every task is settled exactly once and none is lost.
#include <gtest/gtest.h>

#include <map>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"
#include "coordinator/state/coordinator_state.h"

namespace tilemend {
namespace {

constexpr absl::Duration kLease = absl::Seconds(10);

class History {
 public:
  explicit History(uint32_t seed, int32_t quarantine_after)
      : quarantine_after_(quarantine_after),
        state_({.quarantine_after = quarantine_after, .epoch = 3}),
        random_(seed) {}

  void Step() {
    now_ += absl::Milliseconds(Draw(3000));
    switch (Draw(12)) {
      case 0:
        return NewJob();
      case 1:
        return MoreTasks();
      case 2:
      case 3:
        return See(absl::StrCat("w", Draw(5)));
      case 4:
      case 5:
        return Lease();
      case 6:
      case 7:
        return Report(false);
      case 8:
        return Report(true);  // something that was given out long ago, perhaps again
      case 9:
        return LoseAWorker();
      case 10:
        return Expire();
      default:
        return Draw(20) == 0 ? CancelAJob() : Renew();
    }
  }

  // Another coordinator begins with what this one has put down: jobs, results and strikes.
  void Restart() {
    const CoordinatorState before =
        std::exchange(state_, CoordinatorState({.quarantine_after = quarantine_after_, .epoch = ++epoch_}));
    for (const auto& [number, id] : before.job_numbers()) {
      Job job = *before.FindJob(id);
      const int64_t settled = job.counts.settled();
      job.tasks.clear();
      job.pending.clear();
      if (!IsOver(job.state)) job.counts = {};
      ASSERT_TRUE(state_.Apply(JobRestored{job}).ok());
      EXPECT_GT(state_.FindJob(id)->version, before.FindJob(id)->version);
      if (IsOver(job.state)) continue;
      TasksAdded again{id, added_[id]};
      for (size_t i = 0; i < again.tasks.size(); ++i) {
        const TaskKey key{id, static_cast<int64_t>(i) + 1};
        if (const auto it = results_.find(key); it != results_.end()) again.tasks[i].known = it->second;
        again.tasks[i].lost_workers = struck_[key];
      }
      const auto effects = state_.Apply(again);
      ASSERT_TRUE(effects.ok());
      ASSERT_EQ(static_cast<int64_t>(effects->settled.size()), settled);
      for (const SettledTask& task : effects->settled) {
        EXPECT_TRUE(task.known);
        EXPECT_EQ(task.output, results_.at(task.key).output);
      }
    }
    EXPECT_GT(state_.NextToken(), before.NextToken());
  }

  // A good worker does what is left.
  void Finish() {
    Expire();
    while (!state_.workers().empty()) Apply(WorkerLeft{state_.workers().begin()->first});
    Apply(WorkerSeen{"good", 4, false, now_});
    for (int rounds = 0; rounds < 100'000; ++rounds) {
      const std::vector<TaskKey> keys = state_.ChooseTasks("good");
      if (keys.empty()) break;
      for (const TaskKey& key : keys) {
        const uint64_t token = state_.NextToken();
        Apply(TaskLeased{key, "good", token, now_, now_ + kLease});
        Apply(TaskCompleted{key, token, absl::StrCat("out", token)});
      }
    }
  }

  void CheckCounts() const {
    for (const auto& [id, job] : state_.jobs()) {
      if (IsOver(job.state)) {
        EXPECT_TRUE(job.tasks.empty());
        continue;
      }
      const TaskCounts& c = job.counts;
      ASSERT_EQ(c.added, c.pending + c.leased + c.settled());
      ASSERT_EQ(static_cast<size_t>(c.pending), job.pending.size());
      int64_t held = 0;
      for (const auto& [number, task] : job.tasks) {
        if (task.state != TaskState::kLeased) continue;
        ++held;
        const WorkerRecord* worker = state_.FindWorker(task.worker);
        ASSERT_NE(worker, nullptr);
        ASSERT_TRUE(worker->held.contains({id, number}));
      }
      ASSERT_EQ(held, c.leased);
    }
  }

  void CheckAllSettledOnce() const {
    for (const auto& [id, job] : state_.jobs()) {
      if (IsOver(job.state)) continue;
      EXPECT_EQ(job.counts.settled(), job.counts.added);
      for (const auto& [number, task] : job.tasks) {
        const auto it = settled_.find({id, number});
        EXPECT_EQ(it == settled_.end() ? 0 : it->second, 1) << id << " task " << number;
      }
    }
  }

  const CoordinatorState& state() const { return state_; }

 private:
  int Draw(int below) { return static_cast<int>(random_() % static_cast<uint32_t>(below)); }

  void Apply(const Event& event) {
    const auto effects = state_.Apply(event);
    if (!effects.ok()) return;
    for (const SettledTask& task : effects->settled) {
      ++settled_[task.key];
      EXPECT_EQ(task.input, added_.at(task.key.job).at(static_cast<size_t>(task.key.task) - 1).input);
      results_[task.key] = {task.state, task.output, task.error};
    }
    for (const StruckTask& task : effects->struck) struck_[task.key] = task.lost_workers;
  }
  std::string AnyJob() { return state_.jobs().empty() ? "none" : absl::StrCat("j", Draw(jobs_)); }

  void NewJob() {
    if (jobs_ >= 6) return;
    Apply(JobCreated{absl::StrCat("j", jobs_++), "", now_});
  }
  void MoreTasks() {
    TasksAdded event{AnyJob(), {}};
    const Job* job = state_.FindJob(event.job);
    if (job == nullptr || IsOver(job->state)) return;
    std::vector<TaskSpec>& added = added_[event.job];
    for (int i = Draw(6); i >= 0; --i) {
      event.tasks.push_back({{Draw(9), Draw(9)}, kAllStages[Draw(4)], absl::StrCat("in", added.size())});
      added.push_back(event.tasks.back());
    }
    Apply(event);
  }
  void See(const std::string& worker) { Apply(WorkerSeen{worker, 1 + Draw(4), Draw(10) == 0, now_}); }
  void Lease() {
    const std::string worker = absl::StrCat("w", Draw(5));
    for (const TaskKey& key : state_.ChooseTasks(worker)) {
      const uint64_t token = state_.NextToken();
      given_.push_back({key, token});
      Apply(TaskLeased{key, worker, token, now_, now_ + kLease});
    }
  }
  void Report(bool any) {
    if (given_.empty()) return;
    const size_t back = any ? given_.size() : std::min<size_t>(given_.size(), 4);
    const auto& [key, token] = given_[given_.size() - 1 - static_cast<size_t>(Draw(static_cast<int>(back)))];
    if (Draw(4) > 0) return Apply(TaskCompleted{key, token, absl::StrCat("out", token)});
    Apply(TaskFailed{key, token, Draw(2) == 0, absl::UnknownError("random")});
  }
  void LoseAWorker() {
    const std::string worker = absl::StrCat("w", Draw(5));
    Draw(2) == 0 ? Apply(WorkerLost{worker}) : Apply(WorkerLeft{worker});
  }
  void Expire() {
    for (const Event& event : state_.Overdue(now_, kLease)) Apply(event);
  }
  void Renew() {
    if (given_.empty()) return;
    const auto& [key, token] = given_.back();
    Apply(LeaseRenewed{key, token, now_ + kLease});
  }
  void CancelAJob() { Apply(JobCancelled{AnyJob(), now_}); }

  const int32_t quarantine_after_;
  uint32_t epoch_ = 3;
  CoordinatorState state_;
  std::mt19937 random_;
  absl::Time now_ = absl::FromUnixSeconds(1000);
  int jobs_ = 0;
  std::vector<std::pair<TaskKey, uint64_t>> given_;
  std::map<TaskKey, int> settled_;
  std::map<std::string, std::vector<TaskSpec>> added_;  // by job
  std::map<TaskKey, KnownResult> results_;
  std::map<TaskKey, std::vector<std::string>> struck_;
};

class StatePropertyTest : public ::testing::TestWithParam<int32_t> {};

TEST_P(StatePropertyTest, EveryTaskIsSettledExactlyOnceAndNoneIsLost) {
  for (uint32_t seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(absl::StrCat("seed ", seed));
    History history(seed, GetParam());
    for (int step = 0; step < 400; ++step) {
      history.Step();
      history.CheckCounts();
      if (HasFatalFailure()) return;
    }
    history.Finish();
    history.CheckCounts();
    history.CheckAllSettledOnce();
    if (HasFailure()) return;
  }
}

TEST_P(StatePropertyTest, NothingIsLostOrDoneTwiceOverRestarts) {
  for (uint32_t seed = 0; seed < 100; ++seed) {
    SCOPED_TRACE(absl::StrCat("seed ", seed));
    History history(seed, GetParam());
    for (int step = 0; step < 400; ++step) {
      history.Step();
      if (step % 37 == 0) history.Restart();
      history.CheckCounts();
      if (HasFatalFailure()) return;
    }
    history.Finish();
    history.Restart();
    history.CheckCounts();
    history.CheckAllSettledOnce();
    if (HasFailure()) return;
  }
}

TEST_P(StatePropertyTest, TheSameEventsGiveTheSameState) {
  for (uint32_t seed = 0; seed < 20; ++seed) {
    History first(seed, GetParam());
    History second(seed, GetParam());
    for (int step = 0; step < 400; ++step) {
      first.Step();
      second.Step();
      ASSERT_EQ(first.state().NextToken(), second.state().NextToken());
      ASSERT_EQ(first.state().ChooseTasks("w1"), second.state().ChooseTasks("w1"));
    }
    for (const auto& [id, job] : first.state().jobs()) EXPECT_EQ(job.counts, second.state().FindJob(id)->counts);
  }
}

INSTANTIATE_TEST_SUITE_P(QuarantineAfter, StatePropertyTest, ::testing::Values(1, 2, 3, 1000));

}  // namespace
}  // namespace tilemend
