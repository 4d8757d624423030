// The stages of real scenes. Defined by the library tilemend_scene_stages.
#ifndef TILEMEND_WORKER_SERVICE_SCENE_STAGES_H_
#define TILEMEND_WORKER_SERVICE_SCENE_STAGES_H_

#include <cstdint>
#include <limits>

#include "worker/service/stage_runner.h"

namespace tilemend {

// Tasks wait until what they take, as foretold from their inputs, fits into `memory_bytes` beside what others have; one
// alone never waits.
StageRunner SceneStageRunner(int64_t memory_bytes = std::numeric_limits<int64_t>::max());

}  // namespace tilemend

#endif  // TILEMEND_WORKER_SERVICE_SCENE_STAGES_H_
