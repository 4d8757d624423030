// Flags that several commands share.
#ifndef TILEMEND_CLIENT_JOB_FLAGS_H_
#define TILEMEND_CLIENT_JOB_FLAGS_H_

#include <cstdint>
#include <optional>

#include "absl/status/statusor.h"
#include "client/commands.h"
#include "client/output.h"
#include "common/options/job_options.h"
#include "tilemend/v1/job_spec.pb.h"

namespace tilemend {

// The spec that the first argument and the flags of jobs say. Paths are absolute; a scene with :// is kept as it is.
// kInvalidArgument, naming the flag, its value and what is allowed.
absl::StatusOr<v1::JobSpec> JobFromFlags(const Args& args);

// Options whose flag is given. The arguments outlive it.
IsGiven GivenBy(const Args& args);

// None where the flag is not given; it has no default then.
absl::StatusOr<std::optional<int32_t>> WholeNumberIfGiven(const Args& args, const char* flag, int low, int high);

absl::StatusOr<OutputFormat> FormatFromFlags(const Args& args);

// A wrong flag: like PrintError, but always kExitUsage.
int PrintUsageError(const absl::Status& status);

}  // namespace tilemend

#endif  // TILEMEND_CLIENT_JOB_FLAGS_H_
