#include "coordinator/state/task_choice.h"

#include "tests/coordinator/state/state_fixture.h"

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

using TaskChoiceTest = StateTest;

TEST_F(TaskChoiceTest, GivesTheTasksOfAJobInOrder) {
  AddJob("a", 3);
  See("w", 2);
  EXPECT_THAT(Choose("w"), ElementsAre(TaskKey{"a", 1}, TaskKey{"a", 2}));
}

TEST_F(TaskChoiceTest, JobsShareAlike) {
  AddJob("large", 100);
  AddJob("small", 2);
  See("w", 4);
  EXPECT_THAT(Choose("w"),
              ElementsAre(TaskKey{"large", 1}, TaskKey{"small", 1}, TaskKey{"large", 2}, TaskKey{"small", 2}));
  Lease(Key("large", 1), "w");
  Lease(Key("large", 2), "w");
  EXPECT_THAT(Choose("w"), ElementsAre(TaskKey{"small", 1}, TaskKey{"small", 2})) << "the others have leases enough";
}

TEST_F(TaskChoiceTest, TasksOfALowerPriorityWait) {
  AddJob("old", 2);
  AddJob("urgent", 2);
  AddJob("too", 1);
  Do(JobSteered{"urgent", 5});
  Do(JobSteered{"too", 5});
  See("w", 4);
  EXPECT_THAT(Choose("w"),
              ElementsAre(TaskKey{"urgent", 1}, TaskKey{"too", 1}, TaskKey{"urgent", 2}, TaskKey{"old", 1}));
  Do(JobSteered{"old", 6});
  EXPECT_THAT(Choose("w"), ElementsAre(TaskKey{"old", 1}, TaskKey{"old", 2}, TaskKey{"urgent", 1}, TaskKey{"too", 1}));
}

TEST_F(TaskChoiceTest, NothingOfAPausedJobIsGivenOutUntilItGoesOn) {
  AddJob("a", 3);
  AddJob("b", 1);
  See("w", 4);
  const uint64_t token = Lease(Key("a", 1), "w");
  Do(JobSteered{.job = "a", .paused = true});
  EXPECT_THAT(Choose("w"), ElementsAre(TaskKey{"b", 1}));
  Complete(Key("a", 1), "w", token);
  EXPECT_EQ(Counts("a").committed, 1) << "what was given out counts";
  Do(JobSteered{.job = "a", .paused = false});
  EXPECT_THAT(Choose("w"), SizeIs(3));
}

TEST_F(TaskChoiceTest, NoSecondAttemptAtATaskOfAPausedJob) {
  AddJob("a", 2);
  See("fast");
  See("slow");
  See("idle");
  Complete(Key("a", 1), "fast", Lease(Key("a", 1), "fast"));
  Lease(Key("a", 2), "slow");
  now_ += absl::Minutes(1);
  EXPECT_THAT(Choose("idle"), SizeIs(1));
  Do(JobSteered{.job = "a", .paused = true});
  EXPECT_THAT(Choose("idle"), IsEmpty());
}

TEST_F(TaskChoiceTest, GivesNothingToUnknownAndDrainingWorkers) {
  AddJob("a", 1);
  EXPECT_THAT(Choose("nobody"), IsEmpty());
  See("w", 1, true);
  EXPECT_THAT(Choose("w"), IsEmpty());
}

TEST_F(TaskChoiceTest, TellsWhatIsOverdue) {
  AddJob("a", 2);
  See("quiet");
  See("forgetful");
  Lease(Key("a", 1), "quiet");
  const uint64_t token = Lease(Key("a", 2), "forgetful");
  EXPECT_THAT(Overdue(state_, now_ + kLease, kLease), IsEmpty());
  now_ += kLease + absl::Seconds(1);
  See("forgetful");
  const std::vector<Event> events = Overdue(state_, now_, kLease);
  ASSERT_THAT(events, SizeIs(2));
  EXPECT_EQ(std::get<LeaseExpired>(events[0]).token, token);
  EXPECT_EQ(std::get<WorkerLost>(events[1]).worker, "quiet");
}

