// Whether a result can be that of smoothing a seam.
#ifndef TILEMEND_COORDINATOR_JOBS_SMOOTH_CHECK_H_
#define TILEMEND_COORDINATOR_JOBS_SMOOTH_CHECK_H_

#include <string>

#include "absl/status/status.h"

namespace tilemend {

// Checks that a SmoothSeamOutput names the seam of the SmoothSeamInput and moves points that its patches have. They
// must stay within the heights of these, as means do. Returns kDataLoss (Wrong, of wrong_result.h) otherwise.
absl::Status CheckSmoothResult(const std::string& input_bytes, const v1::SmoothSeamOutput& output);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_JOBS_SMOOTH_CHECK_H_
