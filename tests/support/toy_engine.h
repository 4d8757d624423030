// A pipeline without geometry, shaped like the real one: surveys, then layer after layer of fills that need their
// neighbours' results, then assembly. Its result is a function of the spec alone.
//
// The scene is "toy://COLSxROWS" with options "?key=value&key=value":
//   bytes=N        each survey returns N bytes beside its number
//   sleep_ms=N     each survey takes N ms, or ends early when it is cancelled
//   fail=C,R       the survey of cell (C, R) returns kInvalidArgument
//   plan_error=1   the pipeline fails when all surveys are in
//   stall=1        the pipeline gives no tasks after the surveys, yet is not done (a bug in a pipeline)
#ifndef TILEMEND_TESTS_SUPPORT_TOY_ENGINE_H_
#define TILEMEND_TESTS_SUPPORT_TOY_ENGINE_H_

#include <string>

#include "coordinator/jobs/job_pipeline.h"
#include "worker/service/stage_runner.h"

namespace tilemend {

// kNotFound for a scene that does not begin with toy://, kInvalidArgument for a malformed one. Finish writes
// OUT/report.json and its message is "total N".
PipelineFactory ToyPipelineFactory();

StageRunner ToyStageRunner();

}  // namespace tilemend

#endif  // TILEMEND_TESTS_SUPPORT_TOY_ENGINE_H_
