// Flags that several commands share.
#ifndef TILEMEND_CLIENT_JOB_FLAGS_H_
#define TILEMEND_CLIENT_JOB_FLAGS_H_

#include <cstdint>
#include <optional>

#include "absl/status/statusor.h"
#include "client/commands.h"
#include "client/output.h"
#include "common/records/filler.h"
#include "coordinator/report/water_choice.h"
#include "tilemend/v1/jobs.pb.h"

namespace tilemend {

// The spec that the first argument and JobFlags say, with absolute paths (a scene with :// is kept as it is).
// kInvalidArgument for a value out of its range.
absl::StatusOr<v1::JobSpec> SpecFromFlags(const Args& args);

// kInvalidArgument, naming the flag, for one that is given and can have no effect beside others.
absl::Status CheckHaveEffect(const Args& args);

// None where the flag is not given; it has no default then.
absl::StatusOr<std::optional<double>> NumberIfGiven(const Args& args, const char* flag, double low, double high);
absl::StatusOr<std::optional<int32_t>> WholeNumberIfGiven(const Args& args, const char* flag, int low, int high);
// --tension auto|X; none for auto.
absl::StatusOr<Filler> FillerFromFlags(const Args& args);
absl::StatusOr<std::optional<double>> TensionFromFlags(const Args& args);
absl::StatusOr<WaterProfile> WaterProfileFromFlags(const Args& args);

absl::StatusOr<OutputFormat> FormatFromFlags(const Args& args);

// A wrong flag: like PrintError, but always kExitUsage.
int PrintUsageError(const absl::Status& status);

}  // namespace tilemend

#endif  // TILEMEND_CLIENT_JOB_FLAGS_H_