TEST_F(TaskChoiceTest, RenewalMovesTheDeadline) {
  AddJob("a", 1);
  See("w");
  const uint64_t token = Lease(Key("a", 1), "w");
  now_ += kLease;
  Do(LeaseRenewed{Key("a", 1), "w", token, now_ + kLease});
  See("w");
  EXPECT_THAT(Overdue(state_, now_ + kLease, kLease), IsEmpty());
}

TEST_F(TaskChoiceTest, GivesALastChanceAlone) {
  AddJob("a", 3);
  for (const std::string worker : {"w1", "w2"}) {
    See(worker);
    Lease(Key("a", 1), worker);
    Do(WorkerLost{worker});
  }
  See("w", 4);
  EXPECT_THAT(Choose("w"), ElementsAre(TaskKey{"a", 1}));
  Lease(Key("a", 1), "w");
  EXPECT_THAT(Choose("w"), IsEmpty());
  See("other", 4);
  EXPECT_THAT(Choose("other"), SizeIs(2));
}

TEST_F(TaskChoiceTest, GivesNoTaskOfAJobThatTheWorkerMayNotWorkOn) {
  AddJob("a", 1);
  AddJob("b", 1);
  See("w", 2);
  const auto only_b = [](const std::string&, const std::string& job) { return job == "b"; };
  EXPECT_THAT(Choose("w", only_b), ElementsAre(TaskKey{"b", 1}));
}

TEST_F(TaskChoiceTest, WhatOneMachineGivesBackGoesToAnotherFirst) {
  AddJob("a", 1);
  See("full");
  See("other");
  Return(Key("a", 1), "full", Lease(Key("a", 1), "full"));
  EXPECT_THAT(Choose("other"), IsEmpty()) << "the cause may go away";
  now_ += absl::Seconds(1);
  EXPECT_THAT(Choose("full"), IsEmpty());
  EXPECT_THAT(Choose("other"), ElementsAre(TaskKey{"a", 1}));
  const auto not_other = [](const std::string& worker, const std::string&) { return worker != "other"; };
  EXPECT_THAT(Choose("full", not_other), SizeIs(1)) << "the other may not have it";
  Do(WorkerLeft{"other"});
  EXPECT_THAT(Choose("full"), SizeIs(1)) << "there is no other any more";
}

TEST_F(TaskChoiceTest, WhatOneMachineGaveBackIsNotLeftToOthersForEver) {
  AddJob("a", 1);
  See("cut off");
  See("stuck");
  Return(Key("a", 1), "cut off", Lease(Key("a", 1), "cut off"));
  now_ += absl::Seconds(1);
  EXPECT_THAT(Choose("cut off"), IsEmpty());
  now_ += absl::Seconds(10);
  See("stuck");
  EXPECT_THAT(Choose("cut off"), SizeIs(1)) << "the other has not taken it";
}

TEST_F(TaskChoiceTest, GivesTasksBeyondThreadsWhileMoreWaitThanOthersCanHold) {
  AddJob("j", 6);
  See("a", 1, false, 2);
  See("b", 1, false, 1);
  See("leaving", 5, true, 5);
  EXPECT_THAT(Choose("a"), ElementsAre(Key("j", 1), Key("j", 2), Key("j", 3)));
  for (int64_t task = 1; task <= 3; ++task) Lease(Key("j", task), "a");
  EXPECT_THAT(Choose("b"), ElementsAre(Key("j", 4))) << "the last two are for whoever has a free thread";
}

TEST_F(TaskChoiceTest, KeepsTheLastTasksForFreeThreads) {
  AddJob("j", 3);
  See("a", 1, false, 2);
  See("b", 1, false, 2);
  EXPECT_THAT(Choose("a"), ElementsAre(Key("j", 1)));
  See("alone", 0, false, 2);
  EXPECT_THAT(Choose("alone"), IsEmpty()) << "its threads are busy with what it dropped";
}

