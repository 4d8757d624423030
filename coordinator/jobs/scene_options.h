// What a job's spec asks of the waves, of the workers, and what of it the report says.
#ifndef TILEMEND_COORDINATOR_JOBS_SCENE_OPTIONS_H_
#define TILEMEND_COORDINATOR_JOBS_SCENE_OPTIONS_H_

#include <functional>
#include <string>
#include <vector>

#include "coordinator/jobs/job_pipeline.h"
#include "coordinator/report/scene_report.h"
#include "coordinator/report/water_choice.h"
#include "coordinator/waves/scene_waves.h"
#include "tilemend/v1/stages.pb.h"

namespace tilemend {

// Precondition of all: spec.Check().ok().
// All cells are chosen.
WaveOptions WaveOptionsOf(const JobSpec& spec, WaterOptions water, std::function<bool()> is_cancelled);
WangOptions WangOptionsOf(const JobSpec& spec);
v1::ShapeOptions ShapeOptionsOf(const JobSpec& spec);

// What the result depends on beside the scene, under the names of the flags.
std::vector<ReportedOption> OptionsOf(const JobSpec& spec);

// What makes two jobs write the same bytes. The files of water and of the area count by their content.
std::string JobKey(const JobSpec& spec, const WaterChoice& water, const std::string& area_digest);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_JOBS_SCENE_OPTIONS_H_
