// Servers and channels with the limits of the protocol.
#ifndef TILEMEND_COMMON_RPC_ENDPOINT_H_
#define TILEMEND_COMMON_RPC_ENDPOINT_H_

#include <grpcpp/channel.h>
#include <grpcpp/impl/codegen/service_type.h>
#include <grpcpp/server.h>

#include <memory>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "absl/time/time.h"
#include "common/rpc/acceptor.h"
#include "common/rpc/answer_limit.h"
#include "common/rpc/credentials.h"

namespace tilemend {

// A running gRPC server. Its services must outlive it.
class RpcServer {
 public:
  // Listens on `listen` ("HOST:PORT", port 0 takes a free one) or, if it is empty, only in process. Answers the
  // standard health check and reflection. kInvalidArgument for a malformed address, kUnavailable if the address cannot
  // be had. Connections and calls at once are bounded. So are the times that a connection may keep the server waiting
  // and that an answer may wait to be taken. Beyond that connections are closed and calls fail with kResourceExhausted.
  static absl::StatusOr<std::unique_ptr<RpcServer>> Start(const std::string& listen,
                                                          const std::vector<grpc::Service*>& services,
                                                          const TlsFiles& tls = {});
  ~RpcServer();

  int port() const { return acceptor_ == nullptr ? 0 : acceptor_->port(); }
  std::shared_ptr<grpc::Channel> InProcessChannel();
  // Takes no new calls, waits for running ones at most `grace`, then cancels them. Safe to call twice.
  void Shutdown(absl::Duration grace);

 private:
  RpcServer(std::unique_ptr<AnswerWatch> watch, std::unique_ptr<grpc::Server> server,
            std::unique_ptr<Acceptor> acceptor);

  std::unique_ptr<AnswerWatch> watch_;
  std::unique_ptr<grpc::Server> server_;
  std::unique_ptr<Acceptor> acceptor_;  // ends first; null: only in process
};

// Connects on first use and again whenever the connection is lost.
std::shared_ptr<grpc::Channel> Connect(const std::string& address, const Security& security = {});

// kInvalidArgument unless `address` is HOST:PORT with a port in [0, 65535].
absl::Status CheckAddress(const std::string& address);

// `address` with another port: where it is known, that of a server that chose one.
std::string WithPort(const std::string& address, int port);

// For the start of main. Opens standard streams that are closed (OpenStandardStreams), and raises the limit of open
// files as far as allowed. Keeps gRPC's own log quiet unless GRPC_VERBOSITY says otherwise, and protobuf's. From then
// on the process ends in order where it runs short (EndOnShortage).
void PrepareProcess();

}  // namespace tilemend

#endif  // TILEMEND_COMMON_RPC_ENDPOINT_H_
