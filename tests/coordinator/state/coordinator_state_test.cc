#include "coordinator/state/coordinator_state.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "absl/strings/str_cat.h"
#include "common/util/error_info.h"

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

const absl::Time kStart = absl::FromUnixSeconds(1000);
constexpr absl::Duration kLease = absl::Seconds(10);

TaskKey Key(const std::string& job, int64_t task) { return {job, task}; }

// A state with shorthand for events; each expects the event to be accepted.
class CoordinatorStateTest : public ::testing::Test {
 protected:
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
  void See(const std::string& worker, int threads = 1, bool draining = false) {
    Do(WorkerSeen{worker, threads, draining, now_});
  }
  uint64_t Lease(const TaskKey& key, const std::string& worker) {
    const uint64_t token = state_.NextToken();
    Do(TaskLeased{key, worker, token, now_, now_ + kLease});
    return token;
  }
  const TaskCounts& Counts(const std::string& job) { return state_.FindJob(job)->counts; }
  std::string ReasonOf(const Event& event) { return ErrorReason(state_.Apply(event).status()); }

  absl::Time now_ = kStart;
  CoordinatorState state_;
};

TEST_F(CoordinatorStateTest, CommitsAResultOnce) {
  AddJob("a", 1);
  See("w");
  const uint64_t token = Lease(Key("a", 1), "w");
  const Effects effects = Do(TaskCompleted{Key("a", 1), token, "out"});
  ASSERT_THAT(effects.settled, SizeIs(1));
  EXPECT_EQ(effects.settled[0].output, "out");
  EXPECT_EQ(effects.settled[0].state, TaskState::kCommitted);
  EXPECT_EQ(Counts("a").committed, 1);
  EXPECT_THAT(state_.FindWorker("w")->held, IsEmpty());
}

TEST_F(CoordinatorStateTest, AcceptsTheSameReportAgainWithoutEffect) {
  AddJob("a", 1);
  See("w");
  const uint64_t token = Lease(Key("a", 1), "w");
  Do(TaskCompleted{Key("a", 1), token, "out"});
  EXPECT_THAT(Do(TaskCompleted{Key("a", 1), token, "out"}).settled, IsEmpty());
  EXPECT_EQ(Counts("a").committed, 1);
  EXPECT_EQ(Counts("a").refused_late, 0);
}

TEST_F(CoordinatorStateTest, RefusesAndCountsTheResultOfAnExpiredLease) {
  AddJob("a", 1);
  See("slow");
  See("fast");
  const uint64_t late = Lease(Key("a", 1), "slow");
  Do(LeaseExpired{Key("a", 1), late});
  const uint64_t token = Lease(Key("a", 1), "fast");
  EXPECT_EQ(ReasonOf(TaskCompleted{Key("a", 1), late, "late"}), "LATE_RESULT");
  EXPECT_THAT(Do(TaskCompleted{Key("a", 1), token, "out"}).settled, SizeIs(1));
  EXPECT_EQ(ReasonOf(TaskCompleted{Key("a", 1), late, "late"}), "LATE_RESULT");
  EXPECT_EQ(Counts("a").refused_late, 2);
  EXPECT_EQ(Counts("a").committed, 1);
}

TEST_F(CoordinatorStateTest, RefusesTokensOfAnEarlierEpoch) {
  CoordinatorState old({.epoch = 7});
  CoordinatorState young({.epoch = 8});
  EXPECT_GT(young.NextToken(), old.NextToken() + 1'000'000);
}

TEST_F(CoordinatorStateTest, GivesTasksInOrderOldestJobFirst) {
  AddJob("b", 2);
  AddJob("a", 2);
  See("w", 3);
  EXPECT_THAT(state_.ChooseTasks("w"), ElementsAre(TaskKey{"b", 1}, TaskKey{"b", 2}, TaskKey{"a", 1}));
  Lease(Key("b", 1), "w");
  EXPECT_THAT(state_.ChooseTasks("w"), ElementsAre(TaskKey{"b", 2}, TaskKey{"a", 1}));
}

TEST_F(CoordinatorStateTest, GivesNothingToUnknownAndDrainingWorkers) {
  AddJob("a", 1);
  EXPECT_THAT(state_.ChooseTasks("nobody"), IsEmpty());
  See("w", 1, true);
  EXPECT_THAT(state_.ChooseTasks("w"), IsEmpty());
}

