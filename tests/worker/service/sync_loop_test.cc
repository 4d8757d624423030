#include "worker/service/sync_loop.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "common/rpc/limits.h"
#include "common/util/error_info.h"
#include "tests/worker/service/worker_fixture.h"

namespace tilemend {
namespace {

using ::testing::HasSubstr;

TEST_F(WorkerTest, SaysWhoItIsAndWhatItTakes) {
  const auto worker = NewWorker(Echo, 3);
  const v1::SyncRequest first = coordinator_.Answer(v1::SyncResponse());
  EXPECT_EQ(first.protocol(), kProtocolVersion);
  EXPECT_EQ(first.worker(), "w");
  EXPECT_EQ(first.threads(), 3);
  EXPECT_EQ(first.prefetch(), 1);
  EXPECT_FALSE(first.draining());
  EXPECT_EQ(first.wait_ms(), absl::ToInt64Milliseconds(kMaxPoll));
  const v1::SyncRequest second = coordinator_.Answer(v1::SyncResponse());
  EXPECT_GT(second.sequence(), first.sequence());
  EXPECT_THAT(metrics_.Text(), HasSubstr("tilemend_worker_connected 1\n"));
  worker->Abandon();
}

TEST_F(WorkerTest, EndsWithTheReasonIfItIsRefused) {
  const absl::Status protocol =
      WithErrorInfo(absl::FailedPreconditionError("protocol 1, but this is 2"), {"PROTOCOL_VERSION", {}});
  const absl::Status build =
      WithErrorInfo(absl::FailedPreconditionError("build a, but this is b"), {"OTHER_BUILD", {}});
  for (const absl::Status& refusal : {protocol, build, absl::InvalidArgumentError("2049 threads")}) {
    const auto worker = NewWorker(Echo);
    coordinator_.Answer(refusal);
    EXPECT_EQ(worker->Join(), refusal);
    EXPECT_THAT(metrics_.Text(), HasSubstr("tilemend_worker_connected 0\n"));
  }
}

TEST_F(WorkerTest, EndsWithTheErrorWhereItsCoordinatorIsOutOfReachForTooLong) {
  patience_ = absl::Milliseconds(3);
  const auto worker = NewWorker(Echo);
  for (int call = 0; call < 4; ++call) coordinator_.Answer(absl::ResourceExhaustedError("no thread"));
  EXPECT_EQ(worker->Join(), absl::ResourceExhaustedError("no thread"));
  EXPECT_EQ(ends_, 1);
}

TEST_F(WorkerTest, CountsCallsInVainFromTheLastAnswer) {
  patience_ = absl::Milliseconds(3);
  const auto worker = NewWorker(Echo);
  for (int call = 0; call < 8; ++call) {
    coordinator_.Answer(call % 3 == 2 ? absl::StatusOr<v1::SyncResponse>(v1::SyncResponse())
                                      : absl::ResourceExhaustedError("no thread"));
  }
  EXPECT_EQ(ends_, 0);
  worker->Abandon();
  EXPECT_TRUE(worker->Join().ok());
  EXPECT_EQ(ends_, 1);
}

absl::Status TooManyCalls(const std::string& retry_after_s) {
  return WithErrorInfo(absl::ResourceExhaustedError("no room"), {"TOO_MANY_CALLS", {{"retry_after_s", retry_after_s}}});
}

TEST_F(WorkerTest, ACoordinatorWithoutRoomIsNotOutOfReach) {
  patience_ = absl::Milliseconds(3);
  const auto worker = NewWorker(Echo);
  for (int call = 0; call < 8; ++call) coordinator_.Answer(TooManyCalls("0"));
  EXPECT_EQ(worker->WhyNotReady(), "");
  worker->Abandon();
}

TEST_F(WorkerTest, WaitsForAsLongAsItIsToldBeforeItCallsAgain) {
  const auto worker = NewWorker(Echo);
  coordinator_.Answer(TooManyCalls("1"));
  const absl::Time begin = absl::Now();
  coordinator_.Answer(v1::SyncResponse());
  EXPECT_GE(absl::Now() - begin, absl::Milliseconds(900));
  worker->Abandon();
}

TEST_F(WorkerTest, ReportsSeveralResultsInOneCallWhileMoreTasksWait) {
  const auto worker = NewWorker(Echo, 1, 3);
  coordinator_.Answer(Start({TaskOf(1, ""), TaskOf(2, ""), TaskOf(3, ""), TaskOf(4, "")}));
  v1::SyncResponse all;
  for (uint64_t token = 1; token <= 4; ++token) *all.add_keep() = *all.add_acknowledged() = Ref(token);
  EXPECT_GE(coordinator_.Answer(all, HasFinished).finished_size(), 2);
  while (!HoldsNothing(coordinator_.Answer(all))) {
  }
  worker->Abandon();
}

TEST_F(WorkerTest, CallsSeldomWhileItHasTasksEnough) {
  const auto worker = NewWorker(UntilCancelled);
  coordinator_.Answer(Start({TaskOf(1, ""), TaskOf(2, "")}));
  v1::SyncResponse keep;
  *keep.add_keep() = Ref(1);
  *keep.add_keep() = Ref(2);
  const absl::Time begin = absl::Now();
  for (int call = 0; call < 3; ++call) coordinator_.Answer(keep);
  EXPECT_GE(absl::Now() - begin, absl::Milliseconds(290));
  worker->Abandon();
}

TEST_F(WorkerTest, CallsAgainWhenTheCoordinatorCannotBeReached) {
  const auto worker = NewWorker(Echo);
  uint64_t sequence = 0;
  for (const absl::Status& lost : {absl::UnavailableError("gone"), absl::DeadlineExceededError("slow"),
                                   absl::AbortedError("a newer call"), absl::InternalError("?")}) {
    const v1::SyncRequest request = coordinator_.Answer(lost);
    EXPECT_GT(request.sequence(), sequence);
    sequence = request.sequence();
  }
  coordinator_.Answer(v1::SyncResponse());
  coordinator_.Answer(v1::SyncResponse());
  EXPECT_THAT(metrics_.Text(), HasSubstr("tilemend_worker_connected 1\n"));
  worker->Abandon();
}

TEST_F(WorkerTest, APauseEndsWithTheWorker) {
  backoff_ = absl::Hours(1);
  for (const bool drain : {false, true}) {
    const auto worker = NewWorker(Echo);
    coordinator_.Answer(absl::UnavailableError("gone"));
    if (drain) {
      worker->Drain();  // nothing is held and nothing to tell: no need to be released
    } else {
      worker->Stop();
    }
    EXPECT_TRUE(worker->Join().ok());
  }
}

}  // namespace
}  // namespace tilemend
