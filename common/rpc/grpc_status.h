// absl::Status <-> grpc::Status. ErrorInfo travels in the grpc-status-details-bin trailer.
#ifndef TILEMEND_COMMON_RPC_GRPC_STATUS_H_
#define TILEMEND_COMMON_RPC_GRPC_STATUS_H_

#include <grpcpp/support/status.h>

#include <utility>

#include "absl/status/status.h"
#include "absl/status/statusor.h"

namespace tilemend {

grpc::Status ToGrpcStatus(const absl::Status& status);
absl::Status FromGrpcStatus(const grpc::Status& status);

// The same of a call that its caller has not cancelled. gRPC answers CANCELLED while a server ends, which is
// kUnavailable here.
absl::Status FromServerStatus(const grpc::Status& status);

// Moves a value into `response`, or gives the error: the last line of a unary handler.
template <typename T>
grpc::Status Reply(absl::StatusOr<T> result, T* response) {
  if (!result.ok()) return ToGrpcStatus(result.status());
  *response = std::move(result).value();
  return grpc::Status::OK;
}

}  // namespace tilemend

#endif  // TILEMEND_COMMON_RPC_GRPC_STATUS_H_
