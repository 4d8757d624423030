// Every call over gRPC, in process: that it reaches the implementation, and that its errors come back whole.
#include "coordinator/api/grpc_services.h"

#include <gmock/gmock.h>
#include <grpcpp/grpcpp.h>
#include <gtest/gtest.h>

#include <thread>

#include "common/rpc/grpc_status.h"
#include "common/rpc/limits.h"
#include "common/store/digest.h"
#include "common/util/error_info.h"
#include "tests/support/test_cluster.h"
#include "tilemend/v1/work.grpc.pb.h"

namespace tilemend {
namespace {

class GrpcServicesTest : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!kHasGrpc) GTEST_SKIP() << "needs gRPC";
    jobs_ = cluster_.NewJobsStub();
    work_ = v1::Work::NewStub(cluster_.rpc().InProcessChannel());
  }
  // Of the first task that comes, for worker w.
  v1::TaskRef HoldTask() {
    v1::SyncRequest sync;
    sync.set_protocol(kProtocolVersion);
    sync.set_worker("w");
    sync.set_threads(1);
    sync.set_wait_ms(1000);
    v1::SyncResponse told;
    while (told.start_size() == 0) {
      grpc::ClientContext context;
      sync.set_sequence(sync.sequence() + 1);
      EXPECT_TRUE(work_->Sync(&context, sync, &told).ok());
    }
    return told.start(0).ref();
  }
  v1::Job Create(const std::string& scene) {
    v1::CreateJobRequest request;
    request.mutable_spec()->set_scene(scene);
    request.mutable_spec()->set_out(cluster_.folder() / "out");
    v1::Job job;
    grpc::ClientContext context;
    const grpc::Status status = jobs_->CreateJob(&context, request, &job);
    EXPECT_TRUE(status.ok()) << status.error_message();
    return job;
  }

  // A cancelled job holds its folder until its thread has ended; who asks before is told to come again.
  v1::Job Retry(const std::string& name) {
    v1::RetryJobRequest request;
    request.set_name(name);
    v1::Job job;
    absl::Status status;
    do {
      std::this_thread::yield();
      grpc::ClientContext context;
      status = FromGrpcStatus(jobs_->RetryJob(&context, request, &job));
    } while (absl::IsAborted(status));
    EXPECT_TRUE(status.ok()) << status;
    return job;
  }

  TestCluster cluster_;
  std::unique_ptr<v1::Jobs::Stub> jobs_;
  std::unique_ptr<v1::Work::Stub> work_;
  grpc::ClientContext context_;
};

TEST_F(GrpcServicesTest, AJobIsMadeSeenListedWatchedAndCancelled) {
  const v1::Job made = Create("toy://1x1");
  EXPECT_EQ(made.spec().scene(), "toy://1x1");
  grpc::ClientContext get, list, cancel;
  v1::GetJobRequest get_request;
  get_request.set_name(made.name());
  v1::Job seen;
  ASSERT_TRUE(jobs_->GetJob(&get, get_request, &seen).ok());
  EXPECT_EQ(seen.name(), made.name());
  v1::ListJobsResponse listed;
  ASSERT_TRUE(jobs_->ListJobs(&list, {}, &listed).ok());
  ASSERT_EQ(listed.jobs_size(), 1);
  v1::CancelJobRequest cancel_request;
  cancel_request.set_name(made.name());
  v1::Job cancelled;
  ASSERT_TRUE(jobs_->CancelJob(&cancel, cancel_request, &cancelled).ok());
  v1::WatchJobRequest watch_request;
  watch_request.set_name(made.name());
  const auto reader = jobs_->WatchJob(&context_, watch_request);
  v1::Job last, next;
  while (reader->Read(&next)) last = next;
  EXPECT_TRUE(reader->Finish().ok());
  EXPECT_EQ(last.state(), v1::CANCELLED);
  EXPECT_NE(Retry(made.name()).name(), made.name());
}

TEST_F(GrpcServicesTest, ErrorsComeBackWithTheirReason) {
  v1::GetJobRequest request;
  request.set_name("jobs/none");
  v1::Job job;
  const absl::Status status = FromGrpcStatus(jobs_->GetJob(&context_, request, &job));
  EXPECT_TRUE(absl::IsNotFound(status)) << status;
  EXPECT_EQ(ErrorReason(status), "JOB_NOT_FOUND");
  v1::SyncRequest sync;
  sync.set_protocol(kProtocolVersion + 1);
  v1::SyncResponse response;
  grpc::ClientContext other;
  EXPECT_EQ(ErrorReason(FromGrpcStatus(work_->Sync(&other, sync, &response))), "PROTOCOL_VERSION");
}

TEST_F(GrpcServicesTest, ABlobIsWrittenInChunksAndReadAgain) {
  const std::string id = Create("toy://1x1").name().substr(5);
  const std::string first(100'000, 'a'), second(50'000, 'b');
  const std::string digest = Sha256Hex(first + second);
  v1::WriteBlobResponse written;
  const auto writer = work_->WriteBlob(&context_, &written);
  v1::WriteBlobRequest chunk;
  *chunk.mutable_attempt() = HoldTask();
  chunk.set_worker("w");
  chunk.set_digest(digest);
  chunk.set_data(first);
  EXPECT_TRUE(writer->Write(chunk));
  chunk = {};
  chunk.set_data(second);
  EXPECT_TRUE(writer->Write(chunk));
  writer->WritesDone();
  const absl::Status status = FromGrpcStatus(writer->Finish());
  ASSERT_TRUE(status.ok()) << status;
  EXPECT_EQ(written.size(), 150'000);
  grpc::ClientContext read;
  v1::ReadBlobRequest request;
  request.set_job(id);
  request.set_digest(digest);
  const auto reader = work_->ReadBlob(&read, request);
  std::string bytes;
  v1::BlobChunk part;
  while (reader->Read(&part)) bytes += part.data();
  EXPECT_TRUE(reader->Finish().ok());
  EXPECT_EQ(bytes, first + second);
}

}  // namespace
}  // namespace tilemend
