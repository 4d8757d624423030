#include "worker/service/work_link.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <condition_variable>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "common/rpc/endpoint.h"
#include "common/rpc/grpc_status.h"
#include "common/rpc/limits.h"
#include "common/store/digest.h"
#include "common/util/error_info.h"
#include "tilemend/v1/work.grpc.pb.h"

namespace tilemend {
namespace {

using ::testing::HasSubstr;

// A coordinator that keeps blobs, counts their chunks and answers Sync with what the request holds.
class FakeService : public v1::Work::Service {
 public:
  grpc::Status Sync(grpc::ServerContext* context, const v1::SyncRequest* request, v1::SyncResponse* response) override {
    if (request->worker() == "refused") {
      return ToGrpcStatus(WithErrorInfo(absl::FailedPreconditionError("old"), {"PROTOCOL_VERSION", {}}));
    }
    if (request->worker() == "ends") return grpc::Status::CANCELLED;
    if (request->worker() == "waits") {
      {
        std::lock_guard<std::mutex> lock(mutex_);
        waiting_ = true;
        changed_.notify_all();
      }
      while (!context->IsCancelled()) std::this_thread::yield();
    }
    *response->mutable_keep() = request->held();
    return grpc::Status::OK;
  }

  grpc::Status ReadBlob(grpc::ServerContext* /*context*/, const v1::ReadBlobRequest* request,
                        grpc::ServerWriter<v1::BlobChunk>* writer) override {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (request->job() == "ends") return grpc::Status::CANCELLED;
    const auto blob = blobs_.find(request->job() + "/" + request->digest());
    if (blob == blobs_.end()) return ToGrpcStatus(absl::NotFoundError("no such blob"));
    v1::BlobChunk chunk;
    for (size_t at = 0; at < blob->second.size(); at += 1000) {
      chunk.set_data(blob->second.substr(at, 1000));
      writer->Write(chunk);
    }
    return grpc::Status::OK;
  }

  grpc::Status WriteBlob(grpc::ServerContext* /*context*/, grpc::ServerReader<v1::WriteBlobRequest>* reader,
                         v1::WriteBlobResponse* /*response*/) override {
    const std::lock_guard<std::mutex> lock(mutex_);
    v1::WriteBlobRequest message;
    std::string key, bytes;
    for (chunks_ = 0; reader->Read(&message); ++chunks_) {
      if (chunks_ == 0) key = message.attempt().job() + "/" + message.worker() + "/" + message.digest();
      if (message.attempt().job() == "ends") return grpc::Status::CANCELLED;
      if (chunks_ == 0 && message.attempt().job() == "over")
        return ToGrpcStatus(absl::FailedPreconditionError("job over"));
      bytes += message.data();
    }
    blobs_[key] = bytes;
    return grpc::Status::OK;
  }

