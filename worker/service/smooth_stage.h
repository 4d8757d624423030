// The stage that smooths the patches of two cells along their seam.
#ifndef TILEMEND_WORKER_SERVICE_SMOOTH_STAGE_H_
#define TILEMEND_WORKER_SERVICE_SMOOTH_STAGE_H_

#include <string>

#include "absl/status/statusor.h"
#include "tilemend/v1/stages.pb.h"

namespace tilemend {

// The bytes of a SmoothSeamOutput (worker/fill/seam/smooth_seam.h). kInvalidArgument for an input that does not fit
// together.
absl::StatusOr<std::string> RunSmoothSeam(const v1::SmoothSeamInput& input);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_SERVICE_SMOOTH_STAGE_H_
