// The line that a job of a scene ends with.
#ifndef TILEMEND_COORDINATOR_JOBS_END_MESSAGE_H_
#define TILEMEND_COORDINATOR_JOBS_END_MESSAGE_H_

#include <cstdint>
#include <string>

#include "coordinator/jobs/job_pipeline.h"
#include "coordinator/report/scene_report.h"

namespace tilemend {

// "30 of 32 holes filled; the report lists what is left open", of the cells that were chosen, and what was taken over
// from an earlier run. A dry run says what would be done.
//
//   without_worker  results among SceneReportInput::taken_over that took no task of a worker
std::string EndMessage(const JobSpec& spec, const SceneReportInput& report, int64_t without_worker);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_JOBS_END_MESSAGE_H_