  void AwaitWaiting() {
    std::unique_lock<std::mutex> lock(mutex_);
    changed_.wait(lock, [this] { return waiting_; });
  }
  void Put(const std::string& key, const std::string& bytes) {
    const std::lock_guard<std::mutex> lock(mutex_);
    blobs_[key] = bytes;
  }
  std::string Blob(const std::string& key) {
    const std::lock_guard<std::mutex> lock(mutex_);
    return blobs_[key];
  }
  int chunks() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return chunks_;
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  bool waiting_ = false;
  std::map<std::string, std::string> blobs_;
  int chunks_ = 0;
};

class GrpcWorkLinkTest : public testing::Test {
 protected:
  GrpcWorkLinkTest() : server_(RpcServer::Start("", {&service_}).value()) {
    link_ = NewGrpcWorkLink(server_->InProcessChannel());
  }
  static v1::TaskRef AttemptOf(const std::string& job) {
    v1::TaskRef attempt;
    attempt.set_job(job);
    return attempt;
  }
  static v1::SyncRequest RequestOf(const std::string& worker) {
    v1::SyncRequest request;
    request.set_worker(worker);
    request.add_held()->set_attempt_token(42);
    return request;
  }
  FakeService service_;
  std::unique_ptr<RpcServer> server_;
  std::unique_ptr<WorkLink> link_;
};

TEST_F(GrpcWorkLinkTest, BringsARequestAndItsAnswer) {
  const auto response = link_->NewSync()->Run(RequestOf("w"));
  ASSERT_TRUE(response.ok()) << response.status();
  ASSERT_EQ(response->keep_size(), 1);
  EXPECT_EQ(response->keep(0).attempt_token(), 42u);
}

TEST_F(GrpcWorkLinkTest, BringsAnErrorWithItsReason) {
  const absl::Status status = link_->NewSync()->Run(RequestOf("refused")).status();
  EXPECT_EQ(status.code(), absl::StatusCode::kFailedPrecondition);
  EXPECT_EQ(ErrorReason(status), "PROTOCOL_VERSION");
}

TEST_F(GrpcWorkLinkTest, ACallEndsWhenItIsInterrupted) {
  const auto call = link_->NewSync();
  absl::Status status;
  std::thread caller([&] { status = call->Run(RequestOf("waits")).status(); });
  service_.AwaitWaiting();
  call->Interrupt();
  caller.join();
  EXPECT_EQ(status.code(), absl::StatusCode::kCancelled);
}

TEST_F(GrpcWorkLinkTest, ACallThatIsInterruptedBeforeItBeginsEndsAtOnce) {
  const auto call = link_->NewSync();
  call->Interrupt();
  EXPECT_EQ(call->Run(RequestOf("waits")).status().code(), absl::StatusCode::kCancelled);
}

TEST_F(GrpcWorkLinkTest, ACallThatAnEndingCoordinatorCancelsIsTriedAgainLater) {
  EXPECT_TRUE(absl::IsUnavailable(link_->NewSync()->Run(RequestOf("ends")).status()));
  EXPECT_TRUE(absl::IsUnavailable(link_->ReadBlob("ends", "digest").status()));
  EXPECT_TRUE(absl::IsUnavailable(link_->WriteBlob(AttemptOf("ends"), "w", "digest", "bytes")));
}

TEST_F(GrpcWorkLinkTest, WritesAndReadsBlobsInChunks) {
  for (const size_t size : {size_t{0}, size_t{1}, kMaxChunkBytes, 2 * kMaxChunkBytes + 5}) {
    std::string bytes(size, 'a');
    for (size_t i = 0; i < size; i += 997) bytes[i] = static_cast<char>(i);
    const std::string digest = Sha256Hex(bytes);
    ASSERT_TRUE(link_->WriteBlob(AttemptOf("job"), "w", digest, bytes).ok());
    EXPECT_EQ(service_.chunks(), static_cast<int>(std::max<size_t>(1, (size + kMaxChunkBytes - 1) / kMaxChunkBytes)));
    EXPECT_TRUE(service_.Blob("job/w/" + digest) == bytes);
    const auto back = link_->ReadBlob("job/w", digest);
    ASSERT_TRUE(back.ok()) << back.status();
    EXPECT_TRUE(*back == bytes);
  }
}

TEST_F(GrpcWorkLinkTest, NoticesABlobThatCameDamaged) {
  const std::string digest = Sha256Hex("good");
  service_.Put("job/" + digest, "evil");
  const absl::Status status = link_->ReadBlob("job", digest).status();
  EXPECT_EQ(status.code(), absl::StatusCode::kUnavailable);
  EXPECT_THAT(std::string(status.message()), HasSubstr("came damaged (4 bytes)"));
}

TEST_F(GrpcWorkLinkTest, PassesOnWhyABlobCannotBeReadOrWritten) {
  EXPECT_EQ(link_->ReadBlob("job", "none").status(), absl::NotFoundError("no such blob"));
  EXPECT_EQ(link_->WriteBlob(AttemptOf("over"), "w", "digest", std::string(5 * kMaxChunkBytes, 'x')),
            absl::FailedPreconditionError("job over"));
}

TEST(GrpcWorkLinkWithoutServerTest, SaysThatItCannotBeReached) {
  const auto link = NewGrpcWorkLink(Connect("127.0.0.1:1"));
  EXPECT_EQ(link->NewSync()->Run({}).status().code(), absl::StatusCode::kUnavailable);
}

}  // namespace
}  // namespace tilemend
