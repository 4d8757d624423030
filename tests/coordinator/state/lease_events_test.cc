#include "coordinator/state/coordinator_state.h"
#include "tests/coordinator/state/state_fixture.h"

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

using LeaseEventsTest = StateTest;

TEST_F(LeaseEventsTest, CommitsAResultOnce) {
  AddJob("a", 1);
  See("w");
  const uint64_t token = Lease(Key("a", 1), "w");
  const Effects effects = Do(TaskCompleted{Key("a", 1), "w", token, "out", now_});
  ASSERT_THAT(effects.settled, SizeIs(1));
  EXPECT_EQ(effects.settled[0].output, "out");
  EXPECT_EQ(effects.settled[0].state, TaskState::kCommitted);
  EXPECT_EQ(Counts("a").committed, 1);
  EXPECT_THAT(state_.FindWorker("w")->held, IsEmpty());
}

TEST_F(LeaseEventsTest, LittleStaysOfATaskThatIsSettled) {
  AddJob("a", 3);
  See("w");
  Do(TaskCompleted{Key("a", 3), "w", Lease(Key("a", 3), "w"), "out", now_});
  EXPECT_EQ(state_.FindTask(Key("a", 3)), nullptr);
  EXPECT_THAT(state_.FindJob("a")->tasks, SizeIs(2));
  EXPECT_THAT(state_.FindJob("a")->settled_by, SizeIs(3));
  EXPECT_EQ(ReasonOf(TaskCompleted{Key("a", 3), "w", 0, "out", now_}), "LATE_RESULT");
  EXPECT_EQ(ReasonOf(TaskCompleted{Key("a", 0), "w", 1, "out", now_}), "LATE_RESULT") << "no task has that number";
}

TEST_F(LeaseEventsTest, AcceptsTheSameReportAgainWithoutEffect) {
  AddJob("a", 1);
  See("w");
  const uint64_t token = Lease(Key("a", 1), "w");
  Do(TaskCompleted{Key("a", 1), "w", token, "out", now_});
  EXPECT_THAT(Do(TaskCompleted{Key("a", 1), "w", token, "out", now_}).settled, IsEmpty());
  EXPECT_EQ(Counts("a").committed, 1);
  EXPECT_EQ(Counts("a").refused_late, 0);
}

TEST_F(LeaseEventsTest, RefusesAndCountsTheResultOfAnExpiredLease) {
  AddJob("a", 1);
  See("slow");
  See("fast");
  const uint64_t late = Lease(Key("a", 1), "slow");
  Do(LeaseExpired{Key("a", 1), "slow", late});
  const uint64_t token = Lease(Key("a", 1), "fast");
  EXPECT_EQ(ReasonOf(TaskCompleted{Key("a", 1), "slow", late, "late", now_}), "LATE_RESULT");
  EXPECT_THAT(Do(TaskCompleted{Key("a", 1), "fast", token, "out", now_}).settled, SizeIs(1));
  EXPECT_EQ(ReasonOf(TaskCompleted{Key("a", 1), "slow", late, "late", now_}), "LATE_RESULT");
  EXPECT_EQ(Counts("a").refused_late, 2);
  EXPECT_EQ(Counts("a").committed, 1);
}

