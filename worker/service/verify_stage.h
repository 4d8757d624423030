// Verification of what other workers reported.
#ifndef TILEMEND_WORKER_SERVICE_VERIFY_STAGE_H_
#define TILEMEND_WORKER_SERVICE_VERIFY_STAGE_H_

#include <functional>
#include <string>

#include "absl/status/statusor.h"
#include "common/util/cancel_token.h"
#include "common/util/stage.h"
#include "tilemend/v1/verify.pb.h"
#include "worker/service/task_memory.h"

namespace tilemend {

// Computes a task of another stage.
using ComputeStage = std::function<absl::StatusOr<std::string>(Stage stage, const std::string& input)>;

// A VerifyOutput. Every file is opened anew and read whole, and every task is computed. kUnavailable if a file cannot
// be read here: another machine may. kCancelled. Errors of `compute`.
absl::StatusOr<std::string> RunVerify(const v1::VerifyInput& input, const CancelToken& cancel, TaskMemory& memory,
                                      const ComputeStage& compute);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_SERVICE_VERIFY_STAGE_H_
