// By what a worker shows that it sees a scene and its output.
#ifndef TILEMEND_COORDINATOR_JOBS_SCENE_FOLDERS_H_
#define TILEMEND_COORDINATOR_JOBS_SCENE_FOLDERS_H_

#include "absl/status/statusor.h"
#include "common/grid/scene.h"
#include "coordinator/jobs/job_folders.h"
#include "coordinator/store/attempt_folder.h"

namespace tilemend {

// The key of the attempts (null: nothing is written), scene.json, and the first, middle and last tile. Files of the
// scene that this machine cannot read are left to the survey. Errors of reading the key.
absl::StatusOr<JobFolders> FoldersOf(const Scene& scene, const AttemptFolder* attempts);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_JOBS_SCENE_FOLDERS_H_
