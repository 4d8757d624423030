// What a job's spec asks of the waves.
#ifndef TILEMEND_COORDINATOR_JOBS_SCENE_OPTIONS_H_
#define TILEMEND_COORDINATOR_JOBS_SCENE_OPTIONS_H_

#include <functional>

#include "coordinator/jobs/job_pipeline.h"
#include "coordinator/report/water_choice.h"
#include "coordinator/waves/scene_waves.h"

namespace tilemend {

// All cells are chosen. Precondition: CheckJob(spec).ok().
WaveOptions WaveOptionsOf(const JobSpec& spec, WaterOptions water, std::function<bool()> is_cancelled);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_JOBS_SCENE_OPTIONS_H_
