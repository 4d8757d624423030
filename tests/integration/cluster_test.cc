// Jobs through a whole cluster: coordinator, gRPC in process, workers.
#include <gmock/gmock.h>
#include <grpcpp/client_context.h>
#include <gtest/gtest.h>

#include <atomic>
#include <condition_variable>
#include <mutex>

#include "absl/strings/str_cat.h"
#include "common/rpc/grpc_status.h"
#include "common/rpc/limits.h"
#include "common/util/error_info.h"
#include "tests/support/test_cluster.h"

namespace tilemend {
namespace {

using ::testing::HasSubstr;

ClusterOptions FakeClockOptions() {
  ClusterOptions options;
  options.fake_clock = true;
  return options;
}

// Tasks that go through it stop until it opens or they are cancelled.
class Gate {
 public:
  StageRunner Guard(StageRunner runner) {
    return [this, runner = std::move(runner)](Stage stage, const std::string& input, const CancelToken& cancel) {
      Pass(cancel);
      return runner(stage, input, cancel);
    };
  }
  void Open() {
    std::lock_guard<std::mutex> lock(mutex_);
    open_ = true;
    changed_.notify_all();
  }
  void AwaitArrivals(int count) {
    std::unique_lock<std::mutex> lock(mutex_);
    changed_.wait(lock, [&] { return arrived_ >= count; });
  }
  void AwaitCancelled(int count) {
    std::unique_lock<std::mutex> lock(mutex_);
    changed_.wait(lock, [&] { return cancelled_ >= count; });
  }

