#include "coordinator/api/grpc_services.h"

#include <functional>
#include <utility>

#include "absl/strings/str_cat.h"
#include "absl/time/clock.h"
#include "common/rpc/answer_limit.h"
#include "common/rpc/grpc_status.h"
#include "common/rpc/trace.h"
#include "common/util/error_info.h"
#include "common/util/status_macros.h"
#include "coordinator/api/scaler.h"
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

JobOrigin OriginOf(const ServerContext& context, const Caller& caller) {
  const auto& metadata = context.client_metadata();
  const auto parent = metadata.find("traceparent");
  if (parent == metadata.end()) return {caller.name, ""};
  return {caller.name, TraceOf({parent->second.data(), parent->second.size()})};
}

// What every handler does around its call.
class Entrance {
 public:
  explicit Entrance(std::shared_ptr<Gate> gate) : gate_(std::move(gate)) {}

  // `call` takes the caller and gives an absl::Status.
  template <class Call>
  grpc::Status Run(const ServerContext& context, std::string_view rpc, Call call) const {
    const Handling handling(context);
    const absl::Time start = absl::Now();
    const auto caller = Admit(context, rpc);
    const absl::Status status = caller.ok() ? call(*caller) : caller.status();
    gate_->Ended(rpc, status, absl::Now() - start);
    return ToGrpcStatus(status);
  }

  // Why a call that goes on for long is to end: its caller has gone, or may not make it any more.
  absl::Status GoOn(const ServerContext& context, std::string_view rpc) const {
    if (context.IsCancelled()) return absl::CancelledError("the watcher went away");
    return Admit(context, rpc).status();
  }

  // Of a call that changes a job: `call` gives the job's message. `name` is the job's as far as it is known before, and
  // `how` what else the call asks for.
  template <class Call>
  grpc::Status Change(const ServerContext& context, std::string_view rpc, const std::string& name, LogFields how,
                      v1::Job* response, Call call) const {
    return Run(context, rpc, [&](const Caller& caller) {
      absl::Status status = Take(absl::StatusOr<v1::Job>(call(caller)), response);
      how.emplace(how.begin(), "what", status.ok() ? response->name() : name);
      gate_->Audit(rpc, caller, context.peer(), how, status);
      return status;
    });
  }

 private:
  absl::StatusOr<Caller> Admit(const ServerContext& context, std::string_view rpc) const {
    const PeerClaims claims = ClaimsOf(context);
    return gate_->Admit(rpc, {claims.certificate_name, claims.uris, claims.token}, claims.address);
  }

  const std::shared_ptr<Gate> gate_;
};

class JobsService : public v1::Jobs::Service {
 public:
  JobsService(CallHandlers& calls, const Entrance& entrance) : calls_(calls), entrance_(entrance) {}

