// The worker's calls, without workers and without gRPC.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <future>
#include <iterator>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "absl/cleanup/cleanup.h"
#include "common/rpc/limits.h"
#include "common/store/digest.h"
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
  const std::string most(kMostHeldBytes, 'x');
  ASSERT_TRUE(other.Hold(Sha256Hex(most), [&most] { return most; }).ok());  // so that inputs are files
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

// Results of 1 MiB whose check waits until the test lets it go on.
class SlowCheckTest : public CoordinatorTest {
 protected:
  using Answer = std::future<absl::StatusOr<v1::SyncResponse>>;

  SlowCheckTest() : SlowCheckTest(std::make_shared<std::promise<void>>()) {}

  v1::SyncRequest Report(const v1::Task& task) {
    v1::SyncRequest request = NewSync("w", 80);
    Finish(task, request);
    v1::BlobRef& output = *request.mutable_finished(0)->mutable_output();
    output.set_content("5 " + std::string((1 << 20) - 2, ' '));
    output.set_size(std::ssize(output.content()));
    return request;
  }
  Answer Begin(const v1::SyncRequest& request) {
    const auto told = std::make_shared<std::promise<absl::StatusOr<v1::SyncResponse>>>();
    const auto answer = [told](absl::StatusOr<v1::SyncResponse> response) { told->set_value(std::move(response)); };
    calls_.work.Sync(std::make_shared<WorkerSync>(WorkerSync{request, "", [] { return true; }, answer}));
    return told->get_future();
  }
  std::vector<v1::Task> AwaitTasks(size_t count) {
    v1::CreateJobRequest job = NewRequest();
    job.mutable_spec()->set_scene("toy://10x8");
    EXPECT_TRUE(calls_.jobs.CreateJob(job).ok());
    std::vector<v1::Task> tasks;
    for (int i = 0; i < 20 && tasks.size() < count; ++i) {
      const v1::SyncResponse response = Sync(NewSync("w", 80));
      tasks.assign(response.start().begin(), response.start().end());
    }
    EXPECT_GE(tasks.size(), count);
    tasks.resize(count);
    return tasks;
  }
  void ExpectRefused(const v1::SyncRequest& request) {
    Answer answer = Begin(request);
    ASSERT_EQ(answer.wait_for(std::chrono::seconds(5)), std::future_status::ready) << "it waits to be checked";
    const absl::Status refused = answer.get().status();
    EXPECT_TRUE(absl::IsResourceExhausted(refused)) << refused;
    EXPECT_EQ(ErrorReason(refused), "TOO_MANY_CALLS");
  }

  const std::shared_ptr<std::promise<void>> release_;

 private:
  explicit SlowCheckTest(const std::shared_ptr<std::promise<void>>& release)
      : CoordinatorTest([&] {
          ClusterOptions options = Options();
          const std::shared_future<void> released = release->get_future();
          options.check_result = [released](Stage, const std::string&, const std::string&) {
            released.wait();
            return absl::OkStatus();
          };
          return options;
        }()),
        release_(release) {}
};

TEST_F(SlowCheckTest, ResultsBeyondTheBudgetStayWithTheirWorkerUntilOthersAreChecked) {
  const std::vector<v1::Task> tasks = AwaitTasks(64);
  std::vector<Answer> answers;
  for (size_t i = 0; i < 63; ++i) answers.push_back(Begin(Report(tasks[i])));
  ExpectRefused(Report(tasks[63]));
  release_->set_value();
  for (Answer& answer : answers) EXPECT_NE(answer.get().status().code(), absl::StatusCode::kResourceExhausted);
  const auto taken = Begin(Report(tasks[63])).get();
  ASSERT_TRUE(taken.ok()) << taken.status();
  EXPECT_EQ(taken->acknowledged_size(), 1);
}

TEST_F(SlowCheckTest, ErrorsAndLooksCountAsResultsDo) {
  const std::vector<v1::Task> tasks = AwaitTasks(64);
  const absl::Cleanup release = [this] { release_->set_value(); };
  std::vector<Answer> answers;
  for (size_t i = 0; i < 63; ++i) answers.push_back(Begin(Report(tasks[i])));
  const std::string text(1 << 20, 'e');
  v1::SyncRequest failed = NewSync("w", 80);
  Finish(tasks[63], failed);
  failed.mutable_finished(0)->mutable_error()->set_message(text);
  ExpectRefused(failed);
  v1::SyncRequest blind = NewSync("w", 80);
  blind.add_seen()->set_write_error(text);
  ExpectRefused(blind);
}

TEST_F(WorkHandlerTest, ACallThatWaitsForNewsHasLetGoOfItsResults) {
  for (const bool alive : {true, false}) {
    v1::SyncRequest request = NewSync();
    v1::Task unknown;
    unknown.mutable_ref()->set_job("j");
    Finish(unknown, request);
    request.mutable_finished(0)->mutable_output()->set_content(std::string(1 << 20, 'x'));
    Finish(unknown, request);
    request.mutable_finished(1)->mutable_error()->set_message(std::string(1 << 20, 'e'));
    std::promise<void> answered;
    const auto answer = [&](const absl::StatusOr<v1::SyncResponse>&) { answered.set_value(); };
    const auto sync = std::make_shared<WorkerSync>(WorkerSync{request, "", [alive] { return alive; }, answer});
    calls_.work.Sync(sync);
    answered.get_future().wait();
    ASSERT_EQ(sync->request.finished_size(), 2);
    EXPECT_EQ(sync->request.finished(0).ref().job(), "j");
    EXPECT_LT(sync->request.ByteSizeLong(), 1000U);
  }
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