 private:
  void Pass(const CancelToken& cancel) {
    std::unique_lock<std::mutex> lock(mutex_);
    ++arrived_;
    changed_.notify_all();
    while (!open_ && !cancel.cancelled()) changed_.wait_for(lock, std::chrono::milliseconds(2));
    if (cancel.cancelled()) ++cancelled_;
    changed_.notify_all();
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  bool open_ = false;
  int arrived_ = 0;
  int cancelled_ = 0;
};

std::string ExpectedMessage(const std::string& scene) {
  TestCluster cluster;
  cluster.AddWorker("w", 2);
  return cluster.WaitFor(cluster.Submit(scene).name()).message();
}

TEST(ClusterTest, SameResultWithOneTwoAndFourWorkers) {
  std::string first;
  for (const int workers : {1, 2, 4}) {
    TestCluster cluster;
    for (int i = 0; i < workers; ++i) cluster.AddWorker(absl::StrCat("w", i), i % 2 + 1);
    const v1::Job job = cluster.WaitFor(cluster.Submit("toy://6x4").name());
    EXPECT_EQ(job.state(), v1::DONE) << job.DebugString();
    EXPECT_EQ(job.progress().tasks(), 3 * 24);
    EXPECT_EQ(job.progress().tasks_done(), 3 * 24);
    if (first.empty()) first = job.message();
    EXPECT_EQ(job.message(), first);
  }
}

TEST(ClusterTest, TasksOfADeadWorkerGoToOthers) {
  TestCluster cluster(FakeClockOptions());
  Gate gate;
  cluster.AddWorker("doomed", 3, gate.Guard(ToyStageRunner()));
  const v1::Job job = cluster.Submit("toy://4x4");
  gate.AwaitArrivals(3);
  cluster.KillWorker("doomed");
  cluster.ExpireLeases();
  cluster.AddWorker("heir", 2);
  const v1::Job end = cluster.WaitFor(job.name());
  EXPECT_EQ(end.state(), v1::DONE);
  EXPECT_EQ(end.progress().tasks_retried(), 3);
  EXPECT_EQ(end.message(), ExpectedMessage("toy://4x4"));
}

TEST(ClusterTest, AWorkerCutOffForTooLongIsRefusedAndWorksOn) {
  TestCluster cluster(FakeClockOptions());
  Gate gate;
  cluster.AddWorker("slow", 1, gate.Guard(ToyStageRunner()));
  const v1::Job job = cluster.Submit("toy://3x3");
  gate.AwaitArrivals(1);
  cluster.ExpireLeases();  // the worker is told to drop its task and gets it anew
  gate.AwaitCancelled(1);
  gate.Open();
  const v1::Job end = cluster.WaitFor(job.name());
  EXPECT_EQ(end.state(), v1::DONE);
  EXPECT_EQ(end.message(), ExpectedMessage("toy://3x3"));
}

TEST(ClusterTest, CancelStopsRunningTasks) {
  TestCluster cluster;
  Gate gate;
  cluster.AddWorker("w", 2, gate.Guard(ToyStageRunner()));
  const v1::Job job = cluster.Submit("toy://4x4");
  gate.AwaitArrivals(2);
  v1::CancelJobRequest request;
  request.set_name(job.name());
  ASSERT_TRUE(cluster.coordinator().calls().jobs.CancelJob(request).ok());
  EXPECT_EQ(cluster.WaitFor(job.name()).state(), v1::CANCELLED);
  gate.AwaitCancelled(2);
  gate.Open();
  // The worker is free for the next job.
  EXPECT_EQ(cluster.WaitFor(cluster.Submit("toy://2x2").name()).state(), v1::DONE);
  EXPECT_FALSE(std::filesystem::exists(cluster.folder() / "out-1"));
}

TEST(ClusterTest, WatchGoesOnFromItsCursor) {
  if (!kHasGrpc) GTEST_SKIP() << "needs gRPC";
  TestCluster cluster;
  Gate gate;
  cluster.AddWorker("w", 1, gate.Guard(ToyStageRunner()));
  const auto stub = cluster.NewJobsStub();
  v1::WatchJobRequest request;
  request.set_name(cluster.Submit("toy://3x3").name());
  gate.AwaitArrivals(1);
  v1::Job job;
  {
    grpc::ClientContext context;
    const auto reader = stub->WatchJob(&context, request);
    ASSERT_TRUE(reader->Read(&job));
    context.TryCancel();
    while (reader->Read(&job)) {
    }
    EXPECT_EQ(reader->Finish().error_code(), grpc::StatusCode::CANCELLED);
  }
  EXPECT_EQ(job.state(), v1::RUNNING);
  request.set_cursor(job.cursor());
  gate.Open();
  grpc::ClientContext context;
  const auto reader = stub->WatchJob(&context, request);
  while (reader->Read(&job)) {
    EXPECT_GT(job.cursor(), request.cursor());
    request.set_cursor(job.cursor());
  }
  EXPECT_TRUE(reader->Finish().ok());
  EXPECT_EQ(job.state(), v1::DONE);
  // Whoever asks with the last cursor is told the end again.
  grpc::ClientContext late;
  const auto again = stub->WatchJob(&late, request);
  EXPECT_TRUE(again->Read(&job));
  EXPECT_EQ(job.state(), v1::DONE);
}

TEST(ClusterTest, LargeBlobsTravelInChunks) {
  TestCluster cluster;
  cluster.AddWorker("w", 2);
  const v1::Job job = cluster.WaitFor(cluster.Submit("toy://2x1?bytes=5000000").name());
  EXPECT_EQ(job.state(), v1::DONE) << job.DebugString();
  EXPECT_GE(cluster.Metric("tilemend_coordinator_blob_received_bytes_total"), 2 * 5'000'000);
}

TEST(ClusterTest, LargeBlobsAreReadInChunks) {
  TestCluster cluster;
  const v1::Job job = cluster.Submit("toy://1x1");
  const auto link = cluster.NewLink();
  const std::string id = job.name().substr(5);
  v1::SyncRequest ask;
  ask.set_protocol(kProtocolVersion);
  ask.set_worker("w");
  ask.set_threads(1);
  ask.set_wait_ms(1000);
  v1::TaskRef attempt;
  while (attempt.job().empty()) {
    ask.set_sequence(ask.sequence() + 1);
    const auto told = link->NewSync()->Run(ask);
    ASSERT_TRUE(told.ok()) << told.status();
    if (told->start_size() > 0) attempt = told->start(0).ref();
  }
  for (const size_t size : {size_t{0}, kMaxChunkBytes, size_t{5'000'000}}) {
    const std::string bytes(size, 'b');
    ASSERT_TRUE(link->WriteBlob(attempt, "w", Sha256Hex(bytes), bytes).ok());
    const auto back = link->ReadBlob(id, Sha256Hex(bytes));
    ASSERT_TRUE(back.ok()) << back.status();
    EXPECT_TRUE(*back == bytes);
  }
  EXPECT_EQ(ErrorReason(link->WriteBlob(attempt, "w", Sha256Hex("a"), "b")), "BLOB_CORRUPT");
  EXPECT_EQ(ErrorReason(link->ReadBlob(id, Sha256Hex("none")).status()), "BLOB_NOT_FOUND");
}

TEST(ClusterTest, ATaskThatKillsThreeWorkersIsQuarantinedAndTheRestIsDone) {
  TestCluster cluster(FakeClockOptions());
  const v1::Job job = cluster.Submit("toy://3x3");
  for (const std::string name : {"w1", "w2", "w3"}) {
    Gate gate;
    cluster.AddWorker(name, 1, gate.Guard(ToyStageRunner()));
    gate.AwaitArrivals(1);  // the first task in order, each time
    cluster.KillWorker(name);
    cluster.ExpireLeases();
  }
  cluster.AddWorker("survivor", 2);
  const v1::Job end = cluster.WaitFor(job.name());
  EXPECT_EQ(end.state(), v1::PARTIAL);
  EXPECT_EQ(end.progress().tasks_quarantined(), 1);
  EXPECT_EQ(end.progress().tasks_done(), end.progress().tasks());
}

TEST(ClusterTest, AFailedTaskIsThePipelinesToJudge) {
  TestCluster cluster;
  cluster.AddWorker("w");
  const v1::Job job = cluster.WaitFor(cluster.Submit("toy://3x3?fail=1,1").name());
  EXPECT_EQ(job.state(), v1::PARTIAL);
  EXPECT_EQ(job.progress().tasks_retried(), 0);
}

TEST(ClusterTest, AMachineErrorIsTriedAgain) {
  TestCluster cluster;
  std::atomic<int> calls{0};
  cluster.AddWorker("w", 1, [&](Stage stage, const std::string& input, const CancelToken& cancel) {
    if (calls++ < 2) return absl::StatusOr<std::string>(absl::UnavailableError("the disk was away"));
    return ToyStageRunner()(stage, input, cancel);
  });
  const v1::Job job = cluster.WaitFor(cluster.Submit("toy://2x2").name());
  EXPECT_EQ(job.state(), v1::DONE);
  EXPECT_EQ(job.progress().tasks_retried(), 2);
}

TEST(ClusterTest, AThrowingStageIsAnErrorOfItsTask) {
  TestCluster cluster;
  cluster.AddWorker("w", 1, [](Stage, const std::string&, const CancelToken&) -> absl::StatusOr<std::string> {
    throw std::runtime_error("surprise");
  });
  EXPECT_EQ(cluster.WaitFor(cluster.Submit("toy://2x2").name()).state(), v1::PARTIAL);
}

TEST(ClusterTest, APipelineErrorFailsTheJobWithItsMessage) {
  TestCluster cluster;
  cluster.AddWorker("w");
  const v1::Job job = cluster.WaitFor(cluster.Submit("toy://3x3?plan_error=1").name());
  EXPECT_EQ(job.state(), v1::FAILED);
  EXPECT_EQ(job.error().code(), static_cast<int>(absl::StatusCode::kDataLoss));
  EXPECT_EQ(job.error().message(), "the toy plan went wrong");
}

TEST(ClusterTest, APipelineWithoutTasksThatIsNotDoneFails) {
  TestCluster cluster;
  cluster.AddWorker("w");
  const v1::Job job = cluster.WaitFor(cluster.Submit("toy://3x3?stall=1").name());
  EXPECT_EQ(job.state(), v1::FAILED);
  EXPECT_THAT(job.error().message(), HasSubstr("no task left"));
}

TEST(ClusterTest, AMissingSceneIsNotFound) {
  TestCluster cluster;
  v1::CreateJobRequest request;
  request.mutable_spec()->set_scene("/nowhere");
  request.mutable_spec()->set_out(cluster.folder() / "out");
  EXPECT_TRUE(absl::IsNotFound(cluster.coordinator().calls().jobs.CreateJob(request).status()));
}

TEST(ClusterTest, ADrainingWorkerFinishesWhatItHasAndLeaves) {
  TestCluster cluster;
  Gate gate;
  Worker& worker = cluster.AddWorker("w", 2, gate.Guard(ToyStageRunner()));
  const v1::Job job = cluster.Submit("toy://3x3");
  gate.AwaitArrivals(2);
  worker.Drain();
  gate.Open();
  EXPECT_TRUE(worker.Join().ok());
  EXPECT_EQ(cluster.Get(job.name()).progress().tasks_retried(), 0);
  EXPECT_GE(cluster.Get(job.name()).progress().tasks_done(), 2);
  cluster.AddWorker("next");
  EXPECT_EQ(cluster.WaitFor(job.name()).state(), v1::DONE);
}

TEST(ClusterTest, AStoppedWorkerGivesItsTasksBackAtOnce) {
  TestCluster cluster(FakeClockOptions());  // no lease runs out here
  Gate gate;
  Worker& worker = cluster.AddWorker("w", 2, gate.Guard(ToyStageRunner()));
  const v1::Job job = cluster.Submit("toy://3x3");
  gate.AwaitArrivals(2);
  worker.Stop();
  EXPECT_TRUE(worker.Join().ok());
  cluster.AddWorker("next");
  EXPECT_EQ(cluster.WaitFor(job.name()).state(), v1::DONE);
}

TEST(ClusterTest, WorkersOfASecondJobWaitForNothing) {
  TestCluster cluster;
  cluster.AddWorker("w", 2);
  const v1::Job first = cluster.Submit("toy://5x5");
  const v1::Job second = cluster.Submit("toy://4x4");
  EXPECT_EQ(cluster.WaitFor(second.name()).state(), v1::DONE);
  EXPECT_EQ(cluster.WaitFor(first.name()).state(), v1::DONE);
}

TEST(ClusterTest, ErrorInfoTravels) {
  if (!kHasGrpc) GTEST_SKIP() << "needs gRPC";
  ClusterOptions options;
  options.listen = "127.0.0.1:0";
  TestCluster cluster(options);
  const auto stub = v1::Jobs::NewStub(Connect(absl::StrCat("127.0.0.1:", cluster.rpc().port())));
  v1::GetJobRequest request;
  request.set_name("jobs/none");
  v1::Job job;
  grpc::ClientContext context;
  const absl::Status status = FromGrpcStatus(stub->GetJob(&context, request, &job));
  EXPECT_TRUE(absl::IsNotFound(status));
  EXPECT_EQ(GetErrorInfo(status), (ErrorInfo{"JOB_NOT_FOUND", {{"job", "none"}}}));
}

TEST(ClusterTest, TwoServersDoNotShareAPort) {
  if (!kHasGrpc) GTEST_SKIP() << "needs gRPC";
  ClusterOptions options;
  options.listen = "127.0.0.1:0";
  TestCluster cluster(options);
  const auto second = RpcServer::Start(absl::StrCat("127.0.0.1:", cluster.rpc().port()), {});
  EXPECT_TRUE(absl::IsUnavailable(second.status())) << second.status();
  EXPECT_TRUE(absl::IsInvalidArgument(RpcServer::Start("localhost", {}).status()));
}

}  // namespace
}  // namespace tilemend
