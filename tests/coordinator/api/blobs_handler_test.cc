#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "common/rpc/limits.h"
#include "common/store/digest.h"
#include "common/util/error_info.h"
#include "tests/coordinator/api/coordinator_fixture.h"

namespace tilemend {
namespace {

using BlobsHandlerTest = CoordinatorTest;

TEST_F(BlobsHandlerTest, RefusesBadBlobs) {
  ASSERT_TRUE(calls_.jobs.CreateJob(NewRequest()).ok());
  const v1::TaskRef attempt = AwaitTask().ref();
  EXPECT_EQ(Write(attempt, "w", Sha256Hex("ab"), {"a", "b"})->size(), 2);
  EXPECT_EQ(ErrorReason(Write(attempt, "w", Sha256Hex("ab"), {"a"}).status()), "BLOB_CORRUPT");
  EXPECT_TRUE(absl::IsInvalidArgument(Write(attempt, "w", "../x", {"a"}).status()));
  const std::string big(kMaxChunkBytes + 1, 'x');
  EXPECT_TRUE(absl::IsInvalidArgument(Write(attempt, "w", Sha256Hex(big), {big}).status()));
  EXPECT_FALSE(Write(attempt, "w", Sha256Hex("a"), {}).ok());
  v1::TaskRef of_none = attempt;
  of_none.set_job("none");
  EXPECT_EQ(ErrorReason(Write(of_none, "w", Sha256Hex("a"), {"a"}).status()), "JOB_NOT_FOUND");
}

TEST_F(BlobsHandlerTest, TakesBlobsOfThoseAloneWhoHoldTheTask) {
  ASSERT_TRUE(calls_.jobs.CreateJob(NewRequest()).ok());
  const v1::Task task = AwaitTask();
  const auto reason = [&](const v1::TaskRef& attempt, const std::string& worker) {
    return ErrorReason(Write(attempt, worker, Sha256Hex("a"), {"a"}).status());
  };
  v1::TaskRef none, guessed = task.ref(), other = task.ref();
  none.set_job(task.ref().job());
  guessed.set_attempt_token(task.ref().attempt_token() + 1);
  other.set_task(task.ref().task() + 1);
  EXPECT_EQ(reason(none, "w"), "LATE_RESULT");
  EXPECT_EQ(reason(guessed, "w"), "LATE_RESULT");
  EXPECT_EQ(reason(other, "w"), "LATE_RESULT");
  EXPECT_EQ(reason(task.ref(), "stranger"), "LATE_RESULT");
  EXPECT_EQ(reason(task.ref(), "w"), "");
  cluster_.ExpireLeases();
  EXPECT_EQ(reason(task.ref(), "w"), "LATE_RESULT");
}

TEST_F(BlobsHandlerTest, AnAttemptSendsNoMoreThanItsShare) {
  ASSERT_TRUE(calls_.jobs.CreateJob(NewRequest()).ok());
  const v1::TaskRef attempt = AwaitTask().ref();
  const std::string chunk(kMaxChunkBytes, 'x');
  const auto write = [&](size_t chunks) {
    std::string bytes;
    for (size_t i = 0; i < chunks; ++i) bytes += chunk;
    return Write(attempt, "w", Sha256Hex(bytes), std::vector(chunks, chunk)).status();
  };
  EXPECT_EQ(ErrorReason(write(5)), "BLOB_TOO_LARGE");
  EXPECT_EQ(ErrorReason(write(1)), "BLOB_TOO_LARGE") << "what came of it before counts";
}

TEST_F(BlobsHandlerTest, AnAttemptMaySendItsOutputAgain) {
  ASSERT_TRUE(calls_.jobs.CreateJob(NewRequest()).ok());
  const v1::TaskRef attempt = AwaitTask().ref();
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(Write(attempt, "w", Sha256Hex("ab"), {"a", "b"}).ok());
}

TEST_F(BlobsHandlerTest, StopsAStreamThatStandsStill) {
  ASSERT_TRUE(calls_.jobs.CreateJob(NewRequest()).ok());
  const v1::TaskRef attempt = AwaitTask().ref();
  bool stopped = false;
  int chunks = 0;
  const auto next = [&](v1::WriteBlobRequest& message) {
    *message.mutable_attempt() = attempt;
    message.set_worker("w");
    message.set_digest(Sha256Hex("ab"));
    message.set_data("a");
    if (++chunks == 1) return true;
    coordinator_.Tick();
    EXPECT_FALSE(stopped);
    cluster_.clock().Advance(absl::Seconds(61));
    coordinator_.Tick();
    return !stopped;
  };
  EXPECT_FALSE(calls_.blobs.WriteBlob(next, [&] { stopped = true; }).ok());
  EXPECT_TRUE(stopped);
}

TEST_F(BlobsHandlerTest, RefusesMoreStreamsThanThereAreThreadsFor) {
  int depth = 0;
  absl::Status last;
  // Each stream opens the next one while it waits for its own first message.
  std::function<bool(v1::WriteBlobRequest&)> next = [&](v1::WriteBlobRequest&) {
    if (++depth < 1000) last.Update(calls_.blobs.WriteBlob(next).status());
    return false;
  };
  EXPECT_FALSE(calls_.blobs.WriteBlob(next).ok());
  EXPECT_EQ(depth, 250);
  EXPECT_EQ(ErrorReason(last), "TOO_MANY_CALLS");
}

}  // namespace
}  // namespace tilemend
