// The pipeline of real scenes. Defined by the library tilemend_scene_pipeline.
#ifndef TILEMEND_COORDINATOR_JOBS_SCENE_PIPELINE_H_
#define TILEMEND_COORDINATOR_JOBS_SCENE_PIPELINE_H_

#include <memory>
#include <string>

#include "coordinator/jobs/decoded_surveys.h"
#include "coordinator/jobs/job_pipeline.h"
#include "coordinator/jobs/scene_verification.h"

namespace tilemend {

// What a job puts aside while it runs lies in `scratch`, a folder; empty: that of the system for such files. Files
// there have no names: they end with the process. What an earlier process of the job verified is not verified again.
// `surveys`, if given, may have the records of results that were checked.
PipelineFactory ScenePipelineFactory(std::string scratch = "", VerifiedShares verified = {},
                                     std::shared_ptr<DecodedSurveys> surveys = nullptr);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_JOBS_SCENE_PIPELINE_H_
