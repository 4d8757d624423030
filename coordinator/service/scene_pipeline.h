// The pipeline of real scenes. Defined by the library tilemend_scene_pipeline.
#ifndef TILEMEND_COORDINATOR_SERVICE_SCENE_PIPELINE_H_
#define TILEMEND_COORDINATOR_SERVICE_SCENE_PIPELINE_H_

#include "coordinator/service/job_pipeline.h"

namespace tilemend {

PipelineFactory ScenePipelineFactory();

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_SERVICE_SCENE_PIPELINE_H_