TEST_F(CoordinatorStateTest, TellsWhatIsOverdue) {
  AddJob("a", 2);
  See("quiet");
  See("forgetful");
  Lease(Key("a", 1), "quiet");
  const uint64_t token = Lease(Key("a", 2), "forgetful");
  EXPECT_THAT(state_.Overdue(now_ + kLease, kLease), IsEmpty());
  now_ += kLease + absl::Seconds(1);
  See("forgetful");
  const std::vector<Event> events = state_.Overdue(now_, kLease);
  ASSERT_THAT(events, SizeIs(2));
  EXPECT_EQ(std::get<LeaseExpired>(events[0]).token, token);
  EXPECT_EQ(std::get<WorkerLost>(events[1]).worker, "quiet");
}

TEST_F(CoordinatorStateTest, RenewalMovesTheDeadline) {
  AddJob("a", 1);
  See("w");
  const uint64_t token = Lease(Key("a", 1), "w");
  now_ += kLease;
  Do(LeaseRenewed{Key("a", 1), token, now_ + kLease});
  See("w");
  EXPECT_THAT(state_.Overdue(now_ + kLease, kLease), IsEmpty());
}

TEST_F(CoordinatorStateTest, QuarantinesATaskAfterThreeLostWorkers) {
  AddJob("a", 1);
  Effects last;
  for (const std::string worker : {"w1", "w2", "w3"}) {
    See(worker);
    ASSERT_THAT(state_.ChooseTasks(worker), SizeIs(1));
    Lease(Key("a", 1), worker);
    last = Do(WorkerLost{worker});
  }
  ASSERT_THAT(last.settled, SizeIs(1));
  EXPECT_EQ(last.settled[0].state, TaskState::kQuarantined);
  EXPECT_THAT(std::string(last.settled[0].error.message()), HasSubstr("w1, w2, w3"));
  EXPECT_EQ(ErrorReason(last.settled[0].error), "QUARANTINED");
  EXPECT_EQ(Counts("a").retried, 2);
  Do(JobFinished{"a", JobState::kDone, now_});
  EXPECT_EQ(state_.FindJob("a")->state, JobState::kPartial);
}

TEST_F(CoordinatorStateTest, GivesALastChanceAlone) {
  AddJob("a", 3);
  for (const std::string worker : {"w1", "w2"}) {
    See(worker);
    Lease(Key("a", 1), worker);
    Do(WorkerLost{worker});
  }
  See("w", 4);
  EXPECT_THAT(state_.ChooseTasks("w"), ElementsAre(TaskKey{"a", 1}));
  Lease(Key("a", 1), "w");
  EXPECT_THAT(state_.ChooseTasks("w"), IsEmpty());
  See("other", 4);
  EXPECT_THAT(state_.ChooseTasks("other"), SizeIs(2));
}

TEST_F(CoordinatorStateTest, WorkerThatLeavesGivesItsTasksBackWithoutBlame) {
  AddJob("a", 1);
  for (int i = 0; i < 10; ++i) {
    const std::string worker = absl::StrCat("w", i);
    See(worker);
    Lease(Key("a", 1), worker);
    EXPECT_THAT(Do(WorkerLeft{worker}).retried, ElementsAre(Stage::kFill));
  }
  EXPECT_THAT(state_.FindTask(Key("a", 1))->lost_workers, IsEmpty());
}

TEST_F(CoordinatorStateTest, MachineErrorsAreRetriedThreeTimesInAll) {
  AddJob("a", 1);
  See("w");
  for (int i = 0; i < 2; ++i) {
    const uint64_t token = Lease(Key("a", 1), "w");
    EXPECT_THAT(Do(TaskFailed{Key("a", 1), token, true, absl::UnavailableError("disk")}).settled, IsEmpty());
  }
  const uint64_t token = Lease(Key("a", 1), "w");
  const Effects effects = Do(TaskFailed{Key("a", 1), token, true, absl::UnavailableError("disk")});
  ASSERT_THAT(effects.settled, SizeIs(1));
  EXPECT_EQ(effects.settled[0].state, TaskState::kFailed);
  EXPECT_EQ(effects.settled[0].error, absl::UnavailableError("disk"));
}

