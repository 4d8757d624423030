// What a program may read out of an error: a reason that never changes and a few facts, beside the text for people.
#ifndef TILEMEND_COMMON_UTIL_ERROR_INFO_H_
#define TILEMEND_COMMON_UTIL_ERROR_INFO_H_

#include <map>
#include <optional>
#include <string>

#include "absl/status/status.h"

namespace tilemend {

// The domain of every reason below.
inline constexpr char kErrorDomain[] = "tilemend";

struct ErrorInfo {
  std::string reason;  // UPPER_SNAKE_CASE, for instance "LATE_RESULT"
  std::map<std::string, std::string> metadata;
  bool operator==(const ErrorInfo&) const = default;
};

// `status` with `info` attached; an OK status is returned as it is. Survives a trip over gRPC
// (common/rpc/grpc_status.h).
absl::Status WithErrorInfo(absl::Status status, const ErrorInfo& info);

// What WithErrorInfo attached, if anything.
std::optional<ErrorInfo> GetErrorInfo(const absl::Status& status);

// The reason alone, "" if there is none.
std::string ErrorReason(const absl::Status& status);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_UTIL_ERROR_INFO_H_
