#include "coordinator/service/grpc_services.h"

#include <utility>

#include "common/rpc/grpc_status.h"
#include "common/rpc/trace.h"
#include "common/util/status_macros.h"
#include "tilemend/v1/jobs.grpc.pb.h"
#include "tilemend/v1/work.grpc.pb.h"

namespace tilemend {
namespace {

using grpc::ServerContext;

JobOrigin OriginOf(const ServerContext& context) {
  const auto& metadata = context.client_metadata();
  const auto parent = metadata.find("traceparent");
  if (parent == metadata.end()) return {};
  return {"", TraceOf({parent->second.data(), parent->second.size()})};
}

class JobsService : public v1::Jobs::Service {
 public:
  explicit JobsService(CoordinatorImpl& impl) : impl_(impl) {}

  grpc::Status CreateJob(ServerContext* context, const v1::CreateJobRequest* request, v1::Job* response) override {
    return Reply(impl_.CreateJob(*request, OriginOf(*context)), response);
  }
  grpc::Status GetJob(ServerContext*, const v1::GetJobRequest* request, v1::Job* response) override {
    return Reply(impl_.GetJob(*request), response);
  }
  grpc::Status ListJobs(ServerContext*, const v1::ListJobsRequest* request, v1::ListJobsResponse* response) override {
    return Reply(impl_.ListJobs(*request), response);
  }
  grpc::Status WatchJob(ServerContext* context, const v1::WatchJobRequest* request,
                        grpc::ServerWriter<v1::Job>* writer) override {
    return ToGrpcStatus(impl_.WatchJob(
        *request, [writer](const v1::Job& job) { return writer->Write(job); },
        [context] { return !context->IsCancelled(); }));
  }
  grpc::Status CancelJob(ServerContext*, const v1::CancelJobRequest* request, v1::Job* response) override {
    return Reply(impl_.CancelJob(*request), response);
  }
  grpc::Status RetryJob(ServerContext* context, const v1::RetryJobRequest* request, v1::Job* response) override {
    return Reply(impl_.RetryJob(*request, OriginOf(*context)), response);
  }

 private:
  CoordinatorImpl& impl_;
};

class WorkersService : public v1::Workers::Service {
 public:
  explicit WorkersService(CoordinatorImpl& impl) : impl_(impl) {}

  grpc::Status ListWorkers(ServerContext*, const v1::ListWorkersRequest* request,
                           v1::ListWorkersResponse* response) override {
    return Reply(impl_.ListWorkers(*request), response);
  }

 private:
  CoordinatorImpl& impl_;
};

class WorkService : public v1::Work::Service {
 public:
  explicit WorkService(CoordinatorImpl& impl) : impl_(impl) {}

  grpc::Status Sync(ServerContext* context, const v1::SyncRequest* request, v1::SyncResponse* response) override {
    return Reply(impl_.Sync(*request, [context] { return !context->IsCancelled(); }), response);
  }
  grpc::Status ReadBlob(ServerContext*, const v1::ReadBlobRequest* request,
                        grpc::ServerWriter<v1::BlobChunk>* writer) override {
    return ToGrpcStatus(impl_.ReadBlob(*request, [writer](std::string_view bytes) {
      v1::BlobChunk chunk;
      chunk.set_data(bytes.data(), bytes.size());
      return writer->Write(chunk);
    }));
  }
  grpc::Status WriteBlob(ServerContext*, grpc::ServerReader<v1::WriteBlobRequest>* reader,
                         v1::WriteBlobResponse* response) override {
    return Reply(impl_.WriteBlob([reader](v1::WriteBlobRequest& message) { return reader->Read(&message); }), response);
  }

 private:
  CoordinatorImpl& impl_;
};

class Server : public CoordinatorServer {
 public:
  explicit Server(CoordinatorImpl& impl) : impl_(impl), jobs_(impl), workers_(impl), work_(impl) {}
  ~Server() override { impl_.StopWaiting(); }

  absl::Status Start(const std::string& listen) {
    TILEMEND_ASSIGN_OR_RETURN(rpc_, RpcServer::Start(listen, {&jobs_, &workers_, &work_}));
    return absl::OkStatus();
  }
  RpcServer& rpc() override { return *rpc_; }

 private:
  CoordinatorImpl& impl_;
  JobsService jobs_;
  WorkersService workers_;
  WorkService work_;
  std::unique_ptr<RpcServer> rpc_;  // ends first
};

}  // namespace

absl::StatusOr<std::unique_ptr<CoordinatorServer>> CoordinatorServer::Start(const std::string& listen,
                                                                            CoordinatorImpl& impl) {
  auto server = std::make_unique<Server>(impl);
  TILEMEND_RETURN_IF_ERROR(server->Start(listen));
  return server;
}

}  // namespace tilemend
