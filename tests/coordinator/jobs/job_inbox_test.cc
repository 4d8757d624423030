#include "coordinator/jobs/job_inbox.h"

#include <gtest/gtest.h>

#include <chrono>
#include <optional>
#include <thread>
#include <vector>

namespace tilemend {
namespace {

// Only what an inbox asks.
struct IdlePipeline : JobPipeline {
  bool may_be_cancelled = true;
  absl::StatusOr<std::vector<NewTask>> Start() override { return std::vector<NewTask>(); }
  absl::StatusOr<std::vector<NewTask>> OnTaskDone(TaskResult /*result*/) override { return std::vector<NewTask>(); }
  bool Done() const override { return true; }
  Progress GetProgress() const override { return {}; }
  absl::StatusOr<JobOutcome> Finish() override { return JobOutcome(); }
  bool Cancel() override { return may_be_cancelled; }
};

constexpr std::chrono::milliseconds kNoTime(0);

TEST(JobInboxTest, CountsContentsUntilTheyAreTaken) {
  JobInbox inbox;
  inbox.Deliver({}, "12345");
  inbox.Deliver({}, std::nullopt);
  EXPECT_EQ(inbox.queued_bytes(), 5u);
  const auto deliveries = inbox.Next();
  ASSERT_TRUE(deliveries.ok());
  ASSERT_EQ(deliveries->size(), 2u);
  EXPECT_EQ(inbox.queued_bytes(), 5u);
  EXPECT_TRUE(inbox.Begin(deliveries->front()).ok());
  EXPECT_EQ(inbox.queued_bytes(), 0u);
}

TEST(JobInboxTest, NextWaitsForWhatComes) {
  JobInbox inbox;
  std::thread other([&] { inbox.Deliver({}, "late"); });
  EXPECT_EQ(inbox.Next()->front().content, "late");
  other.join();
}

TEST(JobInboxTest, CancellingComesBeforeAFailureAndTakesNothingMore) {
  JobInbox inbox;
  inbox.Fail(absl::DataLossError("x"));
  EXPECT_EQ(inbox.Wait(kNoTime), absl::DataLossError("x"));
  EXPECT_TRUE(inbox.Cancel());
  EXPECT_TRUE(absl::IsCancelled(inbox.Wait(kNoTime)));
  inbox.Deliver({}, "nobody wants it");
  EXPECT_EQ(inbox.queued_bytes(), 0u);
  EXPECT_TRUE(absl::IsCancelled(inbox.Next().status()));
  IdlePipeline pipeline;
  EXPECT_TRUE(absl::IsCancelled(inbox.SetPipeline(pipeline)));
  EXPECT_EQ(inbox.Close(true), JobInbox::End::kCancelled);
}

TEST(JobInboxTest, APipelineThatIsDoneAndAJobThatIsCloseAreNotCancelled) {
  JobInbox inbox;
  IdlePipeline pipeline;
  pipeline.may_be_cancelled = false;
  ASSERT_TRUE(inbox.SetPipeline(pipeline).ok());
  EXPECT_FALSE(inbox.Cancel());
  EXPECT_EQ(inbox.Close(true), JobInbox::End::kDone);
  EXPECT_FALSE(inbox.Cancel());
}

TEST(JobInboxTest, BeginsAgainUnlessItFailed) {
  JobInbox inbox;
  EXPECT_FALSE(inbox.BeginsAgain());
  inbox.Fail(BegunAgain());
  EXPECT_FALSE(inbox.Wait(kNoTime).ok());
  EXPECT_EQ(inbox.Close(true), JobInbox::End::kBeginsAgain);
  EXPECT_TRUE(inbox.BeginsAgain());
  inbox.Deliver({}, "of a task that is forgotten");
  inbox.Restart();
  EXPECT_EQ(inbox.queued_bytes(), 0u);
  EXPECT_TRUE(inbox.Wait(kNoTime).ok());
  inbox.Fail(absl::DataLossError("x"));
  inbox.Fail(BegunAgain());
  EXPECT_FALSE(inbox.BeginsAgain());
  EXPECT_EQ(inbox.Wait(kNoTime), absl::DataLossError("x"));
}

}  // namespace
}  // namespace tilemend
