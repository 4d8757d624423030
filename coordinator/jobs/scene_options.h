// What a job's spec asks of the waves, and which jobs write the same bytes.
#ifndef TILEMEND_COORDINATOR_JOBS_SCENE_OPTIONS_H_
#define TILEMEND_COORDINATOR_JOBS_SCENE_OPTIONS_H_

#include <functional>
#include <string>

#include "coordinator/jobs/job_pipeline.h"
#include "coordinator/report/water_choice.h"
#include "coordinator/waves/scene_waves.h"

namespace tilemend {

// Precondition of all: CheckJob(spec).ok().
// All cells are chosen.
WaveOptions WaveOptionsOf(const JobSpec& spec, WaterOptions water, std::function<bool()> is_cancelled);

// What makes two jobs write the same bytes, but for decisions on holes. The files of water and of the area count by
// their content.
std::string SceneKey(const JobSpec& spec, const WaterChoice& water, const std::string& area_digest);

// The same with the decisions, by the content of their file.
std::string JobKey(const JobSpec& spec, const WaterChoice& water, const std::string& area_digest);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_JOBS_SCENE_OPTIONS_H_
