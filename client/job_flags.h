// Flags that several commands share.
#ifndef TILEMEND_CLIENT_JOB_FLAGS_H_
#define TILEMEND_CLIENT_JOB_FLAGS_H_

#include <optional>

#include "absl/status/statusor.h"
#include "client/commands.h"
#include "client/output.h"
#include "coordinator/report/water_choice.h"
#include "tilemend/v1/jobs.pb.h"

namespace tilemend {

// The spec that the first argument and JobFlags say, with absolute paths (a scene with :// is kept as it is).
// kInvalidArgument for a value out of its range.
absl::StatusOr<v1::JobSpec> SpecFromFlags(const Args& args);

// --tension auto|X; none for auto.
absl::StatusOr<std::optional<double>> TensionFromFlags(const Args& args);
absl::StatusOr<double> WaterToleranceFromFlags(const Args& args);
absl::StatusOr<WaterProfile> WaterProfileFromFlags(const Args& args);

absl::StatusOr<OutputFormat> FormatFromFlags(const Args& args);

// A wrong flag: like PrintError, but always kExitUsage.
int PrintUsageError(const absl::Status& status);

}  // namespace tilemend

#endif  // TILEMEND_CLIENT_JOB_FLAGS_H_
