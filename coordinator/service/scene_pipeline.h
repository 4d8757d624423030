// The pipeline of real scenes. Defined by the library tilemend_scene_pipeline.
#ifndef TILEMEND_COORDINATOR_SERVICE_SCENE_PIPELINE_H_
#define TILEMEND_COORDINATOR_SERVICE_SCENE_PIPELINE_H_

#include "coordinator/service/job_pipeline.h"

namespace tilemend {

// What a job puts aside while it runs lies in `scratch`, a folder; empty: that of the system for such files. Files
// there have no names: they end with the process.
PipelineFactory ScenePipelineFactory(std::string scratch = "");

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_SERVICE_SCENE_PIPELINE_H_