  grpc::Status CreateJob(ServerContext* context, const v1::CreateJobRequest* request, v1::Job* response) override {
    const v1::JobSpec& spec = request->spec();
    LogFields how = {{"scene", spec.scene()}, {"out", spec.out()}, {"overwrite", spec.overwrite() ? "true" : ""}};
    return entrance_.Change(
        *context, "tilemend.v1.Jobs/CreateJob", "", std::move(how), response,
        [&](const Caller& caller) { return calls_.jobs.CreateJob(*request, OriginOf(*context, caller)); });
  }
  grpc::Status GetJob(ServerContext* context, const v1::GetJobRequest* request, v1::Job* response) override {
    return entrance_.Run(*context, "tilemend.v1.Jobs/GetJob",
                         [&](const Caller&) { return Take(calls_.jobs.GetJob(*request), response); });
  }
  grpc::Status ListJobs(ServerContext* context, const v1::ListJobsRequest* request,
                        v1::ListJobsResponse* response) override {
    return entrance_.Run(*context, "tilemend.v1.Jobs/ListJobs",
                         [&](const Caller&) { return Take(calls_.jobs.ListJobs(*request), response); });
  }
  grpc::Status WatchJob(ServerContext* context, const v1::WatchJobRequest* request,
                        grpc::ServerWriter<v1::Job>* writer) override {
    return entrance_.Run(*context, "tilemend.v1.Jobs/WatchJob", [&](const Caller&) {
      return calls_.watch.WatchJob(
          *request, [writer](const v1::Job& job) { return writer->Write(job); },
          [&] { return entrance_.GoOn(*context, "tilemend.v1.Jobs/WatchJob"); });
    });
  }
  grpc::Status CancelJob(ServerContext* context, const v1::CancelJobRequest* request, v1::Job* response) override {
    return entrance_.Change(*context, "tilemend.v1.Jobs/CancelJob", request->name(), {}, response,
                            [&](const Caller& caller) -> absl::StatusOr<v1::Job> {
                              TILEMEND_RETURN_IF_ERROR(CheckOwner(caller, request->name()));
                              return calls_.jobs.CancelJob(*request);
                            });
  }
  grpc::Status RetryJob(ServerContext* context, const v1::RetryJobRequest* request, v1::Job* response) override {
    return entrance_.Change(*context, "tilemend.v1.Jobs/RetryJob", request->name(),
                            {{"overwrite", request->overwrite() ? "true" : ""}}, response,
                            [&](const Caller& caller) -> absl::StatusOr<v1::Job> {
                              TILEMEND_RETURN_IF_ERROR(CheckOwner(caller, request->name()));
                              return calls_.jobs.RetryJob(*request, OriginOf(*context, caller));
                            });
  }
  grpc::Status PauseJob(ServerContext* context, const v1::PauseJobRequest* request, v1::Job* response) override {
    return Steer(*context, "tilemend.v1.Jobs/PauseJob", {}, *request, response, &JobsHandler::PauseJob);
  }
  grpc::Status ResumeJob(ServerContext* context, const v1::ResumeJobRequest* request, v1::Job* response) override {
    return Steer(*context, "tilemend.v1.Jobs/ResumeJob", {}, *request, response, &JobsHandler::ResumeJob);
  }
  grpc::Status PrioritizeJob(ServerContext* context, const v1::PrioritizeJobRequest* request,
                             v1::Job* response) override {
    return Steer(*context, "tilemend.v1.Jobs/PrioritizeJob", {{"priority", request->priority()}}, *request, response,
                 &JobsHandler::PrioritizeJob);
  }

 private:
  template <typename Request>
  grpc::Status Steer(const ServerContext& context, std::string_view rpc, LogFields how, const Request& request,
                     v1::Job* response, absl::StatusOr<v1::Job> (JobsHandler::*steer)(const Request&)) {
    return entrance_.Change(context, rpc, request.name(), std::move(how), response,
                            [&](const Caller& caller) -> absl::StatusOr<v1::Job> {
                              TILEMEND_RETURN_IF_ERROR(CheckOwner(caller, request.name()));
                              return std::invoke(steer, calls_.jobs, request);
                            });
  }

  // Another's job is the administrators'.
  absl::Status CheckOwner(const Caller& caller, const std::string& name) {
    if (caller.May(Role::kAdmin)) return absl::OkStatus();
    v1::GetJobRequest request;
    request.set_name(name);
    TILEMEND_ASSIGN_OR_RETURN(const v1::Job job, calls_.jobs.GetJob(request));
    if (job.owner() == caller.name) return absl::OkStatus();
    return WithErrorInfo(absl::PermissionDeniedError(absl::StrCat(name, ": is another's; it needs the role admin")),
                         {"ROLE_NEEDED", {{"role", "admin"}, {"job", name}}});
  }

  CallHandlers& calls_;
  const Entrance& entrance_;
};

class WorkersService : public v1::Workers::Service {
 public:
  WorkersService(CallHandlers& calls, const Entrance& entrance) : calls_(calls), entrance_(entrance) {}

  grpc::Status ListWorkers(ServerContext* context, const v1::ListWorkersRequest* request,
                           v1::ListWorkersResponse* response) override {
    return entrance_.Run(*context, "tilemend.v1.Workers/ListWorkers",
                         [&](const Caller&) { return Take(calls_.cluster.ListWorkers(*request), response); });
  }

 private:
  CallHandlers& calls_;
  const Entrance& entrance_;
};

class WorkService : public v1::Work::Service {
 public:
  WorkService(CallHandlers& calls, const Entrance& entrance) : calls_(calls), entrance_(entrance) {}

