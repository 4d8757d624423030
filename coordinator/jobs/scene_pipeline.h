// The pipeline of real scenes. Defined by the library tilemend_scene_pipeline.
#ifndef TILEMEND_COORDINATOR_JOBS_SCENE_PIPELINE_H_
#define TILEMEND_COORDINATOR_JOBS_SCENE_PIPELINE_H_

#include <string>

#include "coordinator/jobs/job_pipeline.h"
#include "coordinator/jobs/scene_verification.h"

namespace tilemend {

// What a job puts aside while it runs lies in `scratch`, a folder; empty: that of the system for such files. Files
// there have no names: they end with the process. What an earlier process of the job verified is not verified again.
PipelineFactory ScenePipelineFactory(std::string scratch = "", VerifiedShares verified = {});

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_JOBS_SCENE_PIPELINE_H_
