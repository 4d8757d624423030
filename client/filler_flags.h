// Flags of what the papers of the fillers leave open.
#ifndef TILEMEND_CLIENT_FILLER_FLAGS_H_
#define TILEMEND_CLIENT_FILLER_FLAGS_H_

#include <vector>

#include "absl/status/status.h"
#include "client/commands.h"
#include "coordinator/report/scene_report.h"
#include "worker/fill/fill_holes.h"

namespace tilemend {

std::vector<FlagSpec> FillerFlags();
// One of these, which jobs have as well.
FlagSpec FrontStepsFlag();

// Reads them into options.filling. kInvalidArgument for a value out of its range, and for an option that
// options.filler, which is read, does not have.
absl::Status ReadFillerFlags(const Args& args, FillOptions& options);

// The surface, the filler, and each option that these have, under the names of their flags.
std::vector<ReportedOption> ReportedFillerOptions(const FillOptions& options);

}  // namespace tilemend

#endif  // TILEMEND_CLIENT_FILLER_FLAGS_H_
