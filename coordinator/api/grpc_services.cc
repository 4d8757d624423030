#include "coordinator/api/grpc_services.h"

#include <functional>
#include <utility>

#include "common/rpc/answer_limit.h"
#include "common/rpc/grpc_status.h"
#include "common/rpc/trace.h"
#include "common/util/status_macros.h"
#include "coordinator/api/guarded_calls.h"
#include "coordinator/api/scaler.h"
#include "coordinator/api/sync_reactor.h"
#include "coordinator/api/watch_reactor.h"
#include "externalscaler/externalscaler.grpc.pb.h"
#include "tilemend/v1/jobs.grpc.pb.h"
#include "tilemend/v1/work.grpc.pb.h"

namespace tilemend {
namespace {

using grpc::ServerContext;

// Moves a value into `response`, or gives the error.
template <typename T>
absl::Status Take(absl::StatusOr<T> result, T* response) {
  if (!result.ok()) return result.status();
  *response = *std::move(result);
  return absl::OkStatus();
}

Peer PeerOf(const grpc::ServerContextBase& context) {
  PeerClaims shown = ClaimsOf(context);
  Peer peer{{std::move(shown.certificate_name), std::move(shown.uris), std::move(shown.token)},
            std::move(shown.address)};
  const auto& metadata = context.client_metadata();
  const auto parent = metadata.find("traceparent");
  if (parent != metadata.end()) peer.trace = TraceOf({parent->second.data(), parent->second.size()});
  return peer;
}

// What the adapters share.
struct Served {
  CallHandlers& calls;
  const Entrance& entrance;
  GuardedCalls guarded{calls, entrance};

  template <class Call>
  grpc::Status Run(const ServerContext& context, std::string_view rpc, Call call) const {
    const Handling handling(context);
    return ToGrpcStatus(entrance.Run(PeerOf(context), rpc, std::move(call)));
  }

  // `start` begins to watch, or gives an error.
  template <class Message, class Start>
  grpc::ServerWriteReactor<Message>* Watch(const grpc::CallbackServerContext& context, const char* rpc,
                                           Start start) const {
    auto* const reactor = new WatchReactor<Message>(entrance, calls.watch, context, PeerOf(context), rpc);
    reactor->Begin(start);
    return reactor;
  }

  // A call of GuardedCalls.
  template <typename Request, typename Response>
  grpc::Status Answer(const ServerContext& context, const Request& request, Response* response,
                      absl::StatusOr<Response> (GuardedCalls::*call)(const Peer&, const Request&) const) const {
    const Handling handling(context);
    return ToGrpcStatus(Take(std::invoke(call, guarded, PeerOf(context), request), response));
  }
};

class JobsService : public v1::Jobs::WithCallbackMethod_WatchJob<v1::Jobs::Service> {
 public:
  explicit JobsService(const Served& served) : served_(served) {}

  grpc::Status CreateJob(ServerContext* context, const v1::CreateJobRequest* request, v1::Job* response) override {
    return served_.Answer(*context, *request, response, &GuardedCalls::CreateJob);
  }
  grpc::Status GetJob(ServerContext* context, const v1::GetJobRequest* request, v1::Job* response) override {
    return served_.Answer(*context, *request, response, &GuardedCalls::GetJob);
  }
  grpc::Status ListJobs(ServerContext* context, const v1::ListJobsRequest* request,
                        v1::ListJobsResponse* response) override {
    return served_.Answer(*context, *request, response, &GuardedCalls::ListJobs);
  }
  grpc::ServerWriteReactor<v1::Job>* WatchJob(grpc::CallbackServerContext* context,
                                              const v1::WatchJobRequest* request) override {
    return served_.Watch<v1::Job>(*context, "tilemend.v1.Jobs/WatchJob",
                                  [&](const auto& watch) { return served_.calls.watch.WatchJob(*request, watch); });
  }
  grpc::Status CancelJob(ServerContext* context, const v1::CancelJobRequest* request, v1::Job* response) override {
    return served_.Answer(*context, *request, response, &GuardedCalls::CancelJob);
  }
  grpc::Status RetryJob(ServerContext* context, const v1::RetryJobRequest* request, v1::Job* response) override {
    return served_.Answer(*context, *request, response, &GuardedCalls::RetryJob);
  }
  grpc::Status PauseJob(ServerContext* context, const v1::PauseJobRequest* request, v1::Job* response) override {
    return served_.Answer(*context, *request, response, &GuardedCalls::PauseJob);
  }
  grpc::Status ResumeJob(ServerContext* context, const v1::ResumeJobRequest* request, v1::Job* response) override {
    return served_.Answer(*context, *request, response, &GuardedCalls::ResumeJob);
  }
  grpc::Status PrioritizeJob(ServerContext* context, const v1::PrioritizeJobRequest* request,
                             v1::Job* response) override {
    return served_.Answer(*context, *request, response, &GuardedCalls::PrioritizeJob);
  }

 private:
  const Served& served_;
};

class WorkersService : public v1::Workers::Service {
 public:
  explicit WorkersService(const Served& served) : served_(served) {}

  grpc::Status ListWorkers(ServerContext* context, const v1::ListWorkersRequest* request,
                           v1::ListWorkersResponse* response) override {
    return served_.Answer(*context, *request, response, &GuardedCalls::ListWorkers);
  }