  grpc::Status Sync(ServerContext* context, const v1::SyncRequest* request, v1::SyncResponse* response) override {
    return entrance_.Run(*context, "tilemend.v1.Work/Sync", [&](const Caller& caller) {
      return Take(calls_.work.Sync(
                      *request, [context] { return !context->IsCancelled(); }, caller.name),
                  response);
    });
  }
  grpc::Status ReadBlob(ServerContext* context, const v1::ReadBlobRequest* request,
                        grpc::ServerWriter<v1::BlobChunk>* writer) override {
    return entrance_.Run(*context, "tilemend.v1.Work/ReadBlob", [&](const Caller&) {
      const auto send = [writer](std::string_view bytes) {
        v1::BlobChunk chunk;
        chunk.set_data(bytes.data(), bytes.size());
        return writer->Write(chunk);
      };
      return calls_.blobs.ReadBlob(*request, send, [context] { context->TryCancel(); });
    });
  }
  grpc::Status WriteBlob(ServerContext* context, grpc::ServerReader<v1::WriteBlobRequest>* reader,
                         v1::WriteBlobResponse* response) override {
    return entrance_.Run(*context, "tilemend.v1.Work/WriteBlob", [&](const Caller&) {
      return Take(calls_.blobs.WriteBlob([reader](v1::WriteBlobRequest& message) { return reader->Read(&message); },
                                         [context] { context->TryCancel(); }),
                  response);
    });
  }

 private:
  CallHandlers& calls_;
  const Entrance& entrance_;
};

class ScalerService : public externalscaler::ExternalScaler::Service {
 public:
  ScalerService(CallHandlers& calls, const Entrance& entrance) : calls_(calls), entrance_(entrance) {}

  grpc::Status IsActive(ServerContext* context, const externalscaler::ScaledObjectRef*,
                        externalscaler::IsActiveResponse* response) override {
    return entrance_.Run(*context, "externalscaler.ExternalScaler/IsActive", [&](const Caller&) {
      response->set_result(calls_.cluster.DemandNow().jobs > 0);
      return absl::OkStatus();
    });
  }
  grpc::Status StreamIsActive(ServerContext* context, const externalscaler::ScaledObjectRef*,
                              grpc::ServerWriter<externalscaler::IsActiveResponse>* writer) override {
    return entrance_.Run(*context, "externalscaler.ExternalScaler/StreamIsActive", [&](const Caller&) {
      const auto send = [writer](bool active) {
        externalscaler::IsActiveResponse response;
        response.set_result(active);
        return writer->Write(response);
      };
      return calls_.watch.WatchDemand(
          send, [&] { return entrance_.GoOn(*context, "externalscaler.ExternalScaler/StreamIsActive"); });
    });
  }
  grpc::Status GetMetricSpec(ServerContext* context, const externalscaler::ScaledObjectRef* request,
                             externalscaler::GetMetricSpecResponse* response) override {
    return entrance_.Run(*context, "externalscaler.ExternalScaler/GetMetricSpec",
                         [&](const Caller&) { return Take(ScalerSpec(*request), response); });
  }
  grpc::Status GetMetrics(ServerContext* context, const externalscaler::GetMetricsRequest* request,
                          externalscaler::GetMetricsResponse* response) override {
    return entrance_.Run(*context, "externalscaler.ExternalScaler/GetMetrics", [&](const Caller&) {
      return Take(ScalerMetrics(*request, calls_.cluster.DemandNow()), response);
    });
  }

 private:
  CallHandlers& calls_;
  const Entrance& entrance_;
};

class Server : public CoordinatorServer {
 public:
  Server(Coordinator& coordinator, std::shared_ptr<Gate> gate)
      : coordinator_(coordinator),
        entrance_(std::move(gate)),
        jobs_(coordinator.calls(), entrance_),
        workers_(coordinator.calls(), entrance_),
        work_(coordinator.calls(), entrance_),
        scaler_(coordinator.calls(), entrance_) {}
  ~Server() override { coordinator_.StopWaiting(); }

  absl::Status Start(const std::string& listen, const TlsFiles& tls) {
    TILEMEND_ASSIGN_OR_RETURN(rpc_, RpcServer::Start(listen, {&jobs_, &workers_, &work_, &scaler_}, tls));
    return absl::OkStatus();
  }
  RpcServer& rpc() override { return *rpc_; }

 private:
  Coordinator& coordinator_;
  const Entrance entrance_;
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
