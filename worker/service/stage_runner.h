// What a worker computes.
#ifndef TILEMEND_WORKER_SERVICE_STAGE_RUNNER_H_
#define TILEMEND_WORKER_SERVICE_STAGE_RUNNER_H_

#include <functional>
#include <string>

#include "absl/status/statusor.h"
#include "common/util/cancel_token.h"
#include "common/util/stage.h"

namespace tilemend {

// Runs one stage on the bytes that the pipeline gave and returns the bytes that it gets. Called by several threads at
// once. Must be a function of its input: a task may run more than once, and the first result counts. kUnavailable and
// kResourceExhausted are taken for the machine's failure and tried again (elsewhere, three times in all); any other
// error goes to the pipeline. Looks at the token every 10 ms or so; what it returns after a cancel is dropped.
using StageRunner =
    std::function<absl::StatusOr<std::string>(Stage stage, const std::string& input, const CancelToken& cancel)>;

// Takes away what a stage left on the disk: its output is of use to nobody. Called by several threads at once.
using OutputDiscarder = std::function<void(Stage stage, const std::string& input, const std::string& output)>;

}  // namespace tilemend

#endif  // TILEMEND_WORKER_SERVICE_STAGE_RUNNER_H_