 private:
  const Served& served_;
};

class WorkService : public v1::Work::WithCallbackMethod_Sync<v1::Work::Service> {
 public:
  explicit WorkService(const Served& served) : served_(served) {}

  grpc::ServerUnaryReactor* Sync(grpc::CallbackServerContext* context, const v1::SyncRequest* request,
                                 v1::SyncResponse* response) override {
    auto* const reactor = new SyncReactor(served_.entrance, served_.calls.work, *context, *response);
    // gRPC's own object, which is const to its users only.
    reactor->Begin(PeerOf(*context), *const_cast<v1::SyncRequest*>(request));  // NOLINT(*-const-cast)
    return reactor;
  }
  grpc::Status ReadBlob(ServerContext* context, const v1::ReadBlobRequest* request,
                        grpc::ServerWriter<v1::BlobChunk>* writer) override {
    return served_.Run(*context, "tilemend.v1.Work/ReadBlob", [&](const Caller&) {
      const auto send = [writer](std::string_view bytes) {
        v1::BlobChunk chunk;
        chunk.set_data(bytes.data(), bytes.size());
        return writer->Write(chunk);
      };
      return served_.calls.blobs.ReadBlob(*request, send, [context] { context->TryCancel(); });
    });
  }
  grpc::Status WriteBlob(ServerContext* context, grpc::ServerReader<v1::WriteBlobRequest>* reader,
                         v1::WriteBlobResponse* response) override {
    return served_.Run(*context, "tilemend.v1.Work/WriteBlob", [&](const Caller&) {
      return Take(
          served_.calls.blobs.WriteBlob([reader](v1::WriteBlobRequest& message) { return reader->Read(&message); },
                                        [context] { context->TryCancel(); }),
          response);
    });
  }

 private:
  const Served& served_;
};

using Scaler = externalscaler::ExternalScaler;

class ScalerService : public Scaler::WithCallbackMethod_StreamIsActive<Scaler::Service> {
 public:
  explicit ScalerService(const Served& served) : served_(served) {}

  grpc::Status IsActive(ServerContext* context, const externalscaler::ScaledObjectRef*,
                        externalscaler::IsActiveResponse* response) override {
    return served_.Run(*context, "externalscaler.ExternalScaler/IsActive", [&](const Caller&) {
      response->set_result(served_.calls.cluster.DemandNow().jobs > 0);
      return absl::OkStatus();
    });
  }
  grpc::ServerWriteReactor<externalscaler::IsActiveResponse>* StreamIsActive(
      grpc::CallbackServerContext* context, const externalscaler::ScaledObjectRef*) override {
    return served_.Watch<externalscaler::IsActiveResponse>(
        *context, "externalscaler.ExternalScaler/StreamIsActive",
        [&](const auto& watch) { return served_.calls.watch.WatchDemand(watch); });
  }
  grpc::Status GetMetricSpec(ServerContext* context, const externalscaler::ScaledObjectRef* request,
                             externalscaler::GetMetricSpecResponse* response) override {
    return served_.Run(*context, "externalscaler.ExternalScaler/GetMetricSpec",
                       [&](const Caller&) { return Take(ScalerSpec(*request), response); });
  }
  grpc::Status GetMetrics(ServerContext* context, const externalscaler::GetMetricsRequest* request,
                          externalscaler::GetMetricsResponse* response) override {
    return served_.Run(*context, "externalscaler.ExternalScaler/GetMetrics", [&](const Caller&) {
      return Take(ScalerMetrics(*request, served_.calls.cluster.DemandNow()), response);
    });
  }

 private:
  const Served& served_;
};

class Server : public CoordinatorServer {
 public:
  Server(Coordinator& coordinator, std::shared_ptr<Gate> gate)
      : coordinator_(coordinator),
        entrance_(std::move(gate)),
        served_{coordinator.calls(), entrance_},
        jobs_(served_),
        workers_(served_),
        work_(served_),
        scaler_(served_) {}
  ~Server() override { coordinator_.StopWaiting(); }

  absl::Status Start(const std::string& listen, const TlsFiles& tls) {
    TILEMEND_ASSIGN_OR_RETURN(rpc_, RpcServer::Start(listen, {&jobs_, &workers_, &work_, &scaler_}, tls));
    return absl::OkStatus();
  }
  RpcServer& rpc() override { return *rpc_; }

 private:
  Coordinator& coordinator_;
  const Entrance entrance_;
  const Served served_;
  JobsService jobs_;
  WorkersService workers_;
  WorkService work_;
  ScalerService scaler_;
  std::unique_ptr<RpcServer> rpc_;  // ends first
};

}  // namespace

absl::StatusOr<std::unique_ptr<CoordinatorServer>> CoordinatorServer::Start(const std::string& listen,
                                                                            Coordinator& coordinator,
                                                                            ServerOptions options) {
  if (options.gate == nullptr) {
    options.gate = std::make_shared<Gate>(Access::Open(), *MetricsRegistry::Null(), *Log::Null());
  }
  auto server = std::make_unique<Server>(coordinator, std::move(options.gate));
  TILEMEND_RETURN_IF_ERROR(server->Start(listen, options.tls));
  return server;
}

}  // namespace tilemend
