// The stages of real scenes. Defined by the library tilemend_scene_stages.
#ifndef TILEMEND_WORKER_SERVICE_SCENE_STAGES_H_
#define TILEMEND_WORKER_SERVICE_SCENE_STAGES_H_

#include "worker/service/stage_runner.h"

namespace tilemend {

StageRunner SceneStageRunner();

}  // namespace tilemend

#endif  // TILEMEND_WORKER_SERVICE_SCENE_STAGES_H_
