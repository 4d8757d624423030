#include "coordinator/state/coordinator_state.h"

#include "tests/coordinator/state/state_fixture.h"

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

using CoordinatorStateTest = StateTest;

TEST_F(CoordinatorStateTest, ACancelledJobTakesNothingMore) {
  AddJob("a", 2);
  See("w");
  const uint64_t token = Lease(Key("a", 1), "w");
  Do(JobCancelled{"a", now_});
  EXPECT_EQ(state_.FindJob("a")->state, JobState::kCancelled);
  EXPECT_THAT(state_.FindWorker("w")->held, IsEmpty());
  EXPECT_THAT(Choose("w"), IsEmpty());
  EXPECT_EQ(ReasonOf(TaskCompleted{Key("a", 1), "w", token, "out", now_}), "LATE_RESULT");
  EXPECT_EQ(ReasonOf(JobCancelled{"a", now_}), "JOB_OVER");
  EXPECT_EQ(ReasonOf(TasksAdded{"a", {}}), "JOB_OVER");
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

TEST_F(CoordinatorStateTest, KeepsAWarningOnceAndNotTooMany) {
  AddJob("a", 1);
  for (int i = 0; i < 100; ++i) Do(JobWarned{"a", absl::StrCat("worker ", i / 2)});
  EXPECT_THAT(state_.FindJob("a")->warnings, SizeIs(kMostWarnings));
  EXPECT_EQ(state_.FindJob("a")->warnings[1], "worker 1");
  EXPECT_EQ(ReasonOf(JobWarned{"b", "?"}), "JOB_NOT_FOUND");
}

TEST_F(CoordinatorStateTest, ForgetsAJobThatIsOver) {
  Do(JobCreated{"a", "request", now_});
  EXPECT_TRUE(absl::IsInvalidArgument(state_.Apply(JobForgotten{"a"}).status()));
  Do(JobCancelled{"a", now_});
  Do(JobForgotten{"a"});
  EXPECT_EQ(state_.FindJob("a"), nullptr);
  EXPECT_EQ(state_.FindRequest("request"), nullptr);
  EXPECT_THAT(state_.job_numbers(), IsEmpty());
  Do(JobCreated{"b", "request", now_});
  EXPECT_EQ(state_.FindJob("b")->number, 2) << "a number is not given out again";
}

}  // namespace
}  // namespace tilemend
