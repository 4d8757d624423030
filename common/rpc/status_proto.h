// absl::Status <-> tilemend.v1.Status, with its ErrorInfo.
#ifndef TILEMEND_COMMON_RPC_STATUS_PROTO_H_
#define TILEMEND_COMMON_RPC_STATUS_PROTO_H_

#include "absl/status/status.h"
#include "tilemend/v1/error_info.pb.h"

namespace tilemend {

v1::Status StatusToProto(const absl::Status& status);

// A code that is not one of gRPC's is kUnknown.
absl::Status StatusFromProto(const v1::Status& proto);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_RPC_STATUS_PROTO_H_
