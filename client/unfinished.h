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

// Whether `output` is a folder with a report.json: kNotFound if it is no folder, CheckFinished if the output is not
// complete, kNotFound if no job wrote it. What is in an object store is not looked at. `scene`: of which it should be
// the output, "" if nobody said; if that is an output and `output` is none, the error says that they are swapped.
absl::Status CheckHasReport(const std::string& output, const std::string& scene = "");

}  // namespace tilemend

#endif  // TILEMEND_CLIENT_UNFINISHED_H_
