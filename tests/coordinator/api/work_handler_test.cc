// The worker's calls, without workers and without gRPC.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "common/rpc/limits.h"
#include "common/util/error_info.h"
#include "coordinator/store/blob_folder.h"
#include "tests/coordinator/api/coordinator_fixture.h"
#include "tests/support/list_log.h"
#include "tests/support/waiting_sync.h"

namespace tilemend {
namespace {

using ::testing::StartsWith;
using WorkHandlerTest = CoordinatorTest;

TEST_F(WorkHandlerTest, AnInputThatWasLostIsNotTakenForAnEmptyOne) {
  BlobFolder other(cluster_.folder() / "other");
  ASSERT_TRUE(other.Hold(std::string(kMostHeldBytes, 'x')).ok());  // so that inputs are files
  ASSERT_TRUE(calls_.jobs.CreateJob(NewRequest()).ok());
  const v1::Task task = AwaitTask();
  ASSERT_EQ(task.input().size(), static_cast<int64_t>(task.input().content().size()));
  for (const auto& entry : std::filesystem::recursive_directory_iterator(cluster_.folder() / "work/jobs")) {
    if (entry.is_regular_file()) std::filesystem::remove(entry.path());
  }
  const v1::Task again = AwaitTask();
  EXPECT_EQ(again.ref().task(), task.ref().task());
  EXPECT_EQ(again.input().size(), -1);
}

TEST_F(WorkHandlerTest, RefusesAnotherProtocol) {
  v1::SyncRequest request = NewSync();
  request.set_protocol(kProtocolVersion + 1);
  EXPECT_EQ(ErrorReason(SyncAndWait(calls_.work, request).status()), "PROTOCOL_VERSION");
}

TEST(WorkLogTest, NamesAWorkerOfAnotherProtocolWhateverItSays) {
  ListLog log;
  ClusterOptions options;
  options.log = &log;
  TestCluster cluster(options);
  v1::SyncRequest request;
  request.set_protocol(kProtocolVersion - 1);
  request.set_worker("old-" + std::string(5000, 'w'));
  request.set_threads(-1);
  const absl::Status refused = SyncAndWait(cluster.coordinator().calls().work, request).status();
  EXPECT_EQ(ErrorReason(refused), "PROTOCOL_VERSION");
  EXPECT_LT(refused.message().size(), 500U);
  ASSERT_EQ(log.lines().size(), 1U);
  EXPECT_THAT(log.lines().front(), StartsWith("warning worker refused worker=old-www"));
  EXPECT_LT(log.lines().front().size(), 1000U);
}

TEST(WorkLogTest, NamesAWorkerOfAnotherBuild) {
  ListLog log;
  ClusterOptions options;
  options.log = &log;
  options.build = "aaaa";
  TestCluster cluster(options);
  v1::SyncRequest request;
  request.set_protocol(kProtocolVersion);
  request.set_worker("w");
  request.set_release("0.0.9");
  request.set_threads(1);
  request.set_build("bbbb");
  const auto alive = [] { return true; };
  const absl::Status refused = SyncAndWait(cluster.coordinator().calls().work, request, alive).status();
  EXPECT_EQ(ErrorReason(refused), "OTHER_BUILD");
  EXPECT_THAT(std::string(refused.message()),
              StartsWith("worker w is of build bbbb (0.0.9), this coordinator of aaaa"));
  ASSERT_EQ(log.lines().size(), 1U);
  EXPECT_THAT(log.lines().front(), StartsWith("warning worker refused worker=w worker_release=0.0.9"));
  EXPECT_TRUE(cluster.coordinator().calls().cluster.ListWorkers({})->workers().empty());
  request.set_build("aaaa");
  EXPECT_TRUE(SyncAndWait(cluster.coordinator().calls().work, request, alive).ok());
}

TEST_F(WorkHandlerTest, RefusesNamesWithoutEnd) {
  v1::SyncRequest talker = NewSync(std::string(257, 'w'));
  EXPECT_TRUE(absl::IsInvalidArgument(SyncAndWait(calls_.work, talker).status()));
  talker = NewSync();
  talker.set_secret(std::string(257, 's'));
  EXPECT_TRUE(absl::IsInvalidArgument(SyncAndWait(calls_.work, talker).status()));
  talker = NewSync();
  talker.set_release(std::string(257, 'r'));
  EXPECT_TRUE(absl::IsInvalidArgument(SyncAndWait(calls_.work, talker).status()));
}

}  // namespace
}  // namespace tilemend
