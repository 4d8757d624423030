#include "coordinator/state/verdicts.h"

#include "tests/coordinator/state/state_fixture.h"

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

// What becomes of the results of a worker that is caught.
class RevokedResultsTest : public StateTest {
 protected:
  void Give(const std::string& job, int64_t task, const std::string& worker) {
    Complete(Key(job, task), worker, Lease(Key(job, task), worker));
  }
  Effects Disprove(const std::string& worker, bool another = true) {
    return Do(WorkerDisproved{"a", worker, "it lied", another});
  }
  // A wrong result of a task, which another worker then does.
  Effects CatchInTheAct(const TaskKey& key, const std::string& liar) {
    Do(TaskFailed{key, liar, Lease(key, liar), true, true, absl::InternalError("wrong"), now_, "digest"});
    See("good");
    return Complete(key, "good", Lease(key, "good"));
  }
};

TEST_F(RevokedResultsTest, AllThatItGaveInJobsThatRunIsRevoked) {
  for (const std::string worker : {"liar", "good"}) See(worker, 4);
  for (const std::string job : {"a", "b", "over"}) AddJob(job, 4);
  for (const std::string job : {"a", "b", "over"}) Give(job, 1, "liar");
  Give("a", 2, "good");
  Give("a", 3, "liar");
  Do(JobFinished{"over", JobState::kDone, now_});
  const Effects effects = CatchInTheAct(Key("a", 4), "liar");
  ASSERT_THAT(effects.set_aside, SizeIs(1));
  ASSERT_THAT(effects.revoked, SizeIs(2));
  EXPECT_EQ(effects.revoked[0].job, "a");
  EXPECT_EQ(effects.revoked[0].worker, "liar");
  EXPECT_THAT(effects.revoked[0].tasks, ElementsAre(1, 3));
  EXPECT_EQ(effects.revoked[1].job, "b");
}

TEST_F(RevokedResultsTest, OfAWorkerThatGaveNothingElseNothingIs) {
  See("liar");
  AddJob("a", 1);
  EXPECT_THAT(CatchInTheAct(Key("a", 1), "liar").revoked, IsEmpty());
}

TEST_F(RevokedResultsTest, WhatAnEarlierProcessKnewBelongsToItsWorker) {
  See("liar");
  AddJob("a", 0);
  Do(TasksAdded{"a", {{{0, 0}, Stage::kFill, "in", KnownResult{TaskState::kCommitted, "out", {}, "liar"}}}});
  EXPECT_THAT(Disprove("liar").revoked.at(0).tasks, ElementsAre(1));
}

TEST_F(RevokedResultsTest, AJobThatIsDoneAgainHasNoTasksUntilTheyAreAdded) {
  See("w", 2);
  AddJob("a", 3);
  const uint64_t token = Lease(Key("a", 1), "w");
  Give("a", 2, "w");
  const uint64_t version = state_.FindJob("a")->version;
  Do(JobRedone{"a"});
  const Job& job = *state_.FindJob("a");
  EXPECT_THAT(job.tasks, IsEmpty());
  EXPECT_THAT(state_.FindWorker("w")->held, IsEmpty());
  EXPECT_EQ(job.counts, TaskCounts());
  EXPECT_GT(job.version, version);
  AddTasks("a", 1);
  EXPECT_EQ(ReasonOf(TaskCompleted{Key("a", 1), "w", token, "out", now_}), "LATE_RESULT");
  Give("a", 1, "w");
  EXPECT_EQ(Counts("a").committed, 1);
}

TEST_F(RevokedResultsTest, AWorkerWhoseResultIsFalseIsSetAsideWhenTheJobEndsWell) {
  AddJob("a", 1);
  const Effects effects = Disprove("liar");
  ASSERT_THAT(effects.suspected, SizeIs(1));
  EXPECT_EQ(effects.suspected[0].worker, "liar");
  EXPECT_THAT(Do(JobRedone{"a"}).cleared, IsEmpty());
  const Effects end = Do(JobFinished{"a", JobState::kDone, now_});
  ASSERT_THAT(end.set_aside, SizeIs(1));
  EXPECT_EQ(end.set_aside[0].reason, "it lied");
}

TEST_F(RevokedResultsTest, NobodyIsClearedWhileAnotherJobHasDisprovedIt) {
  for (const std::string job : {"a", "b"}) AddJob(job, 1);
  for (const std::string job : {"a", "b"}) Do(WorkerDisproved{job, "liar", "it lied", true});
  EXPECT_THAT(Do(JobCancelled{"a", now_}).cleared, IsEmpty());
  EXPECT_THAT(Do(JobFinished{"b", JobState::kFailed, now_}).cleared, ElementsAre("liar"));
}

TEST_F(RevokedResultsTest, WhereTheJobFailsItIsNobodysFault) {
  AddJob("a", 1);
  Disprove("liar");
  const Effects end = Do(JobFinished{"a", JobState::kFailed, now_});
  EXPECT_THAT(end.set_aside, IsEmpty());
  EXPECT_THAT(end.cleared, ElementsAre("liar"));
}

TEST_F(RevokedResultsTest, TheOnlyWorkerIsGivenOneMoreChance) {
  AddJob("a", 1);
  EXPECT_THAT(Disprove("only", false).suspected, IsEmpty());
  EXPECT_FALSE(state_.Apply(WorkerDisproved{"a", "only", "again", false}).ok());
  EXPECT_THAT(Do(JobFinished{"a", JobState::kDone, now_}).set_aside, IsEmpty());
}

TEST_F(RevokedResultsTest, ThatManyWorkersLieIsNotBelieved) {
  AddJob("a", 1);
  Disprove("one");
  Disprove("two");
  EXPECT_FALSE(state_.Apply(WorkerDisproved{"a", "three", "it lied", true}).ok()) << "max_refusals is 3";
  EXPECT_FALSE(state_.Apply(WorkerDisproved{"a", "", "somebody lied", true}).ok());
}

}  // namespace
}  // namespace tilemend
