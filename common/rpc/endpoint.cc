#include "common/rpc/endpoint.h"

#include <google/protobuf/stubs/logging.h>
#include <grpc/compression.h>
#include <grpcpp/create_channel.h>
#include <grpcpp/ext/proto_server_reflection_plugin.h>
#include <grpcpp/health_check_service_interface.h>
#include <grpcpp/resource_quota.h>
#include <grpcpp/server_builder.h>
#include <grpcpp/support/client_interceptor.h>
#include <sys/resource.h>

#include <chrono>
#include <cstdlib>
#include <utility>

#include "absl/strings/numbers.h"
#include "absl/strings/str_cat.h"
#include "common/rpc/limits.h"
#include "common/util/shortage.h"
#include "common/util/standard_streams.h"
#include "common/util/status_macros.h"

namespace tilemend {
namespace {

// Threads of calls that do not wait for news: short ones, and streams of blobs, which are bounded below that.
constexpr int kMostCalls = 1500;

// Of one connection at once; a caller's further calls wait on its side.
constexpr int kMostCallsOfConnection = 512;

// Of what callers send and nobody has looked at yet. gRPC reads a message that is too long to its end before it refuses
// it.
constexpr size_t kMostReceivedBytes = size_t{64} << 20;

// gRPC 1.51 bounds a message before it decompresses it, so that 400 KB of gzip would become 450 MB. What is stored here
// is compressed already.
void RefuseCompression(grpc::ServerBuilder& builder) {
  for (const grpc_compression_algorithm algorithm : {GRPC_COMPRESS_DEFLATE, GRPC_COMPRESS_GZIP}) {
    builder.SetCompressionAlgorithmSupportStatus(algorithm, false);
  }
  builder.AddChannelArgument(GRPC_ARG_ENABLE_PER_MESSAGE_DECOMPRESSION, 0);
}

grpc::ChannelArguments ChannelArguments() {
  grpc::ChannelArguments arguments;
  arguments.SetMaxReceiveMessageSize(kMaxMessageBytes);
  arguments.SetMaxSendMessageSize(kMaxMessageBytes);
  arguments.SetInt(GRPC_ARG_KEEPALIVE_TIME_MS, 20'000);
  arguments.SetInt(GRPC_ARG_KEEPALIVE_TIMEOUT_MS, 10'000);
  arguments.SetInt(GRPC_ARG_HTTP2_MAX_PINGS_WITHOUT_DATA, 0);  // no bound: a watch may be silent for hours
  arguments.SetInt(GRPC_ARG_INITIAL_RECONNECT_BACKOFF_MS, 100);
  arguments.SetInt(GRPC_ARG_MIN_RECONNECT_BACKOFF_MS, 2'000);  // how long an attempt may take
  arguments.SetInt(GRPC_ARG_MAX_RECONNECT_BACKOFF_MS, 1'000);
  return arguments;
}

absl::StatusOr<std::unique_ptr<Acceptor>> ListenOn(const std::string& address) {
  TILEMEND_RETURN_IF_ERROR(CheckAddress(address));
  const size_t colon = address.rfind(':');
  int port = 0;
  if (!absl::SimpleAtoi(address.substr(colon + 1), &port)) return absl::InternalError("CheckAddress looked");
  auto acceptor = Acceptor::Listen(address.substr(0, colon), port);
  if (acceptor.ok()) return acceptor;
  return absl::UnavailableError(absl::StrCat(address, ": cannot listen there (",
                                             std::string(acceptor.status().message()),
                                             "): in use, or not an address of this machine; choose another"));
}

// Puts the token into a call. The file is read each time: a token may be replaced while the program runs.
class TokenSender : public grpc::experimental::Interceptor {
 public:
  explicit TokenSender(const std::string& file) : file_(file) {}
  void Intercept(grpc::experimental::InterceptorBatchMethods* methods) override {
    using Point = grpc::experimental::InterceptionHookPoints;
    if (methods->QueryInterceptionHookPoint(Point::PRE_SEND_INITIAL_METADATA)) {
      if (const auto token = ReadToken(file_); token.ok()) {
        header_ = absl::StrCat("Bearer ", *token);
        methods->GetSendInitialMetadata()->insert({"authorization", header_});
      }
    }
    methods->Proceed();
  }

 private:
  const std::string& file_;
  std::string header_;  // gRPC does not copy it
};

class TokenSenders : public grpc::experimental::ClientInterceptorFactoryInterface {
 public:
  explicit TokenSenders(std::string file) : file_(std::move(file)) {}
  grpc::experimental::Interceptor* CreateClientInterceptor(grpc::experimental::ClientRpcInfo*) override {
    return new TokenSender(file_);
  }

 private:
  const std::string file_;
};

}  // namespace

RpcServer::RpcServer(std::unique_ptr<AnswerWatch> watch, std::unique_ptr<grpc::Server> server,
                     std::unique_ptr<Acceptor> acceptor)
    : watch_(std::move(watch)), server_(std::move(server)), acceptor_(std::move(acceptor)) {}

RpcServer::~RpcServer() { Shutdown(absl::Seconds(2)); }

absl::StatusOr<std::unique_ptr<RpcServer>> RpcServer::Start(const std::string& listen,
                                                            const std::vector<grpc::Service*>& services,
                                                            const TlsFiles& tls) {
  auto watch = std::make_unique<AnswerWatch>();
  grpc::EnableDefaultHealthCheckService(true);
  grpc::reflection::InitProtoReflectionServerBuilderPlugin();
  grpc::ServerBuilder builder;
  builder.SetMaxReceiveMessageSize(kMaxMessageBytes);
  builder.SetMaxSendMessageSize(kMaxMessageBytes);
  RefuseCompression(builder);
  builder.AddChannelArgument(GRPC_ARG_HTTP2_MIN_RECV_PING_INTERVAL_WITHOUT_DATA_MS, 10'000);
  builder.AddChannelArgument(GRPC_ARG_KEEPALIVE_PERMIT_WITHOUT_CALLS, 1);
  // A connection that says nothing, or has nothing to say any more, makes room for others.
  builder.AddChannelArgument(GRPC_ARG_SERVER_HANDSHAKE_TIMEOUT_MS, 4'000);
  builder.AddChannelArgument(GRPC_ARG_MAX_CONNECTION_IDLE_MS, 60'000);
  builder.AddChannelArgument(GRPC_ARG_MAX_CONCURRENT_STREAMS, kMostCallsOfConnection);
  grpc::ResourceQuota quota("tilemend");
  quota.SetMaxThreads(kMostCalls);
  quota.Resize(kMostReceivedBytes);
  builder.SetResourceQuota(quota);
  std::unique_ptr<Acceptor> acceptor;
  std::unique_ptr<grpc::experimental::ExternalConnectionAcceptor> taker;
  if (!listen.empty()) {
    TILEMEND_ASSIGN_OR_RETURN(acceptor, ListenOn(listen));
    using Type = grpc::ServerBuilder::experimental_type::ExternalConnectionType;
    taker = builder.experimental().AddExternalConnectionAcceptor(Type::FROM_FD, MakeServerCredentials(tls));
  }
  for (grpc::Service* service : services) builder.RegisterService(service);
  std::unique_ptr<grpc::Server> server = builder.BuildAndStart();
  if (server == nullptr) return absl::UnavailableError(absl::StrCat(listen, ": cannot serve there"));
  if (acceptor != nullptr) {
    acceptor->Start(MostDescriptorsOfConnections(), [taker = std::shared_ptr(std::move(taker))](int fd) {
      grpc::experimental::ExternalConnectionAcceptor::NewConnectionParameters connection;
      connection.listener_fd = -1;
      connection.fd = fd;
      taker->HandleNewConnection(&connection);
    });
  }
  return std::unique_ptr<RpcServer>(new RpcServer(std::move(watch), std::move(server), std::move(acceptor)));
}

std::shared_ptr<grpc::Channel> RpcServer::InProcessChannel() { return server_->InProcessChannel(ChannelArguments()); }

void RpcServer::Shutdown(absl::Duration grace) {
  if (acceptor_ != nullptr) acceptor_->Stop();
  if (auto* health = server_->GetHealthCheckService(); health != nullptr) health->Shutdown();
  server_->Shutdown(std::chrono::system_clock::now() + absl::ToChronoMilliseconds(grace));
}

std::shared_ptr<grpc::Channel> Connect(const std::string& address, const Security& security) {
  std::vector<std::unique_ptr<grpc::experimental::ClientInterceptorFactoryInterface>> interceptors;
  if (!security.token_file.empty()) interceptors.push_back(std::make_unique<TokenSenders>(security.token_file));
  return grpc::experimental::CreateCustomChannelWithInterceptors(address, MakeChannelCredentials(security.tls),
                                                                 ChannelArguments(), std::move(interceptors));
}

absl::Status CheckAddress(const std::string& address) {
  const size_t colon = address.rfind(':');
  int port = -1;
  if (colon == std::string::npos || colon == 0 || !absl::SimpleAtoi(address.substr(colon + 1), &port) || port < 0 ||
      port > 65535) {
    return absl::InvalidArgumentError(absl::StrCat("'", address, "': expected HOST:PORT, for instance 127.0.0.1:7070"));
  }
  return absl::OkStatus();
}

std::string WithPort(const std::string& address, int port) {
  return absl::StrCat(address.substr(0, address.rfind(':')), ":", port);
}

void PrepareProcess() {
  OpenStandardStreams();
  EndOnShortage();
  // What it would say of a malformed message stands in the answer already; whoever sends them could fill the log.
  google::protobuf::SetLogHandler(nullptr);
  setenv("GRPC_VERBOSITY", "NONE", 0);
  // While a channel is not connected its calls fail at once, and nothing but this notices that it is again. The default
  // is 5 s.
  setenv("GRPC_CLIENT_CHANNEL_BACKUP_POLL_INTERVAL_MS", "100", 0);
  rlimit limit{};
  if (getrlimit(RLIMIT_NOFILE, &limit) != 0) return;
  limit.rlim_cur = limit.rlim_max;
  setrlimit(RLIMIT_NOFILE, &limit);
}

}  // namespace tilemend
