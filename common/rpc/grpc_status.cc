#include "common/rpc/grpc_status.h"

#include <optional>
#include <string>

#include "common/rpc/status_proto.h"
#include "common/util/error_info.h"
#include "common/util/text.h"

namespace tilemend {
namespace {

constexpr char kNoThread[] = "Server Threadpool Exhausted";  // gRPC's words
constexpr char kNoThreadPlainly[] =
    "the coordinator has no thread for the call: it has too many, or the system gives it no more (`ulimit -a`); try "
    "again";

// A call's trailers have at most 8 KiB, or the peer sees another error. The text stands there twice: with each byte
// that is not ASCII as three, and in the details as base64.
constexpr size_t kMostTextBytes = 1024, kMostFactBytes = 256;

absl::Status Bounded(const absl::Status& status) {
  absl::Status bounded(status.code(), Shortened(Printable(std::string(status.message())), kMostTextBytes));
  std::optional<ErrorInfo> info = GetErrorInfo(status);
  if (!info) return bounded;
  for (auto& [key, value] : info->metadata) value = Shortened(Printable(value), kMostFactBytes);
  return WithErrorInfo(std::move(bounded), *info);
}

}  // namespace

grpc::Status ToGrpcStatus(const absl::Status& status) {
  if (status.ok()) return grpc::Status::OK;
  const v1::Status proto = StatusToProto(Bounded(status));
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

absl::Status FromServerStatus(const grpc::Status& status) {
  absl::Status known = FromGrpcStatus(status);
  return absl::IsCancelled(known) ? absl::UnavailableError("the coordinator has ended the call") : known;
}

}  // namespace tilemend
