#include "worker/service/worker.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <future>
#include <memory>
#include <string>
#include <thread>

#include "common/rpc/limits.h"
#include "tests/worker/service/worker_fixture.h"

namespace tilemend {
namespace {

using ::testing::HasSubstr;
using ::testing::SizeIs;

TEST_F(WorkerTest, ReportsAResultUntilItIsAcknowledged) {
  const auto worker = NewWorker(Echo);
  coordinator_.Answer(Start({TaskOf(7, "input")}));
  for (int call = 0; call < 3; ++call) {
    const v1::SyncRequest request = coordinator_.Answer(absl::UnavailableError("lost"), HasFinished);
    ASSERT_THAT(request.finished(), SizeIs(1));
    EXPECT_EQ(request.finished(0).ref().attempt_token(), 7u);
    EXPECT_EQ(request.finished(0).output().content(), "out of input");
    EXPECT_EQ(request.finished(0).output().size(), 12);
    EXPECT_EQ(request.held_size(), 0);
  }
  coordinator_.Answer(AcknowledgementOf(TaskOf(7, "")), HasFinished);
  coordinator_.Answer(v1::SyncResponse(), HoldsNothing);
  worker->Abandon();
}

TEST_F(WorkerTest, TakesATaskOnceThatItIsToldTwice) {
  std::atomic<int> runs = 0;
  const auto worker = NewWorker([&runs](Stage, const std::string&, const CancelToken&) -> absl::StatusOr<std::string> {
    ++runs;
    return "";
  });
  coordinator_.Answer(Start({TaskOf(1, "a"), TaskOf(1, "a")}));
  coordinator_.Answer(Start({TaskOf(1, "a")}), HasFinished);
  const v1::SyncRequest request = coordinator_.Answer(AcknowledgementOf(TaskOf(1, "")), HasFinished);
  EXPECT_THAT(request.finished(), SizeIs(1));
  EXPECT_EQ(request.held_size(), 0);
  worker->Abandon();
  EXPECT_TRUE(worker->Join().ok());
  EXPECT_EQ(runs, 1);
}

TEST_F(WorkerTest, SendsNoMoreInOneCallThanFits) {
  const size_t fit = kMaxInlineBytesPerSync / kInlineBlobBytes;
  const auto worker = NewWorker([](Stage, const std::string&, const CancelToken&) -> absl::StatusOr<std::string> {
    return std::string(kInlineBlobBytes, 'z');
  });
  std::vector<v1::Task> tasks;
  for (uint64_t token = 1; token <= fit + 2; ++token) tasks.push_back(TaskOf(token, ""));
  coordinator_.Answer(Start(tasks));
  v1::SyncRequest request;
  do {
    request = coordinator_.Answer(absl::UnavailableError("lost"), HasFinished);
  } while (request.finished_size() < static_cast<int>(fit));
  EXPECT_EQ(request.finished_size(), static_cast<int>(fit));
  EXPECT_EQ(request.held_size(), 2) << "finished or not, the coordinator still counts on them";
  size_t acknowledged = 0;
  while (acknowledged < tasks.size()) {
    request = coordinator_.Answer(absl::AbortedError("a newer call"), HasFinished);
    v1::SyncResponse response = Acknowledge(coordinator_.Answer(absl::AbortedError("a newer call"), HasFinished));
    const v1::SyncRequest told = coordinator_.Answer(response, HasFinished);
    acknowledged += static_cast<size_t>(response.acknowledged_size());
    EXPECT_LE(told.finished_size(), static_cast<int>(fit));
  }
  coordinator_.Answer(v1::SyncResponse(), HoldsNothing);
  worker->Abandon();
}

TEST_F(WorkerTest, DropsWhatIsNotToBeKept) {
  const auto worker = WorkerOnTheFirstOfTwo();
  const auto holds_both = [](const v1::SyncRequest& request) { return request.held_size() == 2; };
  coordinator_.Answer(v1::SyncResponse(), holds_both);  // one runs, one waits for the thread
  const v1::SyncRequest request = coordinator_.Answer(v1::SyncResponse(), HoldsNothing);
  EXPECT_EQ(request.finished_size(), 0);
  worker->Abandon();
  EXPECT_TRUE(worker->Join().ok());
  EXPECT_THAT(metrics_.Text(), HasSubstr("tilemend_worker_tasks_cancelled_total{stage=\"fill\"} 1\n"));
  EXPECT_THAT(metrics_.Text(), HasSubstr("tilemend_worker_tasks_started_total{stage=\"fill\"} 1\n"));
}

TEST_F(WorkerTest, AsksForLessWhileItIsBusyWithWhatItDropped) {
  std::promise<void> running;
  std::atomic<bool> go_on = false;
  const auto worker = NewWorker([&](Stage, const std::string&, const CancelToken&) -> absl::StatusOr<std::string> {
    running.set_value();
    while (!go_on) std::this_thread::yield();
    return "late";
  });
  coordinator_.Answer(Start({TaskOf(1, "")}));
  running.get_future().wait();
  coordinator_.Answer(v1::SyncResponse(), [](const v1::SyncRequest& request) { return request.held_size() == 1; });
  EXPECT_EQ(coordinator_.Answer(v1::SyncResponse(), HoldsNothing).threads(), 0);
  go_on = true;
  const auto all_free = [](const v1::SyncRequest& request) { return request.threads() == 1; };
  EXPECT_EQ(coordinator_.Answer(v1::SyncResponse(), all_free).finished_size(), 0) << "a late result is not reported";
  worker->Abandon();
}

TEST_F(WorkerTest, FinishesAndReportsBeforeItLeaves) {
  std::atomic<bool> go_on = false;
  const auto worker = NewWorker([&](Stage, const std::string&, const CancelToken&) -> absl::StatusOr<std::string> {
    while (!go_on) std::this_thread::yield();
    return "done";
  });
  coordinator_.Answer(Start({TaskOf(1, "")}));
  worker->Drain();
  const auto draining = [](const v1::SyncRequest& request) { return request.draining(); };
  const v1::SyncRequest request = coordinator_.Answer(absl::AbortedError("a newer call"), draining);
  EXPECT_EQ(request.held_size(), 1);
  go_on = true;
  v1::SyncResponse response;
  *response.add_acknowledged() = Ref(1);
  const v1::SyncRequest last =
      coordinator_.Answer(response, [](const v1::SyncRequest& r) { return r.draining() && HasFinished(r); });
  EXPECT_EQ(last.finished(0).output().content(), "done");
  response.set_leave(true);
  coordinator_.Answer(response, HoldsNothing);
  EXPECT_TRUE(worker->Join().ok());
}

TEST_F(WorkerTest, StopGivesItsTasksBackAndGoes) {
  const auto worker = NewWorker(UntilCancelled);
  coordinator_.Answer(Start({TaskOf(1, ""), TaskOf(2, "")}));
  const auto holds_both = [](const v1::SyncRequest& request) { return request.held_size() == 2; };
  v1::SyncResponse keep;
  *keep.add_keep() = Ref(1);
  *keep.add_keep() = Ref(2);
  coordinator_.Answer(keep, holds_both);
  worker->Stop();
  v1::SyncResponse leave;
  leave.set_leave(true);
  const v1::SyncRequest last = coordinator_.Answer(leave, [](const v1::SyncRequest& r) { return r.draining(); });
  EXPECT_EQ(last.held_size(), 0);
  EXPECT_EQ(last.finished_size(), 0);
  EXPECT_TRUE(worker->Join().ok());
}

TEST_F(WorkerTest, AbandonEndsWithoutAWord) {
  const auto worker = NewWorker(UntilCancelled);
  const v1::SyncRequest first = coordinator_.Answer(Start({TaskOf(1, "")}));
  EXPECT_FALSE(first.draining());
  worker->Abandon();
  EXPECT_TRUE(worker->Join().ok());  // nobody has answered a last call
}

}  // namespace
}  // namespace tilemend
