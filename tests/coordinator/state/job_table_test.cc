#include "coordinator/state/job_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/util/error_info.h"

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::Pair;

class JobTableTest : public testing::Test {
 protected:
  JobTableTest() {
    for (const int64_t number : {1, 2}) {
      Job job;
      job.id = number == 1 ? "a" : "b";
      job.request_id = number == 1 ? "asked" : "";
      job.number = number;
      table_.Insert(std::move(job));
    }
  }

  JobTable table_;
};

TEST_F(JobTableTest, FindsAJobByIdAndRequest) {
  EXPECT_EQ(table_.Find("b")->number, 2);
  EXPECT_EQ(table_.Find("c"), nullptr);
  EXPECT_EQ(table_.FindRequest("asked")->id, "a");
  EXPECT_EQ(table_.FindRequest(""), nullptr) << "a job without a request is found by none";
  EXPECT_THAT(table_.numbers(), ElementsAre(Pair(1, "a"), Pair(2, "b")));
  EXPECT_EQ(table_.last_number(), 2);
}

TEST_F(JobTableTest, FindsATaskUntilItIsGone) {
  table_.Find("a")->tasks[3].id = 3;
  EXPECT_EQ(table_.FindTask({"a", 3})->id, 3);
  EXPECT_EQ(table_.FindTask({"a", 4}), nullptr);
  EXPECT_EQ(table_.FindTask({"c", 3}), nullptr);
}

TEST_F(JobTableTest, AJobThatIsOverRunsNoMore) {
  table_.End(*table_.Find("a"), JobState::kDone);
  EXPECT_THAT(table_.running(), ElementsAre(Pair(2, "b")));
  EXPECT_EQ(ErrorReason(table_.FindRunning("a").status()), "JOB_OVER");
  EXPECT_EQ(ErrorReason(table_.FindRunning("c").status()), "JOB_NOT_FOUND");
  EXPECT_TRUE(table_.FindRunning("b").ok());
}

TEST_F(JobTableTest, ForgetsAJobThatIsOverAndItsRequest) {
  EXPECT_TRUE(absl::IsInvalidArgument(table_.Forget("a")));
  table_.End(*table_.Find("a"), JobState::kDone);
  EXPECT_TRUE(table_.Forget("a").ok());
  EXPECT_EQ(table_.FindRequest("asked"), nullptr);
  EXPECT_THAT(table_.numbers(), ElementsAre(Pair(2, "b")));
  EXPECT_EQ(ErrorReason(table_.Forget("a")), "JOB_NOT_FOUND");
  EXPECT_EQ(table_.last_number(), 2) << "numbers are not given again";
}

TEST_F(JobTableTest, InsertsAJobThatIsOver) {
  table_.End(*table_.Find("a"), JobState::kDone);
  table_.End(*table_.Find("b"), JobState::kFailed);
  Job job;
  job.id = "c";
  job.number = 3;
  job.state = JobState::kDone;
  table_.Insert(std::move(job));
  EXPECT_THAT(table_.running(), IsEmpty());
  EXPECT_EQ(table_.Find("c")->state, JobState::kDone);
}

}  // namespace
}  // namespace tilemend