TEST_F(CoordinatorStateTest, TheTasksOwnErrorSettlesItAtOnce) {
  AddJob("a", 1);
  See("w");
  const uint64_t token = Lease(Key("a", 1), "w");
  EXPECT_THAT(Do(TaskFailed{Key("a", 1), token, false, absl::InvalidArgumentError("bad tile")}).settled, SizeIs(1));
  EXPECT_EQ(Counts("a").failed, 1);
}

TEST_F(CoordinatorStateTest, ACancelledJobTakesNothingMore) {
  AddJob("a", 2);
  See("w");
  const uint64_t token = Lease(Key("a", 1), "w");
  Do(JobCancelled{"a", now_});
  EXPECT_EQ(state_.FindJob("a")->state, JobState::kCancelled);
  EXPECT_THAT(state_.FindWorker("w")->held, IsEmpty());
  EXPECT_THAT(state_.ChooseTasks("w"), IsEmpty());
  EXPECT_EQ(ReasonOf(TaskCompleted{Key("a", 1), token, "out"}), "LATE_RESULT");
  EXPECT_EQ(ReasonOf(JobCancelled{"a", now_}), "JOB_OVER");
  EXPECT_EQ(ReasonOf(TasksAdded{"a", {}}), "JOB_OVER");
}

TEST_F(CoordinatorStateTest, RefusesEventsThatDoNotFit) {
  AddJob("a", 1);
  EXPECT_EQ(ReasonOf(TasksAdded{"b", {}}), "JOB_NOT_FOUND");
  EXPECT_TRUE(absl::IsAlreadyExists(state_.Apply(JobCreated{"a", "", now_}).status()));
  EXPECT_TRUE(absl::IsInvalidArgument(state_.Apply(TaskLeased{Key("a", 1), "nobody", 9, now_, now_}).status()));
  See("w");
  const uint64_t token = Lease(Key("a", 1), "w");
  EXPECT_TRUE(absl::IsInvalidArgument(state_.Apply(TaskLeased{Key("a", 1), "w", token + 1, now_, now_}).status()));
  AddTasks("a", 1);
  EXPECT_TRUE(absl::IsInvalidArgument(state_.Apply(TaskLeased{Key("a", 2), "w", token, now_, now_}).status()));
  EXPECT_TRUE(absl::IsInvalidArgument(state_.Apply(WorkerLost{"nobody"}).status()));
  EXPECT_TRUE(absl::IsInvalidArgument(state_.Apply(JobFinished{"a", JobState::kRunning, now_}).status()));
}

TEST_F(CoordinatorStateTest, FindsAJobByItsRequest) {
  Do(JobCreated{"a", "request", now_});
  EXPECT_EQ(state_.FindRequest("request")->id, "a");
  EXPECT_EQ(state_.FindRequest("other"), nullptr);
  EXPECT_TRUE(absl::IsAlreadyExists(state_.Apply(JobCreated{"b", "request", now_}).status()));
}

TEST_F(CoordinatorStateTest, EveryChangeOfAJobRaisesItsVersion) {
  AddJob("a", 1);
  uint64_t before = state_.FindJob("a")->version;
  Do(JobProgressed{"a", {.phase = "survey"}});
  EXPECT_GT(state_.FindJob("a")->version, before);
  before = state_.FindJob("a")->version;
  Do(JobProgressed{"a", {.phase = "survey"}});
  EXPECT_EQ(state_.FindJob("a")->version, before);
}

TEST_F(CoordinatorStateTest, GivesNoTaskOfAJobThatTheWorkerMayNotWorkOn) {
  AddJob("a", 1);
  AddJob("b", 1);
  See("w", 2);
  const auto only_b = [](const std::string&, const std::string& job) { return job == "b"; };
  EXPECT_THAT(state_.ChooseTasks("w", only_b), ElementsAre(TaskKey{"b", 1}));
}

class RefusedResultTest : public CoordinatorStateTest {
 protected:
  // A lease whose result is refused.
  Effects Refuse(const std::string& worker, const std::string& digest) {
    See(worker);
    const uint64_t token = Lease(Key("a", 1), worker);
    return Do(TaskFailed{Key("a", 1), token, true, absl::InternalError("wrong"), digest});
  }
};

TEST_F(RefusedResultTest, GoesToAnotherWorker) {
  AddJob("a", 1);
  EXPECT_THAT(Refuse("w", "x").retried, SizeIs(1));
  EXPECT_THAT(state_.ChooseTasks("w"), IsEmpty());
  See("other");
  EXPECT_THAT(state_.ChooseTasks("other"), ElementsAre(TaskKey{"a", 1}));
}

