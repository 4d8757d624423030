// Whether a result can be that of smoothing a seam.
#ifndef TILEMEND_COORDINATOR_JOBS_SMOOTH_CHECK_H_
#define TILEMEND_COORDINATOR_JOBS_SMOOTH_CHECK_H_

#include <string>

#include "absl/status/status.h"

namespace tilemend {

// kDataLoss (Wrong, of wrong_result.h) unless the bytes of a SmoothSeamOutput name the seam of the SmoothSeamInput,
// move points that its patches have, and stay within the heights of these: means do.
absl::Status CheckSmoothResult(const std::string& input_bytes, const v1::SmoothSeamOutput& output);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_JOBS_SMOOTH_CHECK_H_
