#include "common/rpc/status_proto.h"

#include <string>

#include "common/util/error_info.h"
#include "common/util/text.h"

namespace tilemend {
namespace {

// Read by every client library that knows google.rpc.ErrorInfo.
constexpr char kErrorInfoType[] = "type.googleapis.com/google.rpc.ErrorInfo";

}  // namespace

v1::Status StatusToProto(const absl::Status& status) {
  v1::Status proto;
  proto.set_code(static_cast<int>(status.code()));
  proto.set_message(Printable(std::string(status.message())));  // it may quote a file
  const auto info = GetErrorInfo(status);
  if (!info.has_value()) return proto;
  v1::ErrorInfo detail;
  detail.set_reason(info->reason);
  detail.set_domain(kErrorDomain);
  for (const auto& [key, value] : info->metadata) (*detail.mutable_metadata())[key] = Printable(value);
  auto* any = proto.add_details();
  any->set_type_url(kErrorInfoType);
  any->set_value(detail.SerializeAsString());
  return proto;
}

absl::Status StatusFromProto(const v1::Status& proto) {
  if (proto.code() == 0) return absl::OkStatus();
  const bool known = proto.code() > 0 && proto.code() <= static_cast<int>(absl::StatusCode::kUnauthenticated);
  absl::Status status(known ? static_cast<absl::StatusCode>(proto.code()) : absl::StatusCode::kUnknown,
                      proto.message());
  for (const auto& any : proto.details()) {
    v1::ErrorInfo detail;
    if (any.type_url() != kErrorInfoType || !detail.ParseFromString(any.value())) continue;
    ErrorInfo info;
    info.reason = detail.reason();
    info.metadata.insert(detail.metadata().begin(), detail.metadata().end());
    status = WithErrorInfo(std::move(status), info);
  }
  return status;
}

}  // namespace tilemend
