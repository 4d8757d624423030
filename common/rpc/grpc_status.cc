#include "common/rpc/grpc_status.h"

#include <string>

#include "common/rpc/status_proto.h"

namespace tilemend {
namespace {

constexpr char kNoThread[] = "Server Threadpool Exhausted";  // gRPC's words
constexpr char kNoThreadPlainly[] =
    "the coordinator has no thread for the call: it has too many, or the system gives it no more (`ulimit -a`); try "
    "again";

}  // namespace

grpc::Status ToGrpcStatus(const absl::Status& status) {
  if (status.ok()) return grpc::Status::OK;
  const v1::Status proto = StatusToProto(status);
  std::string details;
  if (proto.details_size() > 0) details = proto.SerializeAsString();
  return grpc::Status(static_cast<grpc::StatusCode>(status.code()), proto.message(), details);
}

absl::Status FromGrpcStatus(const grpc::Status& status) {
  if (status.ok()) return absl::OkStatus();
  v1::Status proto;
  if (!status.error_details().empty() && proto.ParseFromString(status.error_details()) &&
      proto.code() == static_cast<int>(status.error_code())) {
    return StatusFromProto(proto);
  }
  const bool no_thread = status.error_message() == kNoThread;
  return absl::Status(static_cast<absl::StatusCode>(status.error_code()),
                      no_thread ? kNoThreadPlainly : status.error_message());
}

}  // namespace tilemend
