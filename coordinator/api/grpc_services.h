// gRPC over the handlers of the calls: nothing but adapters.
#ifndef TILEMEND_COORDINATOR_API_GRPC_SERVICES_H_
#define TILEMEND_COORDINATOR_API_GRPC_SERVICES_H_

#include <memory>
#include <string>

#include "absl/status/statusor.h"
#include "common/rpc/endpoint.h"
#include "coordinator/api/coordinator.h"
#include "coordinator/api/gate.h"

namespace tilemend {

struct ServerOptions {
  TlsFiles tls;
  std::shared_ptr<Gate> gate;  // null: everybody may do everything, and nobody counts it
};

// A coordinator on the network (or in process alone, with an empty `listen`). It ends before `coordinator` does.
class CoordinatorServer {
 public:
  // Errors of RpcServer::Start. `coordinator` must outlive the server.
  static absl::StatusOr<std::unique_ptr<CoordinatorServer>> Start(const std::string& listen, Coordinator& coordinator,
                                                                  ServerOptions options = {});
  virtual ~CoordinatorServer() = default;

  virtual RpcServer& rpc() = 0;
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_API_GRPC_SERVICES_H_