TEST_F(TaskChoiceTest, GivesNothingToAWorkerThatRests) {
  AddJob("a", 3);
  See("w");
  for (const int task : {1, 2}) Return(Key("a", task), "w", Lease(Key("a", task), "w"));
  EXPECT_THAT(Choose("w"), IsEmpty());
  now_ += absl::Milliseconds(250);
  EXPECT_THAT(Choose("w"), SizeIs(1));
}

class StragglerTest : public StateTest {
 protected:
  // One task is left, of a stage that took others two seconds.
  void SetUp() override {
    AddJob("a", 2);
    See("slow");
    See("idle", 4);
    const uint64_t token = Lease(Key("a", 1), "idle");
    now_ += absl::Seconds(2);
    Complete(Key("a", 1), "idle", token);
    const uint64_t slow = Lease(Key("a", 2), "slow");
    Do(LeaseRenewed{Key("a", 2), "slow", slow, now_ + kLease, true});
  }
};

TEST_F(StragglerTest, GetsASecondAttemptWhenNothingElseIsToDo) {
  now_ += absl::Seconds(6);
  EXPECT_THAT(Choose("idle"), IsEmpty());
  now_ += absl::Seconds(1);
  EXPECT_THAT(Choose("idle"), ElementsAre(TaskKey{"a", 2}));
  AddJob("b", 9);
  EXPECT_THAT(Choose("idle"), SizeIs(4));
  EXPECT_EQ(Choose("idle")[0].job, "b");
}

TEST_F(StragglerTest, GetsNoneFromItsHolderAndNoThird) {
  now_ += absl::Seconds(9);
  See("slow", 4);
  EXPECT_THAT(Choose("slow"), IsEmpty());
  Lease(Key("a", 2), "idle");
  See("more");
  EXPECT_THAT(Choose("more"), IsEmpty());
}

TEST_F(StragglerTest, GetsNoneAfterAWorkerWasLostWithIt) {
  Do(WorkerLost{"slow"});
  Lease(Key("a", 2), "idle");
  now_ += absl::Seconds(9);
  See("more");
  EXPECT_THAT(Choose("more"), IsEmpty());
}

TEST_F(TaskChoiceTest, AWorkerThatTakesAllTasksAndDoesNoneIsNotWaitedFor) {
  AddJob("a", 2);
  See("greedy", 2048);
  for (const int64_t task : {1, 2}) Lease(Key("a", task), "greedy");
  See("idle", 4);
  now_ += absl::Seconds(5);
  EXPECT_THAT(Choose("idle"), IsEmpty());
  now_ += absl::Seconds(1);
  EXPECT_THAT(Choose("idle"), ElementsAre(TaskKey{"a", 1}, TaskKey{"a", 2}));
}

TEST_F(TaskChoiceTest, AWorkerThatSaysItIsAtAllTasksIsNotWaitedForLong) {
  AddJob("a", 2);
  See("greedy", 2048);
  for (const int64_t task : {1, 2}) {
    const uint64_t token = Lease(Key("a", task), "greedy");
    Do(LeaseRenewed{Key("a", task), "greedy", token, now_ + kLease, true});
  }
  See("idle", 4);
  now_ += absl::Minutes(3);
  EXPECT_THAT(Choose("idle"), IsEmpty());
  now_ += absl::Seconds(1);
  EXPECT_THAT(Choose("idle"), SizeIs(2));
}

class LongestAttemptTest : public StateTest {
 protected:
  LongestAttemptTest() : StateTest({.longest_attempt = absl::Hours(1)}) {}
};

TEST_F(LongestAttemptTest, EndsHoweverOftenTheLeaseIsRenewed) {
  AddJob("a", 1);
  See("w");
  const absl::Time start = now_;
  const uint64_t token = Lease(Key("a", 1), "w");
  for (; now_ < start + absl::Minutes(61); now_ += absl::Minutes(1)) {
    See("w");
    Do(LeaseRenewed{Key("a", 1), "w", token, now_ + absl::Minutes(2)});
  }
  EXPECT_THAT(Overdue(state_, start + absl::Minutes(59), absl::Minutes(5)), IsEmpty());
  EXPECT_THAT(Overdue(state_, now_, absl::Minutes(5)), SizeIs(1));
}

}  // namespace
}  // namespace tilemend
