// A state with shorthand for events.
#ifndef TILEMEND_TESTS_COORDINATOR_STATE_STATE_FIXTURE_H_
#define TILEMEND_TESTS_COORDINATOR_STATE_STATE_FIXTURE_H_

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"
#include "common/util/error_info.h"
#include "coordinator/state/task_choice.h"

namespace tilemend {

inline TaskKey Key(const std::string& job, int64_t task) { return {job, task}; }

// Each event is expected to be accepted.
class StateTest : public ::testing::Test {
 protected:
  static constexpr absl::Duration kLease = absl::Seconds(10);

  explicit StateTest(const StateOptions& options = {}) : state_(options) {}

  Effects Do(const Event& event) {
    auto effects = state_.Apply(event);
    EXPECT_TRUE(effects.ok()) << effects.status();
    return effects.ok() ? *std::move(effects) : Effects();
  }
  void AddJob(const std::string& job, int tasks) {
    Do(JobCreated{job, "", now_});
    AddTasks(job, tasks);
  }
  void AddTasks(const std::string& job, int tasks) {
    TasksAdded event{job, {}};
    for (int i = 0; i < tasks; ++i) event.tasks.push_back({{i, 0}, Stage::kFill, absl::StrCat("in", i)});
    Do(event);
  }
  void See(const std::string& worker, int threads = 1, bool draining = false, int prefetch = 0) {
    Do(WorkerSeen{worker, threads, draining, now_, prefetch});
  }
  uint64_t Lease(const TaskKey& key, const std::string& worker) {
    const uint64_t token = ++last_token_;
    Do(TaskLeased{key, worker, token, now_, now_ + kLease});
    return token;
  }
  Effects Complete(const TaskKey& key, const std::string& worker, uint64_t token) {
    return Do(TaskCompleted{key, worker, token, "out", now_});
  }
  // A machine error.
  Effects Return(const TaskKey& key, const std::string& worker, uint64_t token, bool another = false) {
    return Do(TaskFailed{key, worker, token, true, another, absl::UnavailableError("disk"), now_});
  }
  std::vector<TaskKey> Choose(const std::string& worker, const MayWork& may = MayAlways) {
    return ChooseTasks(state_, worker, now_, may);
  }
  const TaskCounts& Counts(const std::string& job) { return state_.FindJob(job)->counts; }
  std::string ReasonOf(const Event& event) { return ErrorReason(state_.Apply(event).status()); }

  absl::Time now_ = absl::FromUnixSeconds(1000);
  uint64_t last_token_ = 100;
  CoordinatorState state_;
};

}  // namespace tilemend

#endif  // TILEMEND_TESTS_COORDINATOR_STATE_STATE_FIXTURE_H_
