// Jobs that add their cells to the output of earlier ones.
#ifndef TILEMEND_COORDINATOR_JOBS_OUTPUT_CELLS_H_
#define TILEMEND_COORDINATOR_JOBS_OUTPUT_CELLS_H_

#include <map>
#include <string>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/grid/scene.h"
#include "coordinator/jobs/job_pipeline.h"

namespace tilemend {

// What makes two jobs write the same bytes: "scene", the options by their flags, and the digests of the files that
// "water", "clear", "area" and "decisions" name, as "water file".
using JobIdentity = std::map<std::string, std::string>;
// Without the files.
JobIdentity IdentityOf(const JobSpec& spec);
// Nothing for an empty digest: there is no file.
void AddFileDigest(const std::string& option, const std::string& digest, JobIdentity& identity);
// By the names of the options.
std::map<std::string, std::string> FileDigestsOf(const JobIdentity& identity);

// One line for each entry, and back. Lines of another form are left out.
std::string JobKey(const JobIdentity& identity);
JobIdentity IdentityOfKey(const std::string& key);

// An output holds the cells of all jobs that wrote there, if their scene and options were the same but for `cells`. A
// job adds its own to those:
//  - `adds`: it may write among the files that are there, and must leave each as it is.
//  - `cells`: those that the output has then, as --cells takes them; "" for all. If the last job did not end, its cells
//    count as well.
struct OutputCells {
  bool adds = false;
  std::string cells;
};

// What a job finds in its folder, without a lock on it. kAlreadyExists with OUTPUT_EXISTS if there is a complete output
// that has its cells, or one of another scene or other options, which the message names. For a job that overwrites or
// applies decisions (earlier_output.h): the output's cells, if it has those of the job. For a dry run, and a folder
// without an output of this program: nothing to add to.
// Errors of ChooseCells.
absl::StatusOr<OutputCells> CellsWithOutput(const JobSpec& spec, const JobIdentity& identity, const Scene& scene);

// The same error as far as it can be told by the spec alone, before the job starts.
absl::Status CheckOutputTakes(const JobSpec& spec);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_JOBS_OUTPUT_CELLS_H_
