// An error with everything that must come over the wire.
#ifndef TILEMEND_TESTS_COMMON_RPC_EXAMPLE_STATUS_H_
#define TILEMEND_TESTS_COMMON_RPC_EXAMPLE_STATUS_H_

#include "absl/status/status.h"
#include "common/util/error_info.h"

namespace tilemend {

inline absl::Status Example() {
  return WithErrorInfo(absl::NotFoundError("jobs/x: no such job"), {"JOB_NOT_FOUND", {{"job", "x"}, {"empty", ""}}});
}

}  // namespace tilemend

#endif  // TILEMEND_TESTS_COMMON_RPC_EXAMPLE_STATUS_H_
