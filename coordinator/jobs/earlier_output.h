// The output of an earlier job, to which cells are added, or a reviewer's decisions applied.
#ifndef TILEMEND_COORDINATOR_JOBS_EARLIER_OUTPUT_H_
#define TILEMEND_COORDINATOR_JOBS_EARLIER_OUTPUT_H_

#include <cstdint>
#include <map>
#include <set>
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

// A job with the cells that its output has then.
struct JobOnOutput {
  JobSpec spec;
  JobIdentity identity;
  std::string key;  // of its report
  bool adds = false;
  std::set<int32_t> decided_before = {};  // holes of the output that its report has decisions on; for new decisions
};

// `water` and `area_digest` tell of the files that the spec names. Errors of CellsWithOutput.
absl::StatusOr<JobOnOutput> OnOutput(const JobSpec& spec, const WaterChoice& water, const std::string& area_digest,
                                     const Scene& scene);

// "decisions.geojson: the decisions of the last run on 2 holes are undone, as the file has none on them: holes 3, 4";
// "" if `decisions`, those of the plan, are on all of JobOnOutput::decided_before.
std::string UndoneDecisions(const JobOnOutput& job, const std::map<int32_t, int32_t>& decisions);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_JOBS_EARLIER_OUTPUT_H_
