#include "worker/service/work_link.h"

#include <grpcpp/channel.h>
#include <grpcpp/client_context.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <string_view>

#include "absl/strings/numbers.h"
#include "absl/strings/str_cat.h"
#include "common/rpc/grpc_status.h"
#include "common/rpc/limits.h"
#include "common/store/digest.h"
#include "common/util/error_info.h"
#include "common/util/status_macros.h"
#include "tilemend/v1/work.grpc.pb.h"

namespace tilemend {
namespace {

// Beyond the time that Sync waits by itself.
constexpr std::chrono::seconds kSyncTimeout(15);

// For one blob; 1 GiB at 2 MB/s takes less.
constexpr std::chrono::minutes kBlobTimeout(10);

constexpr int32_t kMostRetryAfter = 60;  // seconds

class GrpcSyncCall : public SyncCall {
 public:
  explicit GrpcSyncCall(v1::Work::Stub& stub) : stub_(stub) {}

  absl::StatusOr<v1::SyncResponse> Run(const v1::SyncRequest& request) override {
    v1::SyncResponse response;
    context_.set_deadline(std::chrono::system_clock::now() + kSyncTimeout);
    const grpc::Status status = stub_.Sync(&context_, request, &response);
    TILEMEND_RETURN_IF_ERROR(interrupted_ ? FromGrpcStatus(status) : FromServerStatus(status));
    return response;
  }
  void Interrupt() override {
    interrupted_ = true;
    context_.TryCancel();
  }

 private:
  v1::Work::Stub& stub_;
  grpc::ClientContext context_;
  std::atomic<bool> interrupted_{false};
};

class GrpcWorkLink : public WorkLink {
 public:
  explicit GrpcWorkLink(const std::shared_ptr<grpc::Channel>& channel) : stub_(v1::Work::NewStub(channel)) {}

  std::unique_ptr<SyncCall> NewSync() override { return std::make_unique<GrpcSyncCall>(*stub_); }

  absl::StatusOr<std::string> ReadBlob(const std::string& job, const std::string& digest) override {
    grpc::ClientContext context;
    context.set_deadline(std::chrono::system_clock::now() + kBlobTimeout);
    v1::ReadBlobRequest request;
    request.set_job(job);
    request.set_digest(digest);
    const auto reader = stub_->ReadBlob(&context, request);
    std::string bytes;
    v1::BlobChunk chunk;
    while (reader->Read(&chunk)) bytes.append(chunk.data());
    TILEMEND_RETURN_IF_ERROR(FromServerStatus(reader->Finish()));
    if (Sha256Hex(bytes) == digest) return bytes;
    return absl::UnavailableError(absl::StrCat("blob ", digest, ": came damaged (", bytes.size(), " bytes)"));
  }

  absl::Status WriteBlob(const v1::TaskRef& attempt, const std::string& worker, const std::string& digest,
                         const std::string& bytes) override {
    grpc::ClientContext context;
    context.set_deadline(std::chrono::system_clock::now() + kBlobTimeout);
    v1::WriteBlobResponse response;
    const auto writer = stub_->WriteBlob(&context, &response);
    v1::WriteBlobRequest message;
    *message.mutable_attempt() = attempt;
    message.set_worker(worker);
    message.set_digest(digest);
    std::string_view left = bytes;
    do {
      const std::string_view chunk = left.substr(0, kMaxChunkBytes);
      message.set_data(chunk.data(), chunk.size());
      if (!writer->Write(message)) break;  // the coordinator has ended the call: Finish says why
      left.remove_prefix(chunk.size());
      message.Clear();
    } while (!left.empty());
    writer->WritesDone();
    return FromServerStatus(writer->Finish());
  }

 private:
  std::unique_ptr<v1::Work::Stub> stub_;
};

}  // namespace

std::optional<absl::Duration> RetryAfter(const absl::Status& status) {
  const std::optional<ErrorInfo> info = GetErrorInfo(status);
  if (!info || info->reason != "TOO_MANY_CALLS") return std::nullopt;
  const auto told = info->metadata.find("retry_after_s");
  int32_t seconds = 0;
  if (told == info->metadata.end() || !absl::SimpleAtoi(told->second, &seconds)) seconds = 1;
  return absl::Seconds(std::clamp(seconds, 0, kMostRetryAfter));
}

std::unique_ptr<WorkLink> NewGrpcWorkLink(const std::shared_ptr<grpc::Channel>& channel) {
  return std::make_unique<GrpcWorkLink>(channel);
}

}  // namespace tilemend