TEST_F(LeaseEventsTest, QuarantinesATaskAfterThreeLostWorkers) {
  AddJob("a", 1);
  Effects last;
  for (const std::string worker : {"w1", "w2", "w3"}) {
    See(worker);
    ASSERT_THAT(Choose(worker), SizeIs(1));
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

TEST_F(LeaseEventsTest, ALostWorkerCountsAgainstWhatItHadBegun) {
  AddJob("a", 2);
  See("w", 1, false, 1);
  const uint64_t first = Lease(Key("a", 1), "w");
  Lease(Key("a", 2), "w");
  Do(LeaseRenewed{Key("a", 1), "w", first, now_ + kLease, true});
  const Effects effects = Do(WorkerLost{"w"});
  ASSERT_THAT(effects.struck, SizeIs(1));
  EXPECT_EQ(effects.struck[0].key, Key("a", 1));
  EXPECT_THAT(state_.FindTask(Key("a", 1))->lost_workers, SizeIs(1));
  EXPECT_THAT(state_.FindTask(Key("a", 2))->lost_workers, IsEmpty());
  EXPECT_EQ(Counts("a").pending, 2);
}

TEST_F(LeaseEventsTest, ALostWorkerThatToldOfNoneCountsAgainstAll) {
  AddJob("a", 2);
  See("w", 1, false, 1);
  for (const int64_t task : {1, 2}) Lease(Key("a", task), "w");
  EXPECT_THAT(Do(WorkerLost{"w"}).struck, SizeIs(2));
}

TEST_F(LeaseEventsTest, AnExpiredLeaseCountsAgainstWhatWasBegun) {
  AddJob("a", 2);
  See("w", 1, false, 1);
  const uint64_t first = Lease(Key("a", 1), "w");
  Lease(Key("a", 2), "w");
  Do(LeaseRenewed{Key("a", 1), "w", first, now_ + kLease, true});
  now_ += 2 * kLease;
  See("w", 1, false, 1);
  std::vector<int64_t> struck;
  for (const Event& event : Overdue(state_, now_, kLease)) {
    for (const auto& strike : Do(event).struck) struck.push_back(strike.key.task);
  }
  EXPECT_THAT(struck, ElementsAre(1));
  EXPECT_EQ(Counts("a").pending, 2);
}

TEST_F(LeaseEventsTest, WorkerThatLeavesGivesItsTasksBackWithoutBlame) {
  AddJob("a", 1);
  for (int i = 0; i < 10; ++i) {
    const std::string worker = absl::StrCat("w", i);
    See(worker);
    Lease(Key("a", 1), worker);
    EXPECT_THAT(Do(WorkerLeft{worker}).retried, ElementsAre(Stage::kFill));
  }
  EXPECT_THAT(state_.FindTask(Key("a", 1))->lost_workers, IsEmpty());
}

TEST_F(LeaseEventsTest, MachineErrorsAreRetriedThreeTimesInAll) {
  AddJob("a", 1);
  See("w");
  for (int i = 0; i < 2; ++i) {
    const uint64_t token = Lease(Key("a", 1), "w");
    EXPECT_THAT(Do(TaskFailed{Key("a", 1), "w", token, true, false, absl::UnavailableError("disk"), now_}).settled,
                IsEmpty());
  }
  const uint64_t token = Lease(Key("a", 1), "w");
  const Effects effects = Do(TaskFailed{Key("a", 1), "w", token, true, false, absl::UnavailableError("disk"), now_});
  ASSERT_THAT(effects.settled, SizeIs(1));
  EXPECT_EQ(effects.settled[0].state, TaskState::kFailed);
  EXPECT_EQ(effects.settled[0].error, absl::UnavailableError("disk"));
}

TEST_F(LeaseEventsTest, TheTasksOwnErrorSettlesItAtOnce) {
  AddJob("a", 1);
  See("w");
  const uint64_t token = Lease(Key("a", 1), "w");
  EXPECT_THAT(
      Do(TaskFailed{Key("a", 1), "w", token, false, false, absl::InvalidArgumentError("bad tile"), now_}).settled,
      SizeIs(1));
  EXPECT_EQ(Counts("a").failed, 1);
}

TEST_F(LeaseEventsTest, TheTasksOwnErrorIsThatOfTwoWorkersWhereThereAreTwo) {
  AddJob("a", 2);
  See("w1");
  See("w2");
  const auto fail = [&](int64_t task, const std::string& worker) {
    const uint64_t token = Lease(Key("a", task), worker);
    const absl::Status error = absl::InvalidArgumentError(worker + " says so");
    return Do(TaskFailed{Key("a", task), worker, token, false, worker == "w1", error, now_});
  };
  EXPECT_THAT(fail(1, "w1").settled, IsEmpty());
  EXPECT_THAT(Choose("w1"), ElementsAre(Key("a", 2))) << "the first is for the other";
  const Effects agreed = fail(1, "w2");
  ASSERT_THAT(agreed.settled, SizeIs(1));
  EXPECT_EQ(agreed.settled[0].error, absl::InvalidArgumentError("w2 says so"));
  EXPECT_THAT(agreed.contradicted, IsEmpty());

  EXPECT_THAT(fail(2, "w1").settled, IsEmpty());
  const Effects done = Complete(Key("a", 2), "w2", Lease(Key("a", 2), "w2"));
  ASSERT_THAT(done.contradicted, SizeIs(1));
  EXPECT_EQ(done.contradicted[0].worker, "w1");
  EXPECT_EQ(done.contradicted[0].reason, "w1 says so");
  EXPECT_EQ(done.contradicted[0].by, "w2");
  EXPECT_EQ(done.settled[0].state, TaskState::kCommitted);
}

TEST_F(LeaseEventsTest, ATaskThatFailedWaitsForAnotherWorkerButNotForEver) {
  AddJob("a", 1);
  See("w1");
  const uint64_t token = Lease(Key("a", 1), "w1");
  Do(TaskFailed{Key("a", 1), "w1", token, false, true, absl::InternalError("no"), now_});
  EXPECT_THAT(Choose("w1"), IsEmpty()) << "another may still be looking at the folders";
  now_ += state_.options().wait_for_another;
  EXPECT_THAT(Choose("w1"), ElementsAre(Key("a", 1)));
}

TEST_F(LeaseEventsTest, OneWorkerThatFailsTwiceIsEnoughIfTheOtherLeaves) {
  AddJob("a", 1);
  See("w1");
  for (const bool another : {true, true}) {
    const uint64_t token = Lease(Key("a", 1), "w1");
    Do(TaskFailed{Key("a", 1), "w1", token, false, another, absl::InternalError("no"), now_});
  }
  EXPECT_EQ(Counts("a").failed, 1);
}

MATCHER_P(WorkerIs, worker, "") { return arg.worker == worker; }

class RefusedResultTest : public StateTest {
 protected:
  // A lease whose result is refused.
  Effects Refuse(const std::string& worker, const std::string& digest, int64_t task = 1, bool another = true) {
    See(worker);
    const uint64_t token = Lease(Key("a", task), worker);
    const absl::Status error = absl::InternalError(absl::StrCat(worker, " said ", digest));
    return Do(TaskFailed{Key("a", task), worker, token, true, another, error, now_, digest});
  }
};

TEST_F(RefusedResultTest, GoesToAnotherWorker) {
  AddJob("a", 1);
  EXPECT_THAT(Refuse("w", "x").retried, SizeIs(1));
  EXPECT_THAT(Choose("w"), IsEmpty());
  See("other");
  EXPECT_THAT(Choose("other"), ElementsAre(TaskKey{"a", 1}));
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
  const Effects effects = Refuse("three", "z");
  ASSERT_THAT(effects.settled, SizeIs(1));
  EXPECT_EQ(effects.settled[0].error.message(), "one said x; three said z; two said y");
  EXPECT_EQ(ErrorReason(effects.settled[0].error), "RESULT_REFUSED");
  EXPECT_THAT(effects.cleared, ElementsAre("one", "three", "two"));
}

TEST_F(RefusedResultTest, SuspectsItsWorkerAndSetsItAsideWhenAnotherDoesTheTaskWell) {
  AddJob("a", 1);
  EXPECT_THAT(Refuse("liar", "x").suspected, ElementsAre(WorkerIs("liar")));
  See("good");
  const Effects effects = Complete(Key("a", 1), "good", Lease(Key("a", 1), "good"));
  ASSERT_THAT(effects.set_aside, ElementsAre(WorkerIs("liar")));
  EXPECT_EQ(effects.set_aside[0].reason, "liar said x");
  EXPECT_THAT(effects.cleared, IsEmpty());
}

TEST_F(RefusedResultTest, ThoseOfASecondWorkerSpeakAgainstTheJob) {
  AddJob("a", 3);
  Refuse("one", "x", 1);
  const Effects second = Refuse("two", "y", 2);
  EXPECT_THAT(second.suspected, IsEmpty());
  EXPECT_THAT(second.cleared, ElementsAre("one"));
  EXPECT_THAT(Refuse("three", "z", 3).suspected, IsEmpty());
}

TEST_F(RefusedResultTest, TwoLiarsAreBothSetAside) {
  AddJob("a", 2);
  Refuse("one", "x", 1);
  Refuse("two", "y", 2);
  See("good", 2);
  EXPECT_THAT(Complete(Key("a", 1), "good", Lease(Key("a", 1), "good")).set_aside, ElementsAre(WorkerIs("one")));
  EXPECT_THAT(Complete(Key("a", 2), "good", Lease(Key("a", 2), "good")).set_aside, ElementsAre(WorkerIs("two")));
}

TEST_F(RefusedResultTest, OneAfterAnotherIsSetAside) {
  AddJob("a", 2);
  Refuse("one", "x", 1);
  See("good");
  Complete(Key("a", 1), "good", Lease(Key("a", 1), "good"));
  EXPECT_THAT(Refuse("two", "y", 2).suspected, ElementsAre(WorkerIs("two"))) << "the first one is known to be wrong";
}

TEST_F(RefusedResultTest, TheOnlyWorkerIsNotTakenAway) {
  AddJob("a", 1);
  EXPECT_THAT(Refuse("w", "x", 1, false).suspected, IsEmpty());
}

TEST_F(RefusedResultTest, HasFailedWhenNobodyElseComes) {
  AddJob("a", 1);
  Refuse("w", "x", 1, false);
  EXPECT_THAT(Abandoned(state_, now_, MayAlways), IsEmpty());
  now_ += state_.options().wait_for_another;
  const std::vector<Event> events = Abandoned(state_, now_, MayAlways);
  ASSERT_THAT(events, SizeIs(1));
  const Effects effects = Do(events[0]);
  ASSERT_THAT(effects.settled, SizeIs(1));
  EXPECT_EQ(effects.settled[0].state, TaskState::kFailed);
  EXPECT_EQ(effects.settled[0].error.message(), "w said x; there is no other worker to try it");
  EXPECT_EQ(ErrorReason(effects.settled[0].error), "RESULT_REFUSED");
  EXPECT_EQ(Counts("a").pending, 0);
  EXPECT_EQ(Counts("a").failed, 1);
  EXPECT_THAT(Abandoned(state_, now_, MayAlways), IsEmpty());
  EXPECT_TRUE(absl::IsInvalidArgument(state_.Apply(events[0]).status()));
}

TEST_F(RefusedResultTest, WaitsForAnotherThatIsThere) {
  AddJob("a", 1);
  Refuse("w", "x");
  now_ += absl::Hours(1);
  See("busy");
  EXPECT_THAT(Abandoned(state_, now_, MayAlways), IsEmpty());
  const auto may = [](const std::string& worker, const std::string&) { return worker != "busy"; };
  EXPECT_THAT(Abandoned(state_, now_, may), SizeIs(1));
  See("busy", 1, true);
  EXPECT_THAT(Abandoned(state_, now_, MayAlways), SizeIs(1)) << "it is about to leave";
}

TEST_F(RefusedResultTest, AJobThatEndsClearsWhomItSuspected) {
  AddJob("a", 1);
  Refuse("w", "x");
  EXPECT_THAT(Do(JobCancelled{"a", now_}).cleared, ElementsAre("w"));
}

TEST_F(LeaseEventsTest, OneWorkerThatIsLostAgainAndAgainCountsOnce) {
  AddJob("a", 1);
  for (int i = 0; i < 8; ++i) {
    See("flapping");
    EXPECT_THAT(Choose("flapping"), SizeIs(1)) << i;
    Lease(Key("a", 1), "flapping");
    EXPECT_THAT(Do(WorkerLost{"flapping"}).settled, IsEmpty()) << i;
  }
  EXPECT_THAT(state_.FindTask(Key("a", 1))->lost_workers, ElementsAre("flapping"));
  See("flapping");
  Lease(Key("a", 1), "flapping");
  EXPECT_THAT(Do(WorkerLost{"flapping"}).settled, SizeIs(1)) << "but not for ever";
}

TEST_F(LeaseEventsTest, RefusesEventsThatDoNotFit) {
  AddJob("a", 1);
  EXPECT_EQ(ReasonOf(TasksAdded{"b", {}}), "JOB_NOT_FOUND");
  EXPECT_TRUE(absl::IsAlreadyExists(state_.Apply(JobCreated{"a", "", now_}).status()));
  EXPECT_TRUE(absl::IsInvalidArgument(state_.Apply(TaskLeased{Key("a", 1), "nobody", 9, now_, now_}).status()));
  See("w");
  const uint64_t token = Lease(Key("a", 1), "w");
  EXPECT_TRUE(absl::IsInvalidArgument(state_.Apply(TaskLeased{Key("a", 1), "w", token + 1, now_, now_}).status()));
  AddTasks("a", 1);
  EXPECT_TRUE(absl::IsInvalidArgument(state_.Apply(TaskLeased{Key("a", 2), "w", 0, now_, now_}).status()));
  EXPECT_TRUE(absl::IsInvalidArgument(state_.Apply(WorkerLost{"nobody"}).status()));
  EXPECT_TRUE(absl::IsInvalidArgument(state_.Apply(JobFinished{"a", JobState::kRunning, now_}).status()));
}

TEST_F(LeaseEventsTest, ATokenIsThatOfItsHolder) {
  AddJob("a", 1);
  See("w");
  See("thief");
  const uint64_t token = Lease(Key("a", 1), "w");
  EXPECT_EQ(ReasonOf(TaskCompleted{Key("a", 1), "thief", token, "forged", now_}), "LATE_RESULT");
  EXPECT_EQ(ReasonOf(LeaseRenewed{Key("a", 1), "thief", token, now_}), "LATE_RESULT");
  EXPECT_EQ(ReasonOf(LeaseExpired{Key("a", 1), "thief", token}), "LATE_RESULT");
  EXPECT_EQ(ReasonOf(TaskCompleted{Key("a", 1), "w", token + 1, "guessed", now_}), "LATE_RESULT");
  EXPECT_THAT(Complete(Key("a", 1), "w", token).settled, SizeIs(1));
  EXPECT_EQ(ReasonOf(TaskCompleted{Key("a", 1), "thief", token, "again", now_}), "LATE_RESULT");
}

TEST_F(LeaseEventsTest, PausesAfterMachineErrorsDouble) {
  AddJob("a", 1);
  See("w");
  Return(Key("a", 1), "w", Lease(Key("a", 1), "w"));
  EXPECT_EQ(state_.FindTask(Key("a", 1))->not_before, now_ + absl::Milliseconds(250));
  Return(Key("a", 1), "w", Lease(Key("a", 1), "w"));
  EXPECT_EQ(state_.FindTask(Key("a", 1))->not_before, now_ + absl::Milliseconds(500));
}

TEST_F(LeaseEventsTest, AMachineErrorIsNotTheTasksWhileAnotherWorkerIsLeft) {
  AddJob("a", 1);
  for (int i = 0; i < 8; ++i) {
    const std::string worker = absl::StrCat("full", i);
    See(worker);
    EXPECT_THAT(Return(Key("a", 1), worker, Lease(Key("a", 1), worker), true).settled, IsEmpty()) << i;
  }
  See("full8");
  EXPECT_THAT(Return(Key("a", 1), "full8", Lease(Key("a", 1), "full8"), true).settled, SizeIs(1)) << "but not for ever";
}

TEST_F(LeaseEventsTest, AMachineThatFailsAgainAndAgainRests) {
  AddJob("a", 3);
  See("w");
  Return(Key("a", 1), "w", Lease(Key("a", 1), "w"));
  EXPECT_EQ(state_.FindWorker("w")->rests_until, absl::InfinitePast()) << "once may be the task's";
  Return(Key("a", 2), "w", Lease(Key("a", 2), "w"));
  EXPECT_EQ(state_.FindWorker("w")->rests_until, now_ + absl::Milliseconds(250));
  Complete(Key("a", 3), "w", Lease(Key("a", 3), "w"));
  Return(Key("a", 1), "w", Lease(Key("a", 1), "w"));
  EXPECT_EQ(state_.FindWorker("w")->rests_until, now_ + absl::Milliseconds(250)) << "it starts anew";
}

TEST_F(LeaseEventsTest, AllThatFailsAtOnceIsOneTrouble) {
  AddJob("a", 12);
  See("cut off");
  for (int task = 1; task <= 12; ++task) Return(Key("a", task), "cut off", Lease(Key("a", task), "cut off"));
  EXPECT_EQ(state_.FindWorker("cut off")->rests_until, now_ + absl::Milliseconds(250));
}

class SecondAttemptTest : public StateTest {
 protected:
  void SetUp() override {
    AddJob("a", 1);
    See("slow");
    See("fast");
    first_ = Lease(Key("a", 1), "slow");
    second_ = Lease(Key("a", 1), "fast");
  }
  uint64_t first_ = 0, second_ = 0;
};

TEST_F(SecondAttemptTest, TheFirstResultCountsAndTheOtherIsRefused) {
  EXPECT_EQ(Counts("a").leased, 1);
  EXPECT_EQ(Counts("a").doubled, 1);
  EXPECT_THAT(Complete(Key("a", 1), "fast", second_).settled, SizeIs(1));
  EXPECT_THAT(state_.FindWorker("slow")->held, IsEmpty());
  EXPECT_EQ(ReasonOf(TaskCompleted{Key("a", 1), "slow", first_, "out", now_}), "LATE_RESULT");
  EXPECT_EQ(Counts("a").committed, 1);
  EXPECT_EQ(Counts("a").leased, 0);
}

TEST_F(SecondAttemptTest, GoesOnWhenTheFirstIsLost) {
  const Effects effects = Do(WorkerLost{"slow"});
  EXPECT_THAT(effects.retried, IsEmpty());
  EXPECT_THAT(effects.struck, SizeIs(1));
  EXPECT_EQ(state_.FindTask(Key("a", 1))->state, TaskState::kLeased);
  EXPECT_THAT(Complete(Key("a", 1), "fast", second_).settled, SizeIs(1));
}

TEST_F(SecondAttemptTest, IsPendingOnlyWhenBothAreGone) {
  Do(WorkerLeft{"slow"});
  EXPECT_EQ(Counts("a").pending, 0);
  EXPECT_THAT(Return(Key("a", 1), "fast", second_).retried, SizeIs(1));
  EXPECT_EQ(Counts("a").pending, 1);
  EXPECT_EQ(Counts("a").leased, 0);
}

TEST_F(SecondAttemptTest, ThereIsNoThirdAndNoneByTheSame) {
  See("more");
  EXPECT_TRUE(absl::IsInvalidArgument(state_.Apply(TaskLeased{Key("a", 1), "more", 7, now_, now_}).status()));
  Do(WorkerLeft{"slow"});
  EXPECT_TRUE(absl::IsInvalidArgument(state_.Apply(TaskLeased{Key("a", 1), "fast", 7, now_, now_}).status()));
}

}  // namespace
}  // namespace tilemend
