// Outputs that a job has begun and not completed.
#ifndef TILEMEND_CLIENT_UNFINISHED_H_
#define TILEMEND_CLIENT_UNFINISHED_H_

#include <string>

#include "absl/status/status.h"

namespace tilemend {

// Whether a job writes to the folder, or ended there before its output was complete; or its report was taken away.
bool IsUnfinished(const std::string& output);

// Whether a job has written to the folder.
bool IsOutput(const std::string& folder);

// kNotFound where it is so, with what to do.
absl::Status CheckFinished(const std::string& output);

// kNotFound if `output` has no report. Asks whether the arguments are swapped if `scene` has one.
absl::Status CheckIsOutput(const std::string& scene, const std::string& output);

}  // namespace tilemend

#endif  // TILEMEND_CLIENT_UNFINISHED_H_
