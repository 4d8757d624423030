#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "common/rpc/limits.h"
#include "common/store/digest.h"
#include "common/util/error_info.h"
#include "tests/coordinator/service/coordinator_impl_fixture.h"

namespace tilemend {
namespace {

using BlobCallsTest = CoordinatorImplTest;

TEST_F(BlobCallsTest, RefusesBadBlobs) {
  const auto job = impl_.CreateJob(NewRequest());
  const auto write = [&](const std::string& name, const std::string& digest, std::vector<std::string> chunks) {
    size_t next = 0;
    return impl_.WriteBlob([&](v1::WriteBlobRequest& message) {
      if (next >= chunks.size()) return false;
      message.set_job(name);
      message.set_digest(digest);
      message.set_data(chunks[next++]);
      return true;
    });
  };
  const std::string id = job->name().substr(5);
  EXPECT_EQ(write(id, Sha256Hex("ab"), {"a", "b"})->size(), 2);
  EXPECT_EQ(ErrorReason(write(id, Sha256Hex("ab"), {"a"}).status()), "BLOB_CORRUPT");
  EXPECT_TRUE(absl::IsInvalidArgument(write(id, "../x", {"a"}).status()));
  EXPECT_EQ(ErrorReason(write("none", Sha256Hex("a"), {"a"}).status()), "JOB_NOT_FOUND");
  const std::string big(kMaxChunkBytes + 1, 'x');
  EXPECT_TRUE(absl::IsInvalidArgument(write(id, Sha256Hex(big), {big}).status()));
  EXPECT_FALSE(write(id, Sha256Hex("a"), {}).ok());
}

TEST_F(BlobCallsTest, StopsAStreamThatStandsStill) {
  const auto job = impl_.CreateJob(NewRequest());
  bool stopped = false;
  int chunks = 0;
  const auto next = [&](v1::WriteBlobRequest& message) {
    message.set_job(job->name().substr(5));
    message.set_digest(Sha256Hex("ab"));
    message.set_data("a");
    if (++chunks == 1) return true;
    impl_.Tick();
    EXPECT_FALSE(stopped);
    cluster_.clock().Advance(absl::Seconds(61));
    impl_.Tick();
    return !stopped;
  };
  EXPECT_FALSE(impl_.WriteBlob(next, [&] { stopped = true; }).ok());
  EXPECT_TRUE(stopped);
}

TEST_F(BlobCallsTest, RefusesMoreStreamsThanThereAreThreadsFor) {
  const auto job = impl_.CreateJob(NewRequest());
  int depth = 0;
  absl::Status last;
  // Each stream opens the next one while it waits for its own first message.
  std::function<bool(v1::WriteBlobRequest&)> next = [&](v1::WriteBlobRequest&) {
    if (++depth < 1000) last.Update(impl_.WriteBlob(next).status());
    return false;
  };
  EXPECT_FALSE(impl_.WriteBlob(next).ok());
  EXPECT_EQ(depth, 250);
  EXPECT_EQ(ErrorReason(last), "TOO_MANY_CALLS");
}

}  // namespace
}  // namespace tilemend
