// Exit codes of every tilemend program.
#ifndef TILEMEND_COMMON_UTIL_EXIT_CODES_H_
#define TILEMEND_COMMON_UTIL_EXIT_CODES_H_

#include "absl/status/status.h"

namespace tilemend {

enum ExitCode : int {
  kExitDone = 0,
  kExitUsage = 2,
  kExitNotFound = 3,
  kExitInvalidInput = 4,
  kExitRetryable = 5,
  kExitFailed = 6,
  kExitCancelled = 7,
  kExitSomeLeft = 100,  // done, but some holes or cells are left
};

inline ExitCode ExitCodeOf(const absl::Status& status) {
  switch (status.code()) {
    case absl::StatusCode::kOk:
      return kExitDone;
    case absl::StatusCode::kNotFound:
      return kExitNotFound;
    case absl::StatusCode::kInvalidArgument:
    case absl::StatusCode::kOutOfRange:
    case absl::StatusCode::kAlreadyExists:  // an output is there and --overwrite was not given
      return kExitInvalidInput;
    case absl::StatusCode::kUnavailable:
    case absl::StatusCode::kDeadlineExceeded:
    case absl::StatusCode::kResourceExhausted:
    case absl::StatusCode::kAborted:
      return kExitRetryable;
    case absl::StatusCode::kCancelled:
      return kExitCancelled;
    default:
      return kExitFailed;
  }
}

}  // namespace tilemend

#endif  // TILEMEND_COMMON_UTIL_EXIT_CODES_H_