TEST_F(RefusedResultTest, HasFailedWhenTwoGiveTheSame) {
  AddJob("a", 1);
  Refuse("one", "x");
  const Effects effects = Refuse("other", "x");
  ASSERT_THAT(effects.settled, SizeIs(1));
  EXPECT_EQ(effects.settled[0].state, TaskState::kFailed);
}

TEST_F(RefusedResultTest, HasFailedWhenThreeWorkersAreWrong) {
  AddJob("a", 1);
  EXPECT_THAT(Refuse("one", "x").settled, IsEmpty());
  EXPECT_THAT(Refuse("two", "y").settled, IsEmpty());
  EXPECT_THAT(Refuse("three", "z").settled, SizeIs(1));
}

TEST_F(CoordinatorStateTest, KeepsAWarningOnceAndNotTooMany) {
  AddJob("a", 1);
  for (int i = 0; i < 100; ++i) Do(JobWarned{"a", absl::StrCat("worker ", i / 2)});
  EXPECT_THAT(state_.FindJob("a")->warnings, SizeIs(kMostWarnings));
  EXPECT_EQ(state_.FindJob("a")->warnings[1], "worker 1");
  EXPECT_EQ(ReasonOf(JobWarned{"b", "?"}), "JOB_NOT_FOUND");
}

TEST_F(CoordinatorStateTest, WhatOneMachineGivesBackGoesToAnotherFirst) {
  AddJob("a", 1);
  See("full");
  See("other");
  const uint64_t token = Lease(Key("a", 1), "full");
  Do(TaskFailed{Key("a", 1), token, true, absl::ResourceExhaustedError("the disk is full")});
  EXPECT_THAT(state_.ChooseTasks("full"), IsEmpty());
  EXPECT_THAT(state_.ChooseTasks("other"), ElementsAre(TaskKey{"a", 1}));
  const auto not_other = [](const std::string& worker, const std::string&) { return worker != "other"; };
  EXPECT_THAT(state_.ChooseTasks("full", not_other), SizeIs(1)) << "the other may not have it";
  Do(WorkerLeft{"other"});
  EXPECT_THAT(state_.ChooseTasks("full"), SizeIs(1)) << "there is no other any more";
}

TEST_F(CoordinatorStateTest, OneWorkerThatIsLostAgainAndAgainCountsOnce) {
  AddJob("a", 1);
  for (int i = 0; i < 8; ++i) {
    See("flapping");
    EXPECT_THAT(state_.ChooseTasks("flapping"), SizeIs(1)) << i;
    Lease(Key("a", 1), "flapping");
    EXPECT_THAT(Do(WorkerLost{"flapping"}).settled, IsEmpty()) << i;
  }
  EXPECT_THAT(state_.FindTask(Key("a", 1))->lost_workers, ElementsAre("flapping"));
  See("flapping");
  Lease(Key("a", 1), "flapping");
  EXPECT_THAT(Do(WorkerLost{"flapping"}).settled, SizeIs(1)) << "but not for ever";
}

TEST(LongestAttemptTest, EndsHoweverOftenTheLeaseIsRenewed) {
  CoordinatorState state({.longest_attempt = absl::Hours(1)});
  const absl::Time start = absl::FromUnixSeconds(1000);
  const auto apply = [&](const Event& event) { ASSERT_TRUE(state.Apply(event).ok()); };
  apply(JobCreated{"a", "", start});
  apply(TasksAdded{"a", {{{0, 0}, Stage::kFill, "in"}}});
  apply(WorkerSeen{"w", 1, false, start});
  const uint64_t token = state.NextToken();
  apply(TaskLeased{Key("a", 1), "w", token, start, start + absl::Seconds(10)});
  const absl::Time late = start + absl::Minutes(61);
  for (absl::Time now = start; now < late; now += absl::Minutes(1)) {
    apply(WorkerSeen{"w", 1, false, now});
    apply(LeaseRenewed{Key("a", 1), token, now + absl::Minutes(2)});
  }
  EXPECT_THAT(state.Overdue(start + absl::Minutes(59), absl::Minutes(5)), IsEmpty());
  EXPECT_THAT(state.Overdue(late, absl::Minutes(5)), SizeIs(1));
}

}  // namespace
}  // namespace tilemend
