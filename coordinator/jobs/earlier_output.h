// The output of an earlier job, to which cells are added, or a reviewer's decisions applied.
#ifndef TILEMEND_COORDINATOR_JOBS_EARLIER_OUTPUT_H_
#define TILEMEND_COORDINATOR_JOBS_EARLIER_OUTPUT_H_

#include <string>

#include "absl/status/statusor.h"
#include "coordinator/jobs/job_pipeline.h"
#include "coordinator/jobs/output_cells.h"
#include "coordinator/report/water_choice.h"

namespace tilemend {

// What report.json keeps of the JobKey (output_cells.h) of a job without its decisions: its SHA-256, hex.
std::string OutputKey(const std::string& scene_key);

// Whether the job may replace files of a complete output in its folder: with `overwrite`; with decisions also if the
// output is of the same scene and options, as its report's `key` says. kAlreadyExists (OUTPUT_EXISTS) for decisions on
// the output of another scene or other options. Cost: reads the report if there are decisions.
absl::StatusOr<bool> MayReplace(const JobSpec& spec, const std::string& key);

// Adds the warning "decisions.geojson: the decisions of the last run on 4 holes are undone" if the spec names
// decisions, and `water` has fewer than the report in the output folder has decided holes; another if it has some.
// Cost: reads the report.
void WarnOfUndoneDecisions(const JobSpec& spec, WaterChoice& water);

// A job with the cells that its output has then.
struct JobOnOutput {
  JobSpec spec;
  JobIdentity identity;
  std::string key;  // of its report
  bool adds = false;
};

// `water` and `area_digest` tell of the files that the spec names. Errors of CellsWithOutput.
absl::StatusOr<JobOnOutput> OnOutput(const JobSpec& spec, const WaterChoice& water, const std::string& area_digest,
                                     const Scene& scene);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_JOBS_EARLIER_OUTPUT_H_
