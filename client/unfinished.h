// Outputs that a job has begun and not completed.
#ifndef TILEMEND_CLIENT_UNFINISHED_H_
#define TILEMEND_CLIENT_UNFINISHED_H_

#include <string>

#include "absl/status/status.h"

namespace tilemend {

// Whether a job writes to the folder, or ended there before its output was complete.
bool IsUnfinished(const std::string& output);

// kNotFound where it is so, with what to do.
absl::Status CheckFinished(const std::string& output);

}  // namespace tilemend

#endif  // TILEMEND_CLIENT_UNFINISHED_H_
